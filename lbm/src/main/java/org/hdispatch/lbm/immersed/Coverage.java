package org.hdispatch.lbm.immersed;

import java.util.Arrays;

/**
 * A solid given by its fraction in each cell of a box of cells: a grey-scale image. Order {@code x
 * + nx (y + ny z)}; the centre is that of the box. For bodies that stay where they are, with cells
 * that coincide with those of the lattice: a fraction between cells is that of the nearest, of two
 * as near that of the upper one, so that images side by side share no cell.
 */
public final class Coverage implements Shape {
  private final int nx;
  private final int ny;
  private final int nz;
  private final float[] fractions;

  private Coverage(int nx, int ny, int nz, float[] fractions) {
    if (nx < 1 || ny < 1 || nz < 1 || (long) nx * ny * nz != fractions.length) {
      throw new IllegalArgumentException(
          "coverage must have one number a cell: nx="
              + nx
              + ", ny="
              + ny
              + ", nz="
              + nz
              + ", numbers="
              + fractions.length);
    }
    this.nx = nx;
    this.ny = ny;
    this.nz = nz;
    this.fractions = fractions;
  }

  /**
   * Takes solid fractions as they are.
   *
   * @param fractions 0 to 1; copied
   * @throws IllegalArgumentException if there is not one number a cell, or one not within 0 to 1
   */
  public static Coverage of(int nx, int ny, int nz, float[] fractions) {
    for (int n = 0; n < fractions.length; n++) {
      if (!(fractions[n] >= 0 && fractions[n] <= 1)) {
        throw new IllegalArgumentException(
            "solid fraction must lie within 0 to 1: fraction=" + fractions[n] + ", cell=" + n);
      }
    }
    return new Coverage(nx, ny, nz, fractions.clone());
  }

  /**
   * Turns grey values into solid fractions: linearly from 0 at that of the pore to 1 at that of the
   * solid, cut off beyond.
   *
   * @param grey unsigned bytes
   * @param pore grey value of pure pore, 0 to 255
   * @param solid grey value of pure solid; may be below that of the pore
   * @throws IllegalArgumentException if there is not one number a cell, or both values are equal
   */
  public static Coverage ofGrey(int nx, int ny, int nz, byte[] grey, int pore, int solid) {
    if (pore == solid) {
      throw new IllegalArgumentException(
          "grey values of pore and solid must differ: pore=" + pore + ", solid=" + solid);
    }
    float[] fractions = new float[grey.length];
    for (int n = 0; n < grey.length; n++) {
      float share = (float) ((grey[n] & 0xff) - pore) / (solid - pore);
      fractions[n] = Math.max(0, Math.min(1, share));
    }
    return new Coverage(nx, ny, nz, fractions);
  }

  @Override
  public double fraction(double x, double y, double z) {
    int i = (int) Math.floor(x + nx / 2.0);
    int j = (int) Math.floor(y + ny / 2.0);
    int k = (int) Math.floor(z + nz / 2.0);
    boolean within = i >= 0 && j >= 0 && k >= 0 && i < nx && j < ny && k < nz;
    return within ? fractions[i + nx * (j + ny * k)] : 0;
  }

  @Override
  public double reachX() {
    return nx / 2.0;
  }

  @Override
  public double reachY() {
    return ny / 2.0;
  }

  @Override
  public double reachZ() {
    return nz / 2.0;
  }

  @Override
  public double volume() {
    double sum = 0;
    for (float fraction : fractions) {
      sum += fraction;
    }
    return sum;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Coverage that
        && nx == that.nx
        && ny == that.ny
        && nz == that.nz
        && Arrays.equals(fractions, that.fractions);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(fractions);
  }
}
