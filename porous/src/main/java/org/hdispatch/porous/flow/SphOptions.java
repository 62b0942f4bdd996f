package org.hdispatch.porous.flow;

import java.io.Serializable;

/**
 * How a steady flow is computed by smoothed particle hydrodynamics, beside {@link FlowOptions}: one
 * particle a voxel, at first at its centre.
 *
 * @param smoothingLength h of the quintic spline, voxels
 * @param wallFactor beta_max of the velocity in walls
 */
public record SphOptions(double smoothingLength, double wallFactor) implements Serializable {
  /** h = 1 voxel and beta_max = 4. */
  public static final SphOptions DEFAULT = new SphOptions(1, 4);

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if h is not between 1 and 2 voxels, or beta_max less than 1
   */
  public SphOptions {
    if (!(smoothingLength >= 1 && smoothingLength <= 2)) {
      throw new IllegalArgumentException(
          "smoothing length must be 1 to 2 voxels (particles lie one voxel apart): h="
              + smoothingLength);
    }
    if (!(wallFactor >= 1 && Double.isFinite(wallFactor))) {
      throw new IllegalArgumentException(
          "wall factor must be at least 1 (Morris et al. 1997): beta_max=" + wallFactor);
    }
  }
}
