package org.hdispatch.lbm;

import java.util.Arrays;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;

/**
 * The box of one bundle and the nodes around it, one deep: where each is stored, and between which
 * of them fluid streams.
 */
final class Surroundings {
  private static final int SOLID = -1;

  private final Lattice lattice;
  private final BundleSize size;
  private final CellMap<NodalBundle> bundles;
  private final CellMap<int[]> nodeAt; // per bundle: node of each position, or SOLID
  private final int rowLength;
  private final int layerLength;
  private final int[] nodes; // address of each node, velocity 0; or SOLID
  private final NodalBundle[] sources = new NodalBundle[27];
  private int sourceCount;

  Surroundings(Lattice lattice, BundleSize size, CellMap<NodalBundle> bundles) {
    this.lattice = lattice;
    this.size = size;
    this.bundles = bundles;
    long[] keys = new long[bundles.size()];
    Arrays.setAll(keys, bundles::keyAt);
    nodeAt = CellMap.fixed(keys, KeyOrder.MORTON, key -> nodeAt(bundles.get(key)));
    rowLength = size.nx() + 2;
    layerLength = rowLength * (size.ny() + 2);
    nodes = new int[layerLength * (size.nz() + 2)];
  }

  private int[] nodeAt(NodalBundle bundle) {
    int[] found = new int[size.nodes()];
    Arrays.fill(found, SOLID);
    for (int node = 0; node < bundle.nodes(); node++) {
      found[bundle.runs().position(node)] = node;
    }
    return found;
  }

  /** Distance between places of this box. */
  int distance(int dx, int dy, int dz) {
    return dx + rowLength * dy + layerLength * dz;
  }

  /** Place of a node of the bundle; -1 and the extent of the bundle are around it. */
  int place(int x, int y, int z) {
    return distance(x + 1, y + 1, z + 1);
  }

  /** Place of a node of the bundle looked at, by its coordinates in the lattice. */
  int placeIn(NodalBundle bundle, int x, int y, int z) {
    long key = bundle.key();
    return place(
        x - CellKey.i(key) * size.nx(),
        y - CellKey.j(key) * size.ny(),
        z - CellKey.k(key) * size.nz());
  }

  /** Address of a slot of the fluid node at a place. */
  int slot(int place, int i) {
    NodalBundle from = sources[nodes[place] >>> StreamPlan.INDEX_BITS];
    return nodes[place] + from.populations(0).index(i, 0);
  }

  /** The bundle that an address speaks of. */
  NodalBundle source(int address) {
    return sources[address >>> StreamPlan.INDEX_BITS];
  }

  /** The bundles that addresses speak of; that whose surroundings these are first. */
  NodalBundle[] sources() {
    return Arrays.copyOf(sources, sourceCount);
  }

  /** Looks at a bundle's box and around it. */
  void look(NodalBundle bundle) {
    sources[0] = bundle;
    sourceCount = 1;
    int x0 = CellKey.i(bundle.key()) * size.nx();
    int y0 = CellKey.j(bundle.key()) * size.ny();
    int z0 = CellKey.k(bundle.key()) * size.nz();
    int at = 0;
    for (int z = z0 - 1; z <= z0 + size.nz(); z++) {
      int zk = wrap(lattice.z(), z, lattice.nz());
      for (int y = y0 - 1; y <= y0 + size.ny(); y++) {
        int yj = wrap(lattice.y(), y, lattice.ny());
        int x = x0 - 1;
        while (x <= x0 + size.nx()) { // a stretch of the row that lies in one bundle
          int xi = wrap(lattice.x(), x, lattice.nx());
          boolean outside = xi < 0 || yj < 0 || zk < 0;
          int stretch = outside ? 1 : Math.min(size.nx() - xi % size.nx(), lattice.nx() - xi);
          stretch = Math.min(stretch, x0 + size.nx() + 1 - x);
          copy(outside, xi, yj, zk, at, stretch);
          at += stretch;
          x += stretch;
        }
      }
    }
  }

  /** A coordinate within the lattice, or negative; those beyond the halo of a cut bundle too. */
  private static int wrap(Ends ends, int coordinate, int extent) {
    return coordinate > extent ? -1 : ends.wrap(coordinate, extent);
  }

  private void copy(boolean outside, int x, int y, int z, int to, int n) {
    long key = outside ? 0 : CellKey.of(x / size.nx(), y / size.ny(), z / size.nz());
    int[] there = outside ? null : nodeAt.get(key);
    if (there == null) {
      Arrays.fill(nodes, to, to + n, SOLID);
      return;
    }
    int source = sourceNumber(bundles.get(key));
    int from = x % size.nx() + size.nx() * (y % size.ny() + size.ny() * (z % size.nz()));
    for (int k = 0; k < n; k++) {
      int node = there[from + k];
      nodes[to + k] = node == SOLID ? SOLID : StreamPlan.address(source, node);
    }
  }

  private int sourceNumber(NodalBundle bundle) {
    for (int n = 0; n < sourceCount; n++) {
      if (sources[n] == bundle) {
        return n;
      }
    }
    sources[sourceCount] = bundle;
    return sourceCount++;
  }

  /**
   * Whether the fluid node at a place streams to its neighbour and back. A diagonal link is open
   * only if its two nodes also connect face by face, through fluid nodes, within the small box that
   * the link spans.
   */
  boolean open(int place, int dx, int dy, int dz) {
    if (!fluid(place + distance(dx, dy, dz))) {
      return false;
    }
    return dx * dx + dy * dy + dz * dz <= 1
        || dx != 0 && fluid(place + dx) && open(place + dx, 0, dy, dz)
        || dy != 0 && fluid(place + rowLength * dy) && open(place + rowLength * dy, dx, 0, dz)
        || dz != 0 && fluid(place + layerLength * dz) && open(place + layerLength * dz, dx, dy, 0);
  }

  private boolean fluid(int place) {
    return nodes[place] != SOLID;
  }
}
