package org.hdispatch.lbm;

import java.util.stream.IntStream;

/**
 * A lattice: its velocities c_i and weights w_i, speed of sound squared 1/3 (Qian, d'Humières,
 * Lallemand, Europhysics Letters 17, 1992, 479).
 *
 * <p>Velocity 0 is rest; velocities 2p - 1 and 2p are opposite to each other, pair p = 1 to {@link
 * #pairs}.
 */
public enum VelocitySet {
  /** Rest, 6 faces, 8 corners of the cube. */
  D3Q15(2.0 / 9, 1.0 / 9, 0, 1.0 / 72),
  /** Rest, 6 faces, 12 edges of the cube. */
  D3Q19(1.0 / 3, 1.0 / 18, 1.0 / 36, 0);

  /** Speed of sound squared, in node spacings² per step². */
  public static final double SOUND_SPEED_SQUARED = 1.0 / 3;

  private final int[] cx;
  private final int[] cy;
  private final int[] cz;
  private final double[] weight;

  /** Weights by number of non-zero components of the velocity; a class of weight 0 is absent. */
  VelocitySet(double rest, double face, double edge, double corner) {
    double[] byLength = {rest, face, edge, corner};
    int size = 1 + 6 + (edge > 0 ? 12 : 0) + (corner > 0 ? 8 : 0);
    cx = new int[size];
    cy = new int[size];
    cz = new int[size];
    weight = new double[size];
    weight[0] = rest;
    int i = 1;
    for (int length = 1; length <= 3; length++) {
      for (int code = 26; code > 13; code--) { // half of the 26 neighbours; the others are opposite
        int x = code % 3 - 1;
        int y = code / 3 % 3 - 1;
        int z = code / 9 - 1;
        if (x * x + y * y + z * z == length && byLength[length] > 0) {
          put(i++, x, y, z, byLength[length]);
          put(i++, -x, -y, -z, byLength[length]);
        }
      }
    }
  }

  private void put(int i, int x, int y, int z, double w) {
    cx[i] = x;
    cy[i] = y;
    cz[i] = z;
    weight[i] = w;
  }

  /** Number of velocities, rest included. */
  public int size() {
    return weight.length;
  }

  /** Number of pairs of opposite velocities. */
  public int pairs() {
    return (weight.length - 1) / 2;
  }

  /** First component of velocity i: -1, 0 or 1. */
  public int cx(int i) {
    return cx[i];
  }

  /** Second component of velocity i: -1, 0 or 1. */
  public int cy(int i) {
    return cy[i];
  }

  /** Third component of velocity i: -1, 0 or 1. */
  public int cz(int i) {
    return cz[i];
  }

  /** Component of velocity i along an axis (0, 1, 2): -1, 0 or 1. */
  public int component(int i, int axis) {
    return axis == 0 ? cx[i] : axis == 1 ? cy[i] : cz[i];
  }

  /** The axes along which velocity i has a component other than 0, increasing. */
  public int[] axes(int i) {
    return IntStream.range(0, 3).filter(axis -> component(i, axis) != 0).toArray();
  }

  /** Weight of velocity i; all sum to 1. */
  public double weight(int i) {
    return weight[i];
  }

  /** Number of the velocity opposite to i. */
  public int opposite(int i) {
    return i == 0 ? 0 : (i - 1 ^ 1) + 1;
  }
}
