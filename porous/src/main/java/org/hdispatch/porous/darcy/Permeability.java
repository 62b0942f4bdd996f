package org.hdispatch.porous.darcy;

import java.util.OptionalDouble;

/**
 * A permeability, in voxel² and, if the voxel edge is known, in m² and mD.
 *
 * @param voxel2 k / edge²
 * @param voxelEdge edge of a voxel, m; empty if unknown
 */
public record Permeability(double voxel2, OptionalDouble voxelEdge) {
  /** One darcy in m². */
  public static final double DARCY = 9.869233e-13;

  private static final double LEAST_EDGE = 1e-15;
  private static final double MOST_EDGE = 1e3;

  /**
   * Checks the number.
   *
   * @throws IllegalArgumentException if {@code voxel2} is not finite or the edge not between 1e-15
   *     and 1e3 m
   */
  public Permeability {
    if (!Double.isFinite(voxel2)) {
      throw new IllegalArgumentException("permeability must be finite: k=" + voxel2 + " voxel²");
    }
    double edge = voxelEdge.orElse(1);
    if (!(edge >= LEAST_EDGE && edge <= MOST_EDGE)) {
      throw new IllegalArgumentException(
          "voxel edge must be positive, from 1e-15 to 1e3 m: edge=" + edge + " m");
    }
  }

  /** Permeability in m², if the voxel edge is known. */
  public OptionalDouble squareMetres() {
    return voxelEdge.isEmpty()
        ? OptionalDouble.empty()
        : OptionalDouble.of(voxel2 * voxelEdge.getAsDouble() * voxelEdge.getAsDouble());
  }

  /** Permeability in millidarcy, if the voxel edge is known. */
  public OptionalDouble milliDarcy() {
    OptionalDouble k = squareMetres();
    return k.isEmpty() ? k : OptionalDouble.of(k.getAsDouble() / DARCY * 1e3);
  }
}
