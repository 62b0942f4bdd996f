package org.hdispatch.porous.darcy;

/**
 * A column of a permeability tensor: what flows in all three directions while a pressure gradient
 * acts along one, q = -K/mu grad p. Units: voxel².
 *
 * @param x entry in the row of x
 * @param y entry in the row of y
 * @param z entry in the row of z
 */
public record PermeabilityColumn(double x, double y, double z) {
  /** The column of an axis along which nothing percolates. */
  public static final PermeabilityColumn ZERO = new PermeabilityColumn(0, 0, 0);

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if one is infinite or not a number
   */
  public PermeabilityColumn {
    if (!Double.isFinite(x) || !Double.isFinite(y) || !Double.isFinite(z)) {
      throw new IllegalArgumentException(
          "column of a permeability must be finite: x="
              + x
              + " voxel², y="
              + y
              + " voxel², z="
              + z
              + " voxel²");
    }
  }

  /**
   * The entry in a row.
   *
   * @param row 0, 1, 2 for x, y, z
   */
  public double entry(int row) {
    return row == 0 ? x : row == 1 ? y : z;
  }
}
