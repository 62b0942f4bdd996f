package org.hdispatch.lbm;

import java.util.Arrays;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;

/**
 * Cuts a lattice into nodal bundles. A box without fluid nodes gets no bundle (the selective
 * hash-tabling of Leonardi et al. 2011).
 */
final class BundleMap {
  private final Lattice lattice;
  private final VelocitySet set;
  private final BundleSize size;
  private final Storage storage;
  private final Streaming streaming;
  private final int[] found; // positions, of one box at a time

  private BundleMap(
      Lattice lattice, VelocitySet set, BundleSize size, Storage storage, Streaming streaming) {
    this.lattice = lattice;
    this.set = set;
    this.size = size.within(lattice);
    this.storage = storage;
    this.streaming = streaming;
    found = new int[this.size.nodes()];
  }

  /** The bundles of a lattice, linked and at rest. */
  static CellMap<NodalBundle> of(
      Lattice lattice, VelocitySet set, BundleSize size, Storage storage, Streaming streaming) {
    return new BundleMap(lattice, set, size, storage, streaming).build();
  }

  private CellMap<NodalBundle> build() {
    CellGrid grid =
        CellGrid.of(
            pieces(lattice.nx(), size.nx()),
            pieces(lattice.ny(), size.ny()),
            pieces(lattice.nz(), size.nz()),
            Ends.OPEN);
    long[] keys = Arrays.stream(grid.keys()).filter(key -> find(key) > 0).toArray();
    CellMap<NodalBundle> bundles = CellMap.fixed(keys, KeyOrder.MORTON, this::bundle);
    Linker linker = new Linker(lattice, set, size, bundles);
    for (int n = 0; n < bundles.size(); n++) {
      bundles.cellAt(n).link(linker.plan(bundles.cellAt(n)));
    }
    return bundles;
  }

  private static int pieces(int extent, int piece) {
    return (extent - 1) / piece + 1;
  }

  private NodalBundle bundle(long key) {
    NodeRuns runs = new NodeRuns(found, find(key));
    return new NodalBundle(
        key,
        CellKey.i(key) * size.nx(),
        CellKey.j(key) * size.ny(),
        CellKey.k(key) * size.nz(),
        size,
        runs,
        set,
        storage,
        streaming);
  }

  /** Finds the positions of the fluid nodes within a box, increasing, and counts them. */
  private int find(long key) {
    int x0 = CellKey.i(key) * size.nx();
    int y0 = CellKey.j(key) * size.ny();
    int z0 = CellKey.k(key) * size.nz();
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
    return n;
  }
}
