package org.hdispatch.sph;

import java.util.Arrays;

/** What a worker needs for one cell. */
public final class SphScratch {
  final Neighbourhood near = new Neighbourhood();
  final NeighbourList list = new NeighbourList();
  final PairSums sums;
  final PairForceSums pairs; // null: none
  double[] density = new double[0];
  double[] forceX = new double[0];
  double[] forceY = new double[0];
  double[] forceZ = new double[0];
  double[] share = new double[0]; // of the acceleration, that walls leave
  final double[] acceleration = new double[3];

  // particles picked for a cell: slot and index of each, and the bin it goes to
  int[] slots = new int[0];
  int[] indices = new int[0];
  int[] bins = new int[0];
  int picked;
  final int[] binStarts;

  SphScratch(PairSums sums, PairForceSums pairs, int bins) {
    this.sums = sums;
    this.pairs = pairs;
    binStarts = new int[bins + 1];
  }

  void makeRoom(int particles) {
    if (density.length < particles) {
      int room = ParticleArrays.roomFor(particles);
      density = new double[room];
      forceX = new double[room];
      forceY = new double[room];
      forceZ = new double[room];
      share = new double[room];
    }
  }

  void pick(int slot, int index, int bin) {
    if (picked == slots.length) {
      int room = ParticleArrays.roomFor(picked + picked / 4);
      slots = Arrays.copyOf(slots, room);
      indices = Arrays.copyOf(indices, room);
      bins = Arrays.copyOf(bins, room);
    }
    slots[picked] = slot;
    indices[picked] = index;
    bins[picked++] = bin;
  }
}
