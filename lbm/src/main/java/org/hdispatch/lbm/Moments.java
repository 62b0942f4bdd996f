package org.hdispatch.lbm;

import java.util.Arrays;
import org.hdispatch.cell.CellMap;

/** Density and velocity of the nodes: put into their populations, and taken from them. */
final class Moments {
  private final VelocitySet set;
  private final Equilibrium equilibrium;
  private final Phase phase;

  Moments(VelocitySet set, Equilibrium equilibrium, Phase phase) {
    this.set = set;
    this.equilibrium = equilibrium;
    this.phase = phase;
  }

  /**
   * Puts the nodes of all bundles at rest, halfway through the force: each has the same numbers.
   */
  void rest(CellMap<NodalBundle> bundles, LbmScheme.Scratch scratch, BodyForce force) {
    for (int i = 0; i < set.size(); i++) {
      Arrays.fill(scratch.chunk.wide[set.opposite(i)], leaving(i, 1, 0, 0, 0, force));
    }
    scratch.chunk.narrow(ChunkRows.NODES);
    for (int n = 0; n < bundles.size(); n++) {
      scratch.cursor.begin(bundles.cellAt(n).plan());
      while (scratch.cursor.next()) {
        scratch.cursor.write(phase.previous(), phase.streamed(), scratch.chunk);
      }
    }
  }

  /** What leaves a node along velocity i in equilibrium, half the force included. */
  private double leaving(int i, double density, double ux, double uy, double uz, BodyForce force) {
    double along = set.cx(i) * force.x() + set.cy(i) * force.y() + set.cz(i) * force.z();
    return equilibrium.deviation(set, i, density, ux, uy, uz) + set.weight(i) * 3 * along / 2;
  }

  /** Puts the nodes of a bundle into equilibrium, halfway through the force. */
  void initialise(
      NodalBundle bundle,
      LbmScheme.Scratch scratch,
      BodyForce force,
      LbmScheme.NodeState state,
      LbmScheme.InitialState initial) {
    ChunkCursor cursor = scratch.cursor;
    NodeRuns runs = bundle.runs();
    int run = 0;
    cursor.begin(bundle.plan());
    while (cursor.next()) {
      for (int k = 0; k < cursor.nodes(); k++) {
        run = runs.run(cursor.node(k), run);
        int place = runs.position(cursor.node(k), run);
        state.density = 1;
        state.ux = 0;
        state.uy = 0;
        state.uz = 0;
        initial.at(bundle.xAt(place), bundle.yAt(place), bundle.zAt(place), state);
        state.check(bundle.xAt(place), bundle.yAt(place), bundle.zAt(place));
        for (int i = 0; i < set.size(); i++) {
          scratch.chunk.wide[set.opposite(i)][k] =
              leaving(i, state.density, state.ux, state.uy, state.uz, force);
        }
      }
      scratch.chunk.narrow(cursor.nodes());
      cursor.write(phase.previous(), phase.streamed(), scratch.chunk);
    }
  }

  /** Adds density and momentum to the nodes of a bundle. */
  void add(NodalBundle bundle, LbmScheme.Scratch scratch, LbmScheme.NodeChange change) {
    ChunkCursor cursor = scratch.cursor;
    LbmScheme.NodeState state = scratch.state;
    NodeRuns runs = bundle.runs();
    int run = 0;
    cursor.begin(bundle.plan());
    while (cursor.next()) {
      cursor.read(phase.previous(), phase.streamed(), scratch.chunk);
      scratch.chunk.widen(cursor.nodes());
      for (int k = 0; k < cursor.nodes(); k++) {
        run = runs.run(cursor.node(k), run);
        int place = runs.position(cursor.node(k), run);
        state.density = 0;
        state.ux = 0;
        state.uy = 0;
        state.uz = 0;
        change.at(bundle.xAt(place), bundle.yAt(place), bundle.zAt(place), state);
        for (int i = 0; i < set.size(); i++) {
          double along = set.cx(i) * state.ux + set.cy(i) * state.uy + set.cz(i) * state.uz;
          scratch.chunk.wide[set.opposite(i)][k] += set.weight(i) * (state.density + 3 * along);
        }
      }
      scratch.chunk.narrow(cursor.nodes());
      cursor.write(phase.previous(), phase.streamed(), scratch.chunk);
    }
  }

  /** Visits the nodes of a bundle; the force is that of the step that made the populations. */
  void forEachNode(
      NodalBundle bundle,
      LbmScheme.Scratch scratch,
      BodyForce force,
      LbmScheme.NodeVisitor visitor) {
    ChunkCursor cursor = scratch.cursor;
    NodeRuns runs = bundle.runs();
    int run = 0;
    cursor.begin(bundle.plan());
    while (cursor.next()) {
      cursor.read(phase.previous(), phase.streamed(), scratch.chunk);
      scratch.chunk.widen(cursor.nodes());
      for (int k = 0; k < cursor.nodes(); k++) {
        run = runs.run(cursor.node(k), run);
        int place = runs.position(cursor.node(k), run);
        visit(bundle, place, scratch.chunk.wide, k, force, visitor);
      }
    }
  }

  /** Row i holds what left the node against velocity i. */
  private void visit(
      NodalBundle bundle,
      int place,
      double[][] rows,
      int k,
      BodyForce force,
      LbmScheme.NodeVisitor visitor) {
    double d = rows[0][k];
    double jx = -force.x() / 2;
    double jy = -force.y() / 2;
    double jz = -force.z() / 2;
    for (int i = 1; i < rows.length; i += 2) {
      double a = rows[i + 1][k] - rows[i][k];
      d += rows[i + 1][k] + rows[i][k];
      jx += set.cx(i) * a;
      jy += set.cy(i) * a;
      jz += set.cz(i) * a;
    }
    visitor.visit(bundle.xAt(place), bundle.yAt(place), bundle.zAt(place), 1 + d, jx, jy, jz);
  }

  /** Visits the nodes of a bundle with the mass flux through each. */
  void forEachFlux(NodalBundle bundle, LbmScheme.Scratch scratch, LbmScheme.NodeVisitor visitor) {
    ChunkCursor cursor = scratch.cursor;
    NodeRuns runs = bundle.runs();
    int run = 0;
    cursor.begin(bundle.plan());
    while (cursor.next()) {
      cursor.read(phase.previous(), phase.streamed(), scratch.chunk);
      scratch.chunk.widen(cursor.nodes());
      cursor.read(phase.previous(), phase.readsNeighbours(), scratch.arriving);
      scratch.arriving.widen(cursor.nodes());
      bundle.faceLinks().arrive(phase.previous(), cursor, scratch.arriving.wide);
      for (int k = 0; k < cursor.nodes(); k++) {
        run = runs.run(cursor.node(k), run);
        int place = runs.position(cursor.node(k), run);
        flux(bundle, place, scratch, k, visitor);
      }
    }
  }

  /** What left the node and what arrives there next, row i against and along velocity i. */
  private void flux(
      NodalBundle bundle,
      int place,
      LbmScheme.Scratch scratch,
      int k,
      LbmScheme.NodeVisitor visitor) {
    double[][] left = scratch.chunk.wide;
    double[][] arriving = scratch.arriving.wide;
    double d = left[0][k];
    double jx = 0;
    double jy = 0;
    double jz = 0;
    for (int i = 1; i < left.length; i += 2) {
      double a = (left[i + 1][k] - left[i][k] + arriving[i][k] - arriving[i + 1][k]) / 2;
      d += left[i + 1][k] + left[i][k];
      jx += set.cx(i) * a;
      jy += set.cy(i) * a;
      jz += set.cz(i) * a;
    }
    visitor.visit(bundle.xAt(place), bundle.yAt(place), bundle.zAt(place), 1 + d, jx, jy, jz);
  }
}
