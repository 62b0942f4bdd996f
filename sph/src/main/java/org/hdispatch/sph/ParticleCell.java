package org.hdispatch.sph;

import java.util.Arrays;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;

/**
 * The particles of one cell of the box, fluid ones first, in two buffers; what has been found out
 * about them in this step; and the cells around.
 */
public final class ParticleCell {
  /** Cells around a cell, itself included: x fastest. */
  static final int SLOTS = 27;

  /** The cell itself among them. */
  static final int ITSELF = 13;

  /** Bytes of the header of an array: 16 on usual JVMs. */
  static final int HEADER = 16;

  /** Bytes of the fields here and of those of the buffers and the list: references of 4 bytes. */
  private static final int OWN_BYTES = 408;

  final ParticleArrays[] buffers = {new ParticleArrays(), new ParticleArrays()};
  final ParticleCell[] around = new ParticleCell[SLOTS]; // null: there is none
  final NeighbourList list = new NeighbourList();
  long key;
  int count;
  int fluids;

  /** 1/n of each particle. */
  double[] volume = new double[0];

  /** P/n^2 of each particle. */
  double[] pressure = new double[0];

  /** Depth in the wall of each particle, 0 in the fluid; empty without walls. */
  double[] depth = new double[0];

  /** Virial of the pairwise forces on each fluid particle; empty without such forces. */
  double[] virial = new double[0];

  /** Particles that have left the cell, ascending, and the slots they have gone to. */
  int[] leavers = new int[0];

  byte[] ways = new byte[0];
  int leaving;

  double fastestSquare;
  double leastCompression;
  double mostCompression;

  // wall time of the last step, ns
  long searchNanos;
  long densityNanos;
  long forceNanos;

  private long linked = -1; // revision of the cells when around was looked up

  ParticleCell(long key) {
    this.key = key;
  }

  /** Makes it the empty cell of another key. */
  void renew(long newKey) {
    key = newKey;
    count = 0;
    fluids = 0;
    leaving = 0;
    fastestSquare = 0;
    linked = -1;
  }

  /** Offset of a slot along an axis: -1, 0 or 1. */
  static int offset(int slot, int axis) {
    return (axis == 0 ? slot % 3 : axis == 1 ? slot / 3 % 3 : slot / 9) - 1;
  }

  /** Looks up the cells around, if the cells have changed since. */
  void link(CellMap<ParticleCell> cells, CellGrid grid) {
    if (linked == cells.revision()) {
      return;
    }
    for (int slot = 0; slot < SLOTS; slot++) {
      long there = neighbour(grid, slot);
      around[slot] = there == CellKey.NONE ? null : cells.get(there);
    }
    linked = cells.revision();
  }

  /** Key of the cell in a slot, {@link CellKey#NONE} beyond an open end. */
  long neighbour(CellGrid grid, int slot) {
    return grid.neighbour(key, offset(slot, 0), offset(slot, 1), offset(slot, 2));
  }

  /** Makes room for what is found out about so many particles. */
  void makeRoom(int particles, boolean walled) {
    if (volume.length < particles) {
      int room = ParticleArrays.roomFor(particles);
      volume = new double[room];
      pressure = new double[room];
      depth = walled ? new double[room] : depth;
    }
  }

  /** Makes room for the virial of each fluid particle. */
  void makeVirialRoom() {
    if (virial.length < fluids) {
      virial = new double[volume.length];
    }
  }

  /** Notes that a particle has left. */
  void addLeaver(int particle, int slot) {
    if (leaving == leavers.length) {
      int room = ParticleArrays.roomFor(leaving + count / 8);
      leavers = Arrays.copyOf(leavers, room);
      ways = Arrays.copyOf(ways, room);
    }
    leavers[leaving] = particle;
    ways[leaving++] = (byte) slot;
  }

  /** Bytes of all that it holds. */
  long bytes() {
    long arrays = buffers[0].bytes() + buffers[1].bytes() + list.bytes();
    arrays += HEADER + (long) Double.BYTES * volume.length;
    arrays += HEADER + (long) Double.BYTES * pressure.length;
    arrays += HEADER + (long) Double.BYTES * depth.length;
    arrays += HEADER + (long) Double.BYTES * virial.length;
    arrays += HEADER + (long) Integer.BYTES * leavers.length;
    arrays += HEADER + ways.length;
    return arrays + OWN_BYTES;
  }

  /** Key of the cell. */
  public long key() {
    return key;
  }

  /** Particles in it. */
  public int count() {
    return count;
  }
}
