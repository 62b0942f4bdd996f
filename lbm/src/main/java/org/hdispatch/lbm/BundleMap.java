package org.hdispatch.lbm;

import java.util.Arrays;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;

/**
 * Cuts a lattice into nodal bundles. A box without fluid nodes gets no bundle (the selective
 * hash-tabling of Leonardi et al. 2011). Boxes are cut, and bundles linked, each by one worker.
 */
final class BundleMap {
  private final Lattice lattice;
  private final VelocitySet set;
  private final BundleSize size;
  private final Storage storage;
  private final Streaming streaming;
  private final SetUp setUp;

  private BundleMap(
      Lattice lattice,
      VelocitySet set,
      BundleSize size,
      Storage storage,
      Streaming streaming,
      SetUp setUp) {
    this.lattice = lattice;
    this.set = set;
    this.size = size.within(lattice);
    this.storage = storage;
    this.streaming = streaming;
    this.setUp = setUp;
  }

  /** The bundles of a lattice, linked and at rest. */
  static CellMap<NodalBundle> of(
      Lattice lattice,
      VelocitySet set,
      BundleSize size,
      Storage storage,
      Streaming streaming,
      SetUp setUp) {
    return new BundleMap(lattice, set, size, storage, streaming, setUp).build();
  }

  private CellMap<NodalBundle> build() {
    CellGrid grid =
        CellGrid.of(
            pieces(lattice.nx(), size.nx()),
            pieces(lattice.ny(), size.ny()),
            pieces(lattice.nz(), size.nz()),
            Ends.OPEN);
    CellMap<Box> boxes = CellMap.fixed(grid.keys(), KeyOrder.MORTON, Box::new);
    setUp.pass("cut", boxes, () -> new int[size.nodes()], this::cut);
    long[] keys = Arrays.stream(grid.keys()).filter(key -> boxes.get(key).bundle != null).toArray();
    CellMap<NodalBundle> bundles =
        CellMap.fixed(keys, KeyOrder.MORTON, key -> boxes.get(key).bundle);
    setUp.pass(
        "link",
        bundles,
        () -> new Linker(lattice, set, size, bundles),
        (bundle, linker) -> bundle.link(linker.plan(bundle)));
    return bundles;
  }

  /** A box of the lattice. */
  private static final class Box {
    private final long key;
    private NodalBundle bundle; // null without fluid nodes

    Box(long key) {
      this.key = key;
    }
  }

  private static int pieces(int extent, int piece) {
    return (extent - 1) / piece + 1;
  }

  /** Makes the bundle of a box, if there is fluid; {@code found} is scratch. */
  private void cut(Box box, int[] found) {
    int nodes = find(box.key, found);
    if (nodes > 0) {
      box.bundle =
          new NodalBundle(
              box.key,
              CellKey.i(box.key) * size.nx(),
              CellKey.j(box.key) * size.ny(),
              CellKey.k(box.key) * size.nz(),
              size,
              new NodeRuns(found, nodes),
              set,
              storage,
              streaming);
    }
  }

  /** Finds the positions of the fluid nodes within a box, increasing, and counts them. */
  private int find(long key, int[] found) {
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
