package org.hdispatch.porous.flow;

import java.util.function.IntConsumer;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.porous.image.Axis;

/**
 * The profile K of laminar flow through the pores, laplacian K = -1 with K = 0 on the walls, as far
 * as the chords through a node tell: 1/K = sum over the axes of 2/(a b), a and b being the
 * distances to the walls ahead and behind.
 *
 * <p>In a slit of any direction, an elliptic tube and an ellipsoid that is the solution itself.
 * There K = (1 - Q)/(2 trace A) with the walls at Q = x.Ax = 1, and a b = (1 - Q)/A_ii along axis
 * i; the trace does not change when the axes turn. In the middle of a square duct it is 15 % too
 * small.
 *
 * <p>Each line of nodes is walked by one worker, so every bit is the same for any number of them.
 */
final class ChordProfile {
  private static final double SOLID = -1; // in place of a sum

  private final FlowDomain domain;
  private final Lattice lattice;
  private final int layer; // nodes of an xy layer
  private final double most; // where no line meets a wall: that of a slit as wide as the lattice
  private final double[] profile; // at first the sum of 2/(a b)

  private ChordProfile(FlowDomain domain, double[] profile) {
    this.domain = domain;
    this.profile = profile;
    lattice = domain.lattice();
    layer = lattice.nx() * lattice.ny();
    double widest = Math.max(lattice.nx(), Math.max(lattice.ny(), lattice.nz()));
    most = widest * widest / 8;
  }

  /**
   * Finds the profile.
   *
   * @param profile by node, x fastest; what it holds on return, voxel², 0 in the solid
   */
  static void find(Dispatcher dispatcher, FlowDomain domain, double[] profile) {
    ChordProfile chords = new ChordProfile(domain, profile);
    each(dispatcher, chords.lattice.nz(), chords::walkLayer);
    each(dispatcher, chords.lattice.ny(), chords::walkUpright);
  }

  /** Lets workers walk sheets of nodes, numbered from 0. */
  private static void each(Dispatcher dispatcher, int count, IntConsumer walk) {
    CellGrid numbers = CellGrid.of(count, 1, 1, Ends.OPEN);
    CellMap<Integer> sheets = CellMap.fixed(numbers.keys(), KeyOrder.MORTON, CellKey::i);
    dispatcher
        .loop(Scheme.of(sheets).pass("profile", (sheet, none, tick) -> walk.accept(sheet)).build())
        .run(1);
  }

  /** The lines along x and y of a layer. */
  private void walkLayer(int z) {
    int first = z * layer;
    for (int y = 0; y < lattice.ny(); y++) {
      for (int x = 0; x < lattice.nx(); x++) {
        profile[first + x + lattice.nx() * y] = lattice.nodes().fluid(x, y, z) ? 0 : SOLID;
      }
    }
    for (int y = 0; y < lattice.ny(); y++) {
      walk(first + lattice.nx() * y, Axis.X);
    }
    for (int x = 0; x < lattice.nx(); x++) {
      walk(first + x, Axis.Y);
    }
  }

  /** The lines along z above a row; then the profile is known. */
  private void walkUpright(int y) {
    int row = y * lattice.nx();
    for (int x = 0; x < lattice.nx(); x++) {
      walk(row + x, Axis.Z);
    }
    for (int z = 0; z < lattice.nz(); z++) {
      for (int n = row + z * layer; n < row + z * layer + lattice.nx(); n++) {
        profile[n] = profile[n] == SOLID ? 0 : profile[n] > 0 ? 1 / profile[n] : most;
      }
    }
  }

  /** Adds the chords of one line of nodes. */
  private void walk(int first, Axis along) {
    int length = along.length(lattice.nx(), lattice.ny(), lattice.nz());
    int stride = along == Axis.X ? 1 : along == Axis.Y ? lattice.nx() : layer;
    boolean walled = domain.isWalled(along.ordinal());
    boolean round = ends(along) == Ends.PERIODIC;
    int lead = 0; // fluid nodes at the beginning
    while (lead < length && profile[first + lead * stride] != SOLID) {
      lead++;
    }
    if (lead == length) {
      if (walled) {
        addChord(first, stride, 0, length, 0, 0);
      }
      return;
    }
    int trail = 0; // at the end
    while (profile[first + (length - 1 - trail) * stride] != SOLID) {
      trail++;
    }
    int end;
    for (int start = 0; start < length; start = end + 1) {
      end = start;
      while (end < length && profile[first + end * stride] != SOLID) {
        end++;
      }
      int before = start > 0 || walled ? 0 : round ? trail : lead;
      int behind = end < length || walled ? 0 : round ? lead : trail;
      addChord(first, stride, start, end, before, behind);
    }
  }

  private Ends ends(Axis along) {
    return along == Axis.X ? lattice.x() : along == Axis.Y ? lattice.y() : lattice.z();
  }

  /** Adds a chord to its nodes; before and behind them it goes on for so many more. */
  private void addChord(int first, int stride, int start, int end, int before, int behind) {
    for (int n = start; n < end; n++) {
      double ahead = end - n - 0.5 + behind;
      double back = n - start + 0.5 + before;
      profile[first + n * stride] += 2 / (ahead * back);
    }
  }
}
