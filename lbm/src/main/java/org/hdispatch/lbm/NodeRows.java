package org.hdispatch.lbm;

import java.util.Arrays;

/**
 * Where the nodes of a chunk lie, and their density and velocity: part of a worker's scratch. Loops
 * over the nodes lie inside those over the velocities: they are compiled soon, and to vectors. Each
 * node's numbers are summed in the order of the velocities.
 */
final class NodeRows {
  private final int[] x = new int[ChunkRows.NODES];
  private final int[] y = new int[ChunkRows.NODES];
  private final int[] z = new int[ChunkRows.NODES];
  private final double[] density = new double[ChunkRows.NODES]; // less its mean, 1
  private final double[] ux = new double[ChunkRows.NODES];
  private final double[] uy = new double[ChunkRows.NODES];
  private final double[] uz = new double[ChunkRows.NODES];
  private final LbmScheme.NodeState state = new LbmScheme.NodeState();
  private int run; // of the bundle, in which the last node lies

  /** Stands before the first chunk of a bundle. */
  void begin() {
    run = 0;
  }

  /** Finds where the nodes of the next chunk lie. */
  void locate(NodalBundle bundle, ChunkCursor chunk) {
    NodeRuns runs = bundle.runs();
    for (int k = 0; k < chunk.nodes(); k++) {
      int node = chunk.node(k);
      run = runs.run(node, run);
      int position = runs.position(node, run);
      x[k] = bundle.xAt(position);
      y[k] = bundle.yAt(position);
      z[k] = bundle.zAt(position);
    }
  }

  /** Asks what to add to the first n nodes. */
  void ask(int n, LbmScheme.NodeChange change) {
    for (int k = 0; k < n; k++) {
      state.density = 0;
      state.ux = 0;
      state.uy = 0;
      state.uz = 0;
      change.at(x[k], y[k], z[k], state);
      density[k] = state.density;
      ux[k] = state.ux;
      uy[k] = state.uy;
      uz[k] = state.uz;
    }
  }

  /** Adds w_i (d + 3 c_i.u) to what left the first n nodes: along i, in the row opposite to it. */
  void addTo(double[][] left, int n, VelocitySet set) {
    for (int i = 0; i < left.length; i++) {
      addTo(left[set.opposite(i)], n, set.weight(i), set.cx(i), set.cy(i), set.cz(i));
    }
  }

  private void addTo(double[] row, int n, double weight, double cx, double cy, double cz) {
    for (int k = 0; k < n; k++) {
      double along = cx * ux[k] + cy * uy[k] + cz * uz[k];
      row[k] += weight * (density[k] + 3 * along);
    }
  }

  /**
   * Sums density and momentum of what left the first n nodes, less half the force.
   *
   * @param left row i holds what left against velocity i
   */
  void sumMomentum(double[][] left, int n, VelocitySet set, BodyForce force) {
    beginSums(left, n, -force.x() / 2, -force.y() / 2, -force.z() / 2);
    for (int i = 1; i < left.length; i += 2) {
      addMomentum(left[i + 1], left[i], n, set.cx(i), set.cy(i), set.cz(i));
    }
  }

  private void addMomentum(
      double[] along, double[] against, int n, double cx, double cy, double cz) {
    for (int k = 0; k < n; k++) {
      double momentum = along[k] - against[k];
      density[k] += along[k] + against[k];
      ux[k] += cx * momentum;
      uy[k] += cy * momentum;
      uz[k] += cz * momentum;
    }
  }

  /**
   * Sums density and mass flux of the first n nodes: the mean of the momentum of what left them and
   * of what arrives next.
   *
   * @param left row i holds what left against velocity i
   * @param arriving row i holds what arrives along it
   */
  void sumFlux(double[][] left, double[][] arriving, int n, VelocitySet set) {
    beginSums(left, n, 0, 0, 0);
    for (int i = 1; i < left.length; i += 2) {
      addDensity(left[i + 1], left[i], n);
      addFlux(left, arriving, i, n, set.cx(i), set.cy(i), set.cz(i));
    }
  }

  private void addDensity(double[] along, double[] against, int n) {
    for (int k = 0; k < n; k++) {
      density[k] += along[k] + against[k];
    }
  }

  private void addFlux(
      double[][] left, double[][] arriving, int i, int n, double cx, double cy, double cz) {
    double[] leftAlong = left[i + 1];
    double[] leftAgainst = left[i];
    double[] arrivingAlong = arriving[i];
    double[] arrivingAgainst = arriving[i + 1];
    for (int k = 0; k < n; k++) {
      double flux = (leftAlong[k] - leftAgainst[k] + arrivingAlong[k] - arrivingAgainst[k]) / 2;
      ux[k] += cx * flux;
      uy[k] += cy * flux;
      uz[k] += cz * flux;
    }
  }

  /** Begins sums with the populations at rest and a momentum. */
  private void beginSums(double[][] left, int n, double jx, double jy, double jz) {
    System.arraycopy(left[0], 0, density, 0, n);
    Arrays.fill(ux, 0, n, jx);
    Arrays.fill(uy, 0, n, jy);
    Arrays.fill(uz, 0, n, jz);
  }

  /** Shows the first n nodes. */
  void show(int n, LbmScheme.NodeVisitor visitor) {
    for (int k = 0; k < n; k++) {
      visitor.visit(x[k], y[k], z[k], 1 + density[k], ux[k], uy[k], uz[k]);
    }
  }
}
