package org.hdispatch.bench.paper;

import java.util.stream.LongStream;
import org.hdispatch.lbm.BundleSize;
import org.hdispatch.lbm.Lattice;

/**
 * A box of the lattice: a dictionary of its fluid nodes by their position {@code x + nx (y + ny
 * z)}.
 */
final class NodeBundle {
  final int x0;
  final int y0;
  final int z0;
  private final int endX; // of this bundle, which may be cut short
  private final int endY;
  private final int endZ;
  private final BundleSize size;
  final Dictionary<Node> nodes;

  NodeBundle(
      int x0, int y0, int z0, BundleSize size, Lattice lattice, NodeLayout layout, int velocities) {
    this.x0 = x0;
    this.y0 = y0;
    this.z0 = z0;
    this.size = size;
    endX = Math.min(size.nx(), lattice.nx() - x0);
    endY = Math.min(size.ny(), lattice.ny() - y0);
    endZ = Math.min(size.nz(), lattice.nz() - z0);
    long[] positions =
        LongStream.range(0, size.nodes())
            .filter(p -> holds(x(p), y(p), z(p)))
            .filter(p -> lattice.nodes().fluid(x0 + x(p), y0 + y(p), z0 + z(p)))
            .toArray();
    nodes = layout.dictionary(positions, position -> layout.node(velocities));
  }

  /** Whether a place, relative to this bundle, lies within it. */
  boolean holds(int x, int y, int z) {
    return x >= 0 && y >= 0 && z >= 0 && x < endX && y < endY && z < endZ;
  }

  /** The node at a place within this bundle, or null. */
  Node node(int x, int y, int z) {
    return nodes.get(x + size.nx() * (y + (long) size.ny() * z));
  }

  int x(long position) {
    return (int) position % size.nx();
  }

  int y(long position) {
    return (int) position / size.nx() % size.ny();
  }

  int z(long position) {
    return (int) position / (size.nx() * size.ny());
  }
}
