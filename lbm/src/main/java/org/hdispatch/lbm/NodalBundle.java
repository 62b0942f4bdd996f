package org.hdispatch.lbm;

import java.util.Arrays;

/**
 * The cell of the lattice Boltzmann method: the fluid nodes of a box of the lattice, with one or
 * two copies of their populations.
 *
 * <p>Only fluid nodes are stored, x fastest, then y, then z; in a bundle without solid nodes that
 * is the plain order {@code x + nx (y + ny z)}.
 */
public final class NodalBundle {
  private final long key;
  private final int x0;
  private final int y0;
  private final int z0;
  private final int nx;
  private final int ny;
  private final int nz;
  private final NodeRuns runs;
  private final Populations[] populations;
  private StreamPlan plan;
  private FaceLinks faceLinks = FaceLinks.NONE;

  /** Makes a bundle with all populations at rest. */
  NodalBundle(
      long key,
      int x0,
      int y0,
      int z0,
      BundleSize size,
      NodeRuns runs,
      VelocitySet set,
      Storage storage,
      Streaming streaming) {
    this.key = key;
    this.x0 = x0;
    this.y0 = y0;
    this.z0 = z0;
    nx = size.nx();
    ny = size.ny();
    nz = size.nz();
    this.runs = runs;
    populations = new Populations[streaming.copies()];
    Arrays.setAll(populations, copy -> Populations.of(storage, set, runs.nodes()));
  }

  void link(StreamPlan streamPlan) {
    plan = streamPlan;
  }

  void link(FaceLinks links) {
    faceLinks = links;
  }

  FaceLinks faceLinks() {
    return faceLinks;
  }

  StreamPlan plan() {
    return plan;
  }

  Populations populations(int copy) {
    return populations[copy];
  }

  NodeRuns runs() {
    return runs;
  }

  /** Key of this bundle: its coordinates among the bundles. */
  public long key() {
    return key;
  }

  /** Number of fluid nodes. */
  public int nodes() {
    return runs.nodes();
  }

  /** Position of a node within the box. */
  int position(int node) {
    return runs.position(node);
  }

  /** Where the box of this bundle begins in the lattice, along an axis: 0, 1 or 2. */
  public int first(int axis) {
    return axis == 0 ? x0 : axis == 1 ? y0 : z0;
  }

  /** Extent of the box along an axis; at the far end of the lattice it may reach beyond. */
  public int extent(int axis) {
    return axis == 0 ? nx : axis == 1 ? ny : nz;
  }

  /** First coordinate of a node in the lattice. */
  public int x(int node) {
    return xAt(position(node));
  }

  /** Second coordinate of a node in the lattice. */
  public int y(int node) {
    return yAt(position(node));
  }

  /** Third coordinate of a node in the lattice. */
  public int z(int node) {
    return zAt(position(node));
  }

  int xAt(int position) {
    return x0 + position % nx;
  }

  int yAt(int position) {
    return y0 + position / nx % ny;
  }

  int zAt(int position) {
    return z0 + position / (nx * ny);
  }

  /** Bytes held: populations, streaming plan, links through faces, places of the nodes. */
  public long bytes() {
    long bytes = plan.bytes() + faceLinks.bytes() + runs.bytes();
    for (Populations copy : populations) {
      bytes += copy.bytes();
    }
    return bytes;
  }
}
