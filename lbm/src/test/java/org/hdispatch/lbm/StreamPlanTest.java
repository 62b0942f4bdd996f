package org.hdispatch.lbm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.Random;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Streams along the plans of whole lattices, and compares with the lattices themselves. */
class StreamPlanTest {
  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void leadsWhereTheLatticeSaysInSmallBoxesOfAnyEndsAndBundles(VelocitySet set) {
    Random random = new Random(1410);
    for (int trial = 0; trial < 400; trial++) {
      Lattice lattice =
          rubble(
              1 + random.nextInt(7),
              1 + random.nextInt(7),
              1 + random.nextInt(7),
              random,
              0.3 + 0.7 * random.nextDouble());
      BundleSize size =
          new BundleSize(1 + random.nextInt(9), 1 + random.nextInt(4), 1 + random.nextInt(4));
      new Labelled(lattice, set, size).check(lattice + " " + size);
    }
  }

  /** With rows long enough to be segments, some of which can be joined and some of which cannot. */
  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void leadsWhereTheLatticeSaysAlongRowsWithFewSolids(VelocitySet set) {
    Random random = new Random(1412);
    for (int trial = 0; trial < 150; trial++) {
      Lattice lattice =
          rubble(
              12 + random.nextInt(40),
              1 + random.nextInt(10),
              1 + random.nextInt(10),
              random,
              1 - 0.05 * random.nextDouble());
      BundleSize size =
          new BundleSize(10 + random.nextInt(40), 2 + random.nextInt(9), 2 + random.nextInt(9));
      new Labelled(lattice, set, size).check(lattice + " " + size);
    }
  }

  /** More slots of a pair and more nodes of a layer than 16 bits count. */
  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void leadsWhereTheLatticeSaysInBundlesTooLargeForALink(VelocitySet set) {
    Lattice rubble = rubble(300, 300, 2, new Random(1411), 0.8);
    new Labelled(rubble, set, new BundleSize(300, 300, 2)).check("rubble");
  }

  /** The batches hold the ends of rows only, which lie farther apart than 16 bits count. */
  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void leadsWhereTheLatticeSaysInLongRows(VelocitySet set) {
    Lattice box = Lattice.empty(2500, 7, 6, Ends.OPEN, Ends.PERIODIC, Ends.OPEN);
    new Labelled(box, set, new BundleSize(2500, 7, 6)).check("one bundle");
    new Labelled(box, set, new BundleSize(800, 5, 6)).check("cut bundles");
  }

  private static Lattice rubble(int nx, int ny, int nz, Random random, double porosity) {
    BitSet fluid = new BitSet(nx * ny * nz);
    for (int n = 0; n < nx * ny * nz; n++) {
      fluid.set(n, random.nextDouble() < porosity);
    }
    Ends[] ends = Ends.values();
    return new Lattice(
        nx,
        ny,
        nz,
        ends[random.nextInt(2)],
        ends[random.nextInt(2)],
        ends[random.nextInt(2)],
        (x, y, z) -> fluid.get(x + nx * (y + ny * z)));
  }

  /** The bundles of a lattice; every slot of their first copy holds a number of its own. */
  private static final class Labelled {
    private static final int[][] ORDERS = {
      {0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}
    };

    private final Lattice lattice;
    private final VelocitySet set;
    private final CellMap<NodalBundle> bundles;

    Labelled(Lattice lattice, VelocitySet set, BundleSize size) {
      this.lattice = lattice;
      this.set = set;
      bundles = BundleMap.of(lattice, set, size, Storage.DOUBLE, Streaming.PULL, SetUp.alone());
      for (int n = 0; n < bundles.size(); n++) {
        NodalBundle bundle = bundles.cellAt(n);
        for (int node = 0; node < bundle.nodes(); node++) {
          for (int i = 0; i < set.size(); i++) {
            double label = label(bundle.x(node), bundle.y(node), bundle.z(node), i);
            bundle.populations(0).set(i, node, label);
          }
        }
      }
    }

    private int number(int x, int y, int z) {
      return lattice.x().wrap(x, lattice.nx())
          + lattice.nx()
              * (lattice.y().wrap(y, lattice.ny())
                  + lattice.ny() * lattice.z().wrap(z, lattice.nz()));
    }

    private double label(int x, int y, int z, int i) {
      return 1 + i + (double) set.size() * number(x, y, z);
    }

    /** Reads all that arrives, and writes it to the same slots of the other copy. */
    void check(String what) {
      BitSet seen = new BitSet();
      ChunkCursor cursor = new ChunkCursor();
      ChunkRows rows = ChunkRows.of(Storage.DOUBLE, set.size());
      for (int n = 0; n < bundles.size(); n++) {
        NodalBundle bundle = bundles.cellAt(n);
        cursor.begin(bundle.plan());
        while (cursor.next()) {
          cursor.read(0, true, rows);
          for (int k = 0; k < cursor.nodes(); k++) {
            int node = cursor.node(k);
            int x = bundle.x(node);
            int y = bundle.y(node);
            int z = bundle.z(node);
            assertFalse(seen.get(number(x, y, z)), what);
            seen.set(number(x, y, z));
            for (int i = 0; i < set.size(); i++) {
              assertEquals(arriving(x, y, z, i), rows.wide[i][k], what);
            }
          }
          cursor.write(1, true, rows);
        }
      }
      for (int z = 0; z < lattice.nz(); z++) {
        for (int y = 0; y < lattice.ny(); y++) {
          for (int x = 0; x < lattice.nx(); x++) {
            assertEquals(lattice.fluid(x, y, z), seen.get(number(x, y, z)), what);
          }
        }
      }
      checkWritten(what);
    }

    /** Every slot has been written, and from there where it was read. */
    private void checkWritten(String what) {
      for (int n = 0; n < bundles.size(); n++) {
        NodalBundle bundle = bundles.cellAt(n);
        for (int node = 0; node < bundle.nodes(); node++) {
          for (int i = 0; i < set.size(); i++) {
            double label = bundle.populations(0).get(i, node);
            assertTrue(label > 0, what);
            assertEquals(label, bundle.populations(1).get(i, node), what);
          }
        }
      }
    }

    private double arriving(int x, int y, int z, int i) {
      int[] link = {-set.cx(i), -set.cy(i), -set.cz(i)};
      return open(x, y, z, link)
          ? label(x + link[0], y + link[1], z + link[2], set.opposite(i))
          : label(x, y, z, i);
    }

    /** Whether fluid leads along a link, one axis after the other, in some order of the axes. */
    private boolean open(int x, int y, int z, int[] link) {
      for (int[] order : ORDERS) {
        int[] at = {x, y, z};
        boolean fluid = true;
        for (int axis : order) {
          at[axis] += link[axis];
          fluid &= lattice.fluid(at[0], at[1], at[2]);
        }
        if (fluid) {
          return true;
        }
      }
      return false;
    }
  }
}
