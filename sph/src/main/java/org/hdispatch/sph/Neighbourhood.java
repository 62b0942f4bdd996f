package org.hdispatch.sph;

import java.util.Arrays;

/**
 * The particles within reach of a cell, gathered side by side in a worker's scratch: its own and
 * those of the cells around it, in a fixed order, periodic images where they are seen.
 *
 * <p>One plane a quantity, {@link #stride} apart. Four particles next to each other in the planes
 * are a <em>quad</em>: the unit in which neighbours are listed and sums are taken. The last quad is
 * filled up with particles out of everybody's reach.
 */
public final class Neighbourhood {
  /** Particles in a quad. Sums over neighbours keep so many partial sums, on every JVM. */
  public static final int LANES = 4;

  /** Most particles in a neighbourhood: quads are numbered by two bytes. */
  public static final int MOST = LANES << Character.SIZE;

  /** Planes of the position. */
  public static final int X = 0;

  /** Plane of y. */
  public static final int Y = 1;

  /** Plane of z. */
  public static final int Z = 2;

  /** Planes of the velocity that forces see. */
  public static final int UX = 3;

  /** Plane of the velocity along y. */
  public static final int UY = 4;

  /** Plane of the velocity along z. */
  public static final int UZ = 5;

  /** Plane of 1/n. */
  public static final int VOLUME = 6;

  /** Plane of P/n^2. */
  public static final int PRESSURE = 7;

  /**
   * Plane of the dynamic viscosity, or of its inverse for harmonic means; 0: of {@link
   * Phase#TOUCHED}.
   */
  public static final int VISCOSITY = 8;

  /** Plane of the depth in the wall, 0 in a fluid. */
  public static final int DEPTH = 9;

  /** Plane of the number of the phase. */
  public static final int PHASE = 10;

  /** A place that nobody reaches, whose square is finite. */
  private static final double FAR = 1e30;

  private static final int PLANES = 11;

  private double[] values = new double[0];
  private int stride;
  private int count;
  private int own;
  private int ownCount;
  private int ownFluids;
  private double[] nearness = new double[0];

  /** An empty neighbourhood. */
  Neighbourhood() {}

  /**
   * A neighbourhood of given particles, for sums apart from a scheme.
   *
   * @param planes what the planes hold, in their order, as many as are needed; of equal length
   * @param own which particle is the first of the cell's own
   * @param ownCount how many they are
   * @param nearness 1/d of those of them that are fluid, which come first
   */
  public static Neighbourhood of(double[][] planes, int own, int ownCount, double[] nearness) {
    Neighbourhood near = new Neighbourhood();
    int all = planes[X].length;
    near.clear(all);
    near.count = own;
    near.ownFollow(ownCount, nearness.length);
    System.arraycopy(nearness, 0, near.nearness, 0, nearness.length);
    near.count = all;
    for (int plane = 0; plane < planes.length; plane++) {
      near.copyLast(plane, planes[plane], all);
    }
    near.close(planes.length);
    return near;
  }

  /** The planes, one after the other. */
  public double[] values() {
    return values;
  }

  /** Distance from a plane to the next. */
  public int stride() {
    return stride;
  }

  /** Particles gathered. */
  public int count() {
    return count;
  }

  /** Where the cell's own particles begin in each plane. */
  public int own() {
    return own;
  }

  /** How many they are. */
  public int ownCount() {
    return ownCount;
  }

  /** How many of them are fluid; these come first. */
  public int ownFluids() {
    return ownFluids;
  }

  /** 1/d of the cell's own fluid particles, d being the distance from the wall. */
  public double[] nearness() {
    return nearness;
  }

  /** Quads that hold all particles. */
  public int quads() {
    return (count + LANES - 1) / LANES;
  }

  /** Makes it empty, with room for so many particles. */
  void clear(int room) {
    count = 0;
    own = 0;
    ownCount = 0;
    ownFluids = 0;
    if (room > MOST) {
      throw BlownUp.crowded(room);
    }
    if (room + LANES > stride) {
      // not a multiple of a page, or the planes would fight for the same lines of the cache
      stride = (room + room / 4 + 64) / 64 * 64 + 24;
      values = new double[PLANES * stride];
    }
  }

  /** Says that the particles appended next are the cell's own. */
  void ownFollow(int particles, int fluids) {
    own = count;
    ownCount = particles;
    ownFluids = fluids;
    if (nearness.length < fluids) {
      nearness = new double[fluids + fluids / 4];
    }
  }

  /** Appends positions, seen from a cell to which they appear shifted. */
  void addPositions(ParticleArrays from, int length, double dx, double dy, double dz) {
    shifted(from.x, dx, X * stride + count, length);
    shifted(from.y, dy, Y * stride + count, length);
    shifted(from.z, dz, Z * stride + count, length);
    count += length;
  }

  private void shifted(double[] from, double shift, int at, int length) {
    if (shift == 0) {
      System.arraycopy(from, 0, values, at, length);
      return;
    }
    double[] to = values;
    for (int n = 0; n < length; n++) {
      to[at + n] = from[n] + shift;
    }
  }

  /** Copies a quantity of the particles appended last. */
  void copyLast(int plane, double[] from, int length) {
    System.arraycopy(from, 0, values, plane * stride + count - length, length);
  }

  /** Sets a quantity of the particles appended last by their phase. */
  void phasesLast(int plane, byte[] phases, double[] ofPhase, int length) {
    int at = plane * stride + count - length;
    for (int n = 0; n < length; n++) {
      values[at + n] = ofPhase[phases[n]];
    }
  }

  /** Sets a quantity of the particles appended last to 0. */
  void clearLast(int plane, int length) {
    int end = plane * stride + count;
    Arrays.fill(values, end - length, end, 0);
  }

  /** Fills the last quad up. */
  void close(int planes) {
    int end = quads() * LANES;
    for (int plane = 0; plane < planes; plane++) {
      int at = plane * stride;
      Arrays.fill(values, at + count, at + end, plane == X ? FAR : 0);
    }
  }
}
