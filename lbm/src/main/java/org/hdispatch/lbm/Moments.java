package org.hdispatch.lbm;

import java.util.Arrays;

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

  /** Puts the nodes of a bundle at rest, halfway through the force: each has the same numbers. */
  void rest(NodalBundle bundle, LbmScheme.Scratch scratch, BodyForce force) {
    for (int i = 0; i < set.size(); i++) {
      Arrays.fill(scratch.chunk.wide[set.opposite(i)], leaving(i, 1, 0, 0, 0, force));
    }
    scratch.chunk.narrow(ChunkRows.NODES);
    scratch.cursor.begin(bundle.plan());
    while (scratch.cursor.next()) {
      scratch.cursor.write(phase.previous(), phase.streamed(), scratch.chunk);
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
    NodeRows nodes = scratch.nodes;
    nodes.begin();
    cursor.begin(bundle.plan());
    while (cursor.next()) {
      cursor.read(phase.previous(), phase.streamed(), scratch.chunk);
      scratch.chunk.widen(cursor.nodes());
      nodes.locate(bundle, cursor);
      nodes.ask(cursor.nodes(), change);
      nodes.addTo(scratch.chunk.wide, cursor.nodes(), set);
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
    NodeRows nodes = scratch.nodes;
    nodes.begin();
    cursor.begin(bundle.plan());
    while (cursor.next()) {
      cursor.read(phase.previous(), phase.streamed(), scratch.chunk);
      scratch.chunk.widen(cursor.nodes());
      nodes.locate(bundle, cursor);
      nodes.sumMomentum(scratch.chunk.wide, cursor.nodes(), set, force);
      nodes.show(cursor.nodes(), visitor);
    }
  }

  /** Visits the nodes of a bundle with the mass flux through each. */
  void forEachFlux(NodalBundle bundle, LbmScheme.Scratch scratch, LbmScheme.NodeVisitor visitor) {
    ChunkCursor cursor = scratch.cursor;
    NodeRows nodes = scratch.nodes;
    nodes.begin();
    cursor.begin(bundle.plan());
    while (cursor.next()) {
      cursor.read(phase.previous(), phase.streamed(), scratch.chunk);
      scratch.chunk.widen(cursor.nodes());
      cursor.read(phase.previous(), phase.readsNeighbours(), scratch.arriving);
      scratch.arriving.widen(cursor.nodes());
      bundle.faceLinks().arrive(phase.previous(), cursor, scratch.arriving.wide);
      nodes.locate(bundle, cursor);
      nodes.sumFlux(scratch.chunk.wide, scratch.arriving.wide, cursor.nodes(), set);
      nodes.show(cursor.nodes(), visitor);
    }
  }
}
