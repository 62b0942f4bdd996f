package org.hdispatch.lbm;

import java.util.Arrays;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;

/**
 * The box of one bundle and the nodes around it, one deep: where each is stored, and between which
 * of them fluid streams.
 */
final class Surroundings {
  private static final int SOLID = -1;

  private final Lattice lattice;
  private final BundleSize size;
  private final CellMap<NodalBundle> bundles;
  private final int rowLength;
  private final int layerLength;
  private final int[] nodes; // address of each node, velocity 0; or SOLID
  private final NodalBundle[] sources = new NodalBundle[27];
  private final int[] slots = new int[27]; // per source: index of the slot of its first node
  private int sourceCount;

  Surroundings(Lattice lattice, BundleSize size, CellMap<NodalBundle> bundles) {
    this.lattice = lattice;
    this.size = size;
    this.bundles = bundles;
    rowLength = size.nx() + 2;
    layerLength = rowLength * (size.ny() + 2);
    nodes = new int[layerLength * (size.nz() + 2)];
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
    sourceCount = 0;
    sourceNumber(bundle);
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
    NodalBundle there = outside ? null : bundles.get(key);
    if (there == null) {
      Arrays.fill(nodes, to, to + n, SOLID);
      return;
    }
    int source = StreamPlan.address(sourceNumber(there), 0);
    int from = x % size.nx() + size.nx() * (y % size.ny() + size.ny() * (z % size.nz()));
    there.runs().nodesAt(from, n, SOLID, nodes, to);
    for (int k = to; k < to + n; k++) {
      nodes[k] = nodes[k] == SOLID ? SOLID : source | nodes[k];
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
   * Writes where what arrives at the nodes of the bundle along a velocity comes from: addresses of
   * slots of the neighbours against it, or, behind a wall, of the nodes' own.
   *
   * @param i number of the velocity; not that of rest
   * @param places of the nodes
   * @param count how many of them there are
   */
  void findAddresses(VelocitySet set, int i, int[] places, int count, int[] addresses) {
    int back = set.opposite(i);
    int dx = set.cx(back);
    int dy = set.cy(back);
    int dz = set.cz(back);
    int distance = distance(dx, dy, dz);
    boolean face = set.axes(i).length == 1;
    int own = sources[0].populations(0).index(i, 0);
    for (int source = 0; source < sourceCount; source++) {
      slots[source] = sources[source].populations(0).index(back, 0);
    }
    for (int node = 0; node < count; node++) {
      int there = nodes[places[node] + distance];
      boolean open = there != SOLID && (face || hasWay(places[node], dx, dy, dz));
      addresses[node] = open ? there + slots[there >>> StreamPlan.INDEX_BITS] : own + node;
    }
  }

  /**
   * Whether the fluid node at a place streams to its neighbour and back. A diagonal link is open
   * only if its two nodes also connect face by face, through fluid nodes, within the small box that
   * the link spans.
   */
  boolean open(int place, int dx, int dy, int dz) {
    return fluid(place + distance(dx, dy, dz))
        && (dx * dx + dy * dy + dz * dz <= 1 || hasWay(place, dx, dy, dz));
  }

  /** Whether a way of open links leads along a diagonal one, its first step along an axis. */
  private boolean hasWay(int place, int dx, int dy, int dz) {
    return dx != 0 && fluid(place + dx) && open(place + dx, 0, dy, dz)
        || dy != 0 && fluid(place + rowLength * dy) && open(place + rowLength * dy, dx, 0, dz)
        || dz != 0 && fluid(place + layerLength * dz) && open(place + layerLength * dz, dx, dy, 0);
  }

  private boolean fluid(int place) {
    return nodes[place] != SOLID;
  }
}
