package org.hdispatch.sph;

import java.util.Arrays;

/**
 * For each particle of a cell the quads of its {@link Neighbourhood} that hold a neighbour, in
 * order; two bytes a quad, as a neighbourhood has {@link Neighbourhood#MOST} particles at most.
 */
public final class NeighbourList {
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

  /** Makes it empty, for so many particles. */
  public void clear(int count) {
    particles = count;
    if (first.length <= count) {
      first = new int[count + count / 4 + 1];
    }
    first[0] = 0;
  }

  /** Makes room for so many quads of all particles; those here stay. */
  public void makeRoom(int length) {
    if (quads.length < length) {
      quads = Arrays.copyOf(quads, length + length / 4);
    }
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
