package org.hdispatch.porous.pore;

import java.util.Arrays;
import java.util.Locale;

/**
 * Equal solid spheres on a cubic lattice: the reference rock whose permeability is known (Zick
 * &amp; Homsy, J. Fluid Mech. 115, 1982).
 *
 * <p>One cubic cell of the lattice is the whole box, periodic on all sides. Voxel centres lie at
 * half-integers; a voxel is solid where its distance to the nearest centre, periodic images
 * included, is strictly less than the radius. The solid fraction is nominal: that of the spheres
 * themselves, which their voxels only approach.
 */
public enum SpherePacking {
  /** Simple cubic: one sphere per cell, in its middle. */
  SC(Math.PI / 6, new double[][] {{0.5, 0.5, 0.5}}),
  /** Body-centred cubic: two spheres per cell. */
  BCC(Math.PI * Math.sqrt(3) / 8, new double[][] {{0.5, 0.5, 0.5}, {0, 0, 0}}),
  /** Face-centred cubic: four spheres per cell. */
  FCC(
      Math.PI * Math.sqrt(2) / 6,
      new double[][] {{0.5, 0.5, 0.5}, {0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}});

  /** So much above close packing passes: tables print 0.5236 for pi/6 = 0.523599. */
  private static final double ROUNDING = 1e-5;

  private final double closePacking;
  private final double[][] centres;

  SpherePacking(double closePacking, double[][] centres) {
    this.closePacking = closePacking;
    this.centres = centres;
  }

  /** Centres of the spheres of one cell, in edges of the cell; a copy. */
  public double[][] centres() {
    return Arrays.stream(centres).map(double[]::clone).toArray(double[][]::new);
  }

  /**
   * Number of spheres per cubic cell.
   *
   * @return N: 1, 2 or 4
   */
  public int spheresPerCell() {
    return centres.length;
  }

  /**
   * Solid fraction at which neighbours touch: pi/6, pi sqrt(3)/8 or pi sqrt(2)/6.
   *
   * @return the largest solid fraction without overlap
   */
  public double closePacking() {
    return closePacking;
  }

  /**
   * Radius of the spheres: r = n (3 c / (4 pi N))^(1/3).
   *
   * @param size n, edge of the cell in voxels
   * @param solidFraction c, nominal
   * @return radius, in voxels
   * @throws IllegalArgumentException if the size is below 1, or the solid fraction outside (0, 1)
   *     or above close packing
   */
  public double radius(int size, double solidFraction) {
    if (size < 1) {
      throw new IllegalArgumentException("cell must be at least 1 voxel wide: size=" + size);
    }
    if (!(solidFraction > 0 && solidFraction < 1)) {
      throw new IllegalArgumentException(
          "solid fraction must be between 0 and 1: c=" + solidFraction);
    }
    if (solidFraction > closePacking * (1 + ROUNDING)) {
      throw new IllegalArgumentException(
          "spheres must not overlap (close packing of "
              + name().toLowerCase(Locale.ROOT)
              + "): c="
              + solidFraction
              + ", limit="
              + closePacking);
    }
    return size * StrictMath.cbrt(3 * solidFraction / (4 * Math.PI * spheresPerCell()));
  }

  /**
   * The pore space between the spheres.
   *
   * @param size n, edge of the cell in voxels
   * @param solidFraction c, nominal
   * @return a pore space of n x n x n voxels
   * @throws IllegalArgumentException if the size is below 1 or too large for one array, or the
   *     solid fraction outside (0, 1) or above close packing
   */
  public PoreSpace poreSpace(int size, double solidFraction) {
    double radius = radius(size, solidFraction);
    double radius2 = radius * radius;
    return PoreSpace.of(size, size, size, (x, y, z) -> !insideAnySphere(x, y, z, size, radius2));
  }

  private boolean insideAnySphere(int x, int y, int z, int size, double radius2) {
    for (double[] centre : centres) {
      double dx = toNearestImage(x, centre[0], size);
      double dy = toNearestImage(y, centre[1], size);
      double dz = toNearestImage(z, centre[2], size);
      if (dx * dx + dy * dy + dz * dz < radius2) {
        return true;
      }
    }
    return false;
  }

  /** Distance along one axis; exact, as all values are multiples of one half. */
  private static double toNearestImage(int voxel, double centre, int size) {
    double d = Math.abs(voxel + 0.5 - centre * size);
    return Math.min(d, size - d);
  }
}
