package org.hdispatch.lbm;

import java.util.Arrays;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;

/**
 * Cuts a lattice into nodal bundles and links them. A box without fluid nodes gets no bundle (the
 * selective hash-tabling of Leonardi et al. 2011).
 */
final class BundleMap {
  private final Lattice lattice;
  private final VelocitySet set;
  private final BundleSize size;
  private final CellGrid grid;

  private BundleMap(Lattice lattice, VelocitySet set, BundleSize size) {
    this.lattice = lattice;
    this.set = set;
    this.size = size;
    grid =
        CellGrid.of(
            pieces(lattice.nx(), size.nx()),
            pieces(lattice.ny(), size.ny()),
            pieces(lattice.nz(), size.nz()),
            Ends.OPEN);
  }

  private static int pieces(int extent, int piece) {
    return (extent + piece - 1) / piece;
  }

  /** The bundles of a lattice, linked and at rest. */
  static CellMap<NodalBundle> of(Lattice lattice, VelocitySet set, BundleSize size) {
    return new BundleMap(lattice, set, size).build();
  }

  private CellMap<NodalBundle> build() {
    long[] keys = Arrays.stream(grid.keys()).filter(key -> positions(key).length > 0).toArray();
    CellMap<NodalBundle> bundles = CellMap.fixed(keys, KeyOrder.MORTON, this::bundle);
    Linker linker = new Linker(bundles);
    for (int n = 0; n < bundles.size(); n++) {
      bundles.cellAt(n).link(linker.plan(bundles.cellAt(n)));
    }
    return bundles;
  }

  private NodalBundle bundle(long key) {
    return new NodalBundle(
        key,
        CellKey.i(key) * size.nx(),
        CellKey.j(key) * size.ny(),
        CellKey.k(key) * size.nz(),
        size.nx(),
        size.ny(),
        positions(key),
        set);
  }

  /** Positions of the fluid nodes within a box, increasing. */
  private int[] positions(long key) {
    int x0 = CellKey.i(key) * size.nx();
    int y0 = CellKey.j(key) * size.ny();
    int z0 = CellKey.k(key) * size.nz();
    int[] found = new int[size.nx() * size.ny() * size.nz()];
    int n = 0;
    for (int z = z0; z < Math.min(z0 + size.nz(), lattice.nz()); z++) {
      for (int y = y0; y < Math.min(y0 + size.ny(), lattice.ny()); y++) {
        for (int x = x0; x < Math.min(x0 + size.nx(), lattice.nx()); x++) {
          if (lattice.nodes().fluid(x, y, z)) {
            found[n++] = x - x0 + size.nx() * (y - y0 + size.ny() * (z - z0));
          }
        }
      }
    }
    return Arrays.copyOf(found, n);
  }

  /** Finds the source of every population of every node, and writes the plan. */
  private final class Linker {
    /** Mean length from which on runs are faster than links. */
    private static final int LONG_RUN = 10;

    private final CellMap<NodalBundle> bundles;
    private final CellMap<int[]> nodeAt; // per bundle: node of each position of the box
    private final int[] source = new int[StreamPlan.CHUNK];
    private final int[] index = new int[StreamPlan.CHUNK];
    private final NodalBundle[] sources = new NodalBundle[27];
    private int sourceCount;
    private int[] plan = new int[1024];
    private int length;

    Linker(CellMap<NodalBundle> bundles) {
      this.bundles = bundles;
      long[] keys = new long[bundles.size()];
      Arrays.setAll(keys, bundles::keyAt);
      nodeAt = CellMap.fixed(keys, KeyOrder.MORTON, key -> nodeAt(bundles.get(key)));
    }

    private int[] nodeAt(NodalBundle bundle) {
      int[] nodes = new int[size.nx() * size.ny() * size.nz()];
      for (int node = 0; node < bundle.nodes(); node++) {
        nodes[position(bundle.x(node), bundle.y(node), bundle.z(node))] = node;
      }
      return nodes;
    }

    private int position(int x, int y, int z) {
      return x % size.nx() + size.nx() * (y % size.ny() + size.ny() * (z % size.nz()));
    }

    StreamPlan plan(NodalBundle bundle) {
      length = 0;
      sources[0] = bundle;
      sourceCount = 1;
      for (int first = 0; first < bundle.nodes(); first += StreamPlan.CHUNK) {
        int nodes = Math.min(StreamPlan.CHUNK, bundle.nodes() - first);
        for (int i = 0; i < set.size(); i++) {
          for (int k = 0; k < nodes; k++) {
            findSource(bundle, first + k, i, k);
          }
          int runs = countRuns(nodes);
          if (runs * LONG_RUN <= nodes) {
            writeRuns(runs, nodes);
          } else {
            writeLinks(nodes);
          }
        }
      }
      return new StreamPlan(Arrays.copyOf(sources, sourceCount), Arrays.copyOf(plan, length));
    }

    /** Finds where population i of a node comes from. */
    private void findSource(NodalBundle bundle, int node, int i, int k) {
      int x = bundle.x(node);
      int y = bundle.y(node);
      int z = bundle.z(node);
      if (lattice.open(x, y, z, -set.cx(i), -set.cy(i), -set.cz(i))) {
        int sx = lattice.x().wrap(x - set.cx(i), lattice.nx());
        int sy = lattice.y().wrap(y - set.cy(i), lattice.ny());
        int sz = lattice.z().wrap(z - set.cz(i), lattice.nz());
        long key = CellKey.of(sx / size.nx(), sy / size.ny(), sz / size.nz());
        NodalBundle from = bundles.get(key);
        source[k] = sourceNumber(from);
        index[k] = i * from.stride() + nodeAt.get(key)[position(sx, sy, sz)];
      } else {
        source[k] = 0;
        index[k] = set.opposite(i) * bundle.stride() + node;
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

    private boolean continues(int k) {
      return k > 0 && source[k] == source[k - 1] && index[k] == index[k - 1] + 1;
    }

    private int countRuns(int nodes) {
      int runs = 0;
      for (int k = 0; k < nodes; k++) {
        runs += continues(k) ? 0 : 1;
      }
      return runs;
    }

    private void writeRuns(int runs, int nodes) {
      append(runs);
      for (int k = 0; k < nodes; k++) {
        if (continues(k)) {
          plan[length - 3]++;
        } else {
          append(1);
          append(source[k]);
          append(index[k]);
        }
      }
    }

    private void writeLinks(int nodes) {
      append(StreamPlan.LINKS);
      int outside = 0;
      for (int k = 0; k < nodes; k++) {
        append(source[k] == 0 ? index[k] : 0);
        outside += source[k] == 0 ? 0 : 1;
      }
      append(outside);
      for (int k = 0; k < nodes; k++) {
        if (source[k] != 0) {
          append(k);
          append(source[k]);
          append(index[k]);
        }
      }
    }

    private void append(int number) {
      if (length == plan.length) {
        plan = Arrays.copyOf(plan, 2 * length);
      }
      plan[length++] = number;
    }
  }
}
