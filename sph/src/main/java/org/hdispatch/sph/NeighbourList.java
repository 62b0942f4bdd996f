package org.hdispatch.sph;

/**
 * For each particle of a cell the quads of its {@link Neighbourhood} that hold a neighbour, in
 * order; two bytes a quad.
 */
public final class NeighbourList {
  /** Most quads that a neighbourhood may have. */
  static final int MOST_QUADS = 1 << Character.SIZE;

  private int[] first = new int[1];
  private char[] quads = new char[0];
  private int particles;

  /** An empty list. */
  public NeighbourList() {}

  /** Where the quads of a particle begin; by particle, and one more at the end. */
  public int[] first() {
    return first;
  }

  /** Numbers of quads, particle by particle. */
  public char[] quads() {
    return quads;
  }

  /** Makes it empty, for so many particles with so many quads at most each. */
  public void clear(int count, int most) {
    particles = count;
    if (first.length <= count) {
      first = new int[count + count / 4 + 1];
    }
    if (quads.length < count * most) {
      quads = new char[count * most + count * most / 4];
    }
    first[0] = 0;
  }

  /** Takes over another list, with no more room than it needs and some to grow. */
  void copy(NeighbourList other) {
    particles = other.particles;
    int length = other.first[particles];
    if (first.length <= particles) {
      first = new int[particles + particles / 8 + 1];
    }
    if (quads.length < length) {
      quads = new char[length + length / 4];
    }
    System.arraycopy(other.first, 0, first, 0, particles + 1);
    System.arraycopy(other.quads, 0, quads, 0, length);
  }

  /** Bytes of the arrays. */
  long bytes() {
    return 2L * ParticleCell.HEADER
        + (long) Integer.BYTES * first.length
        + (long) Character.BYTES * quads.length;
  }
}
