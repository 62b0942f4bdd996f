package org.hdispatch.porous.pore;

import java.util.Random;

/**
 * Equal solid spheres at random places, which may overlap, in a box that is periodic on all sides:
 * the fully penetrable spheres of Torquato, Random Heterogeneous Materials (2002), section 5.1. Of
 * one seed, a tighter rock has all the spheres of a looser one, and more.
 *
 * <p>Voxel centres lie at integers; a voxel is solid where its distance to a centre, periodic
 * images included, is at most the radius.
 *
 * @param radius of the spheres, voxels
 * @param seed of the places
 */
public record RandomSpheres(double radius, long seed) {
  private static final double MOST = 1e4;

  /**
   * Checks the radius.
   *
   * @throws IllegalArgumentException if the radius is not 1 to 10 000 voxels
   */
  public RandomSpheres {
    if (!(radius >= 1 && radius <= MOST)) { // of less, a sphere may cover no voxel at all
      throw new IllegalArgumentException(
          "radius of the spheres must lie between 1 and 10000 voxels: radius=" + radius);
    }
  }

  /**
   * The pore space between so many spheres that just no more than the porosity is left.
   *
   * @param size n, edge of the box in voxels
   * @param porosity share of the voxels that may be pore
   * @return a pore space of n x n x n voxels; 0 to one sphere's volume below the porosity
   * @throws IllegalArgumentException if the size is below 1 or too large for one array, or the
   *     porosity not between 0 and 1
   */
  public PoreSpace poreSpace(int size, double porosity) {
    if (!(porosity > 0 && porosity < 1)) {
      throw new IllegalArgumentException("porosity must lie between 0 and 1: porosity=" + porosity);
    }
    PoreSpace all = PoreSpace.of(size, size, size, (x, y, z) -> true);
    byte[] flags = all.flags();
    Random random = new Random(seed);
    int pores = flags.length;
    while (pores > porosity * flags.length) {
      pores -=
          cover(
              flags,
              size,
              random.nextDouble() * size,
              random.nextDouble() * size,
              random.nextDouble() * size);
    }
    return new PoreSpace(size, size, size, flags);
  }

  /** Makes the voxels of a sphere solid, and returns how many were pore. */
  private int cover(byte[] flags, int size, double cx, double cy, double cz) {
    int covered = 0;
    for (int z = 0; z < size; z++) {
      double left = radius * radius - square(z - cz, size);
      for (int y = 0; left >= 0 && y < size; y++) {
        double leftInRow = left - square(y - cy, size);
        int row = size * (y + size * z);
        for (int x = 0; leftInRow >= 0 && x < size; x++) {
          if (flags[row + x] == PoreSpace.PORE && square(x - cx, size) <= leftInRow) {
            flags[row + x] = PoreSpace.SOLID;
            covered++;
          }
        }
      }
    }
    return covered;
  }

  /** Square of a distance along one axis to the nearest periodic image. */
  private static double square(double distance, int size) {
    double d = Math.IEEEremainder(distance, size);
    return d * d;
  }
}
