package org.hdispatch.poisson;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.Random;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.KernelException;
import org.junit.jupiter.api.Test;

class SetUpTest {
  private static final int N = 50;

  private final double[] mobility =
      new Random(3).doubles(N * N * N).map(d -> d < 0.4 ? 0 : d).toArray();
  private final PoissonProblem problem =
      PoissonProblem.box(N, N, N)
          .ends(Ends.PERIODIC, Ends.OPEN, Ends.OPEN)
          .mobility((x, y, z) -> mobility[index(x, y, z)])
          .fixed(Side.Z_FIRST, 1)
          .build();

  private static int index(int x, int y, int z) {
    return x + N * (y + N * z);
  }

  /** Bits of all that set-up makes, of the finest level and the next. */
  private int[] levels(int workers) {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(workers)) {
      CellMap<GraphCell> fine = FineCells.of(dispatcher, problem);
      Clusters clusters = new Clusters(dispatcher, fine);
      long nodes = 0;
      for (int n = 0; n < fine.size(); n++) {
        nodes += fine.cellAt(n).nodes;
      }
      CoarseCells.Coarser coarse = CoarseCells.of(dispatcher, fine, FineCells.EDGE, nodes);
      assertEquals(FineCells.EDGE, coarse.edge());
      int[] hashes = new int[fine.size() + coarse.cells().size() + 1];
      int next = 0;
      for (CellMap<GraphCell> level : Arrays.asList(fine, coarse.cells())) {
        for (int n = 0; n < level.size(); n++) {
          hashes[next++] = hash(level.cellAt(n));
        }
      }
      hashes[next] = clusters.count();
      return hashes;
    }
  }

  private static int hash(GraphCell cell) {
    long[] others = Arrays.stream(cell.halo.cells()).mapToLong(other -> other.key).toArray();
    return Arrays.deepHashCode(
        new Object[] {
          cell.key,
          cell.position,
          cell.lower.start(),
          cell.lower.to(),
          cell.lower.mobility(),
          cell.upper.start(),
          cell.upper.to(),
          cell.upper.mobility(),
          others,
          cell.halo.end(),
          cell.halo.row(),
          cell.halo.to(),
          cell.halo.mobility(),
          cell.inverseDiagonal,
          cell.ground,
          cell.fixedSource,
          cell.cluster,
          cell.clusters,
          cell.aggregate,
          cell.parentOffset
        });
  }

  @Test
  void makesTheSameCellsForAnyNumberOfWorkers() {
    int[] one = levels(1);
    for (int workers = 2; workers <= 3; workers++) {
      assertArrayEquals(one, levels(workers), workers + " workers");
    }
  }

  @Test
  void sumsToTheSameBitsAndShowsEveryNodeAtOnce() {
    double[] sums = new double[3];
    for (int workers = 1; workers <= 3; workers++) {
      try (Dispatcher dispatcher = Dispatcher.withWorkers(workers)) {
        ConjugateGradients solver = ConjugateGradients.on(dispatcher, problem);
        sums[workers - 1] = solver.sum((x, y, z) -> mobility[index(x, y, z)]);
        assertEquals(Arrays.stream(mobility).sum(), sums[0], 1e-9); // 75 000 roundings
        assertEquals(sums[0], sums[workers - 1], 0);
        solver.guess((x, y, z) -> mobility[index(x, y, z)]);
        double[] shown = new double[mobility.length];
        solver.forEachNodeAtOnce((x, y, z, p) -> shown[index(x, y, z)] += p);
        assertArrayEquals(mobility, shown);
      }
    }
  }

  @Test
  void saysWhatAFunctionOfTheUserThrew() {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      ConjugateGradients solver = ConjugateGradients.on(dispatcher, problem);
      assertThrows(IllegalArgumentException.class, () -> solver.sum((x, y, z) -> Math.sqrt(-1)));
      KernelException failure =
          assertThrows(
              KernelException.class,
              () -> solver.addSources((x, y, z) -> mobility[mobility.length + x]));
      assertEquals(ArrayIndexOutOfBoundsException.class, failure.getCause().getClass());
    }
  }
}
