package org.hdispatch.sph;

import java.util.Objects;
import org.hdispatch.cell.Ends;

/**
 * The box that the particles live in: [0, lx) x [0, ly) x [0, lz). In 2-D all z are 0.
 *
 * @param dimensions 2 or 3
 * @param lx length along x
 * @param ly length along y
 * @param lz length along z; 0 in 2-D
 * @param x what lies beyond the ends along x: the other end, or nothing, and no particle may go
 *     there
 * @param y what lies beyond the ends along y
 * @param z what lies beyond the ends along z
 */
public record ParticleBox(int dimensions, double lx, double ly, double lz, Ends x, Ends y, Ends z) {

  /**
   * Checks the lengths.
   *
   * @throws IllegalArgumentException if a length is not positive, or not 0 along z in 2-D
   */
  public ParticleBox {
    Objects.requireNonNull(x, "x");
    Objects.requireNonNull(y, "y");
    Objects.requireNonNull(z, "z");
    Checks.positive("length of the box", "lx", lx);
    Checks.positive("length of the box", "ly", ly);
    if (dimensions == 3) {
      Checks.positive("length of the box", "lz", lz);
    } else if (dimensions != 2 || lz != 0 || z != Ends.OPEN) {
      throw new IllegalArgumentException(
          "box must have 3 dimensions, or 2 and no length along z: dimensions="
              + dimensions
              + ", lz="
              + lz);
    }
  }

  /** A plane. */
  public static ParticleBox plane(double lx, double ly, Ends x, Ends y) {
    return new ParticleBox(2, lx, ly, 0, x, y, Ends.OPEN);
  }

  /** A box in space. */
  public static ParticleBox space(double lx, double ly, double lz, Ends x, Ends y, Ends z) {
    return new ParticleBox(3, lx, ly, lz, x, y, z);
  }

  /** Volume, or area in 2-D. */
  public double volume() {
    return dimensions == 2 ? lx * ly : lx * ly * lz;
  }
}
