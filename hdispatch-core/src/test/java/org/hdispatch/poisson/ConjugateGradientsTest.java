package org.hdispatch.poisson;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.CancellationException;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Handout;
import org.hdispatch.gc.AllocationMeter;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ConjugateGradientsTest {
  private final Dispatcher dispatcher = Dispatcher.withWorkers(2);

  @AfterEach
  void close() {
    dispatcher.close();
  }

  /** Largest error of u = sin 2 pi x sin 2 pi y sin pi z on n³ nodes of spacing 1/n, u = 0 on z. */
  private double errorOfSineProduct(int n) {
    PoissonProblem problem =
        PoissonProblem.box(n, n, n)
            .ends(Ends.PERIODIC, Ends.PERIODIC, Ends.OPEN)
            .fixed(Side.Z_FIRST, 0)
            .fixed(Side.Z_LAST, 0)
            .build();
    ConjugateGradients solver = ConjugateGradients.on(dispatcher, problem);
    solver.addSources((x, y, z) -> 9 * Math.PI * Math.PI / n / n * sineProduct(n, x, y, z));
    assertTrue(solver.solve(1e-10, 30).converged());
    double[] worst = new double[1];
    solver.forEachNode(
        (x, y, z, p) -> worst[0] = Math.max(worst[0], Math.abs(p - sineProduct(n, x, y, z))));
    return worst[0];
  }

  private static double sineProduct(int n, int x, int y, int z) {
    return Math.sin(2 * Math.PI * (x + 0.5) / n)
        * Math.sin(2 * Math.PI * (y + 0.5) / n)
        * Math.sin(Math.PI * (z + 0.5) / n);
  }

  @Test
  void sineProductConvergesAtSecondOrder() {
    double order = Math.log(errorOfSineProduct(32) / errorOfSineProduct(64)) / Math.log(2);
    assertEquals(2, order, 0.02); // the next term is O(dx²), 1/32² = 0.001 of it
  }

  @Test
  @Tag("validation")
  void sineProductConvergesAtSecondOrderAt128() {
    double order = Math.log(errorOfSineProduct(64) / errorOfSineProduct(128)) / Math.log(2);
    assertEquals(2, order, 0.005); // as above, a quarter
  }

  @Test
  void layersCarryTheFluxOfResistancesInSeries() {
    int n = 21;
    double[] layer = new double[n];
    Arrays.setAll(layer, z -> z % 3 == 0 ? 1000 : 1 + z);
    PoissonProblem problem =
        PoissonProblem.box(3, 18, n)
            .mobility((x, y, z) -> layer[z])
            .fixed(Side.Z_FIRST, 5)
            .fixed(Side.Z_LAST, 2)
            .build();
    ConjugateGradients solver = ConjugateGradients.on(dispatcher, problem);
    assertTrue(solver.solve(1e-13, 50).converged());
    double flux = 3 / Arrays.stream(layer).map(k -> 1 / k).sum();
    double[] pressure = new double[n];
    double above = 5;
    for (int z = 0; z < n; z++) {
      pressure[z] = above - flux / (2 * layer[z]);
      above -= flux / layer[z];
    }
    solver.forEachNode((x, y, z, p) -> assertEquals(pressure[z], p, 1e-11));
    solver.scaleMobility(7);
    assertEquals(0, solver.solve(1e-13, 50).iterations(), "fixed sides scale with the mobility");
  }

  /** Random rubble, ends, fixed sides, forces; odd and tiny boxes. */
  @ParameterizedTest
  @CsvSource({
    "1,1,1",
    "2,1,1",
    "2,2,2",
    "3,2,5",
    "1,17,2",
    "7,7,7",
    "16,16,16",
    "17,33,5",
    "31,2,40",
    "23,24,25",
    "40,41,1"
  })
  void solvesRandomRubbleWhateverItsEnds(int nx, int ny, int nz) {
    for (int seed = 0; seed < 16; seed++) {
      Random random = new Random(seed);
      int axes = seed < 8 ? 1 : 3; // mobilities of a node
      ReferenceProblem reference =
          new ReferenceProblem(nx, ny, nz, random.nextInt(3) * 0.3, axes, random);
      ConjugateGradients solver = ConjugateGradients.on(dispatcher, reference.problem);
      double[] force = reference.force;
      solver.addForce(force[0], force[1], force[2]);
      solver.addSources((x, y, z) -> reference.source[reference.index(x, y, z)]);
      Convergence end = solver.solve(1e-11, 300);
      assertTrue(end.converged(), "seed " + seed + ": " + end);
      double[] p = new double[reference.nodes];
      solver.forEachNode((x, y, z, value) -> p[reference.index(x, y, z)] = value);
      check(reference, p, end);
    }
  }

  /** The residual is the mean of each cluster's sources, and its solution has none. */
  private static void check(ReferenceProblem reference, double[] p, Convergence end) {
    int[] cluster = reference.clusters();
    int clusters = Arrays.stream(cluster).map(c -> c < -1 ? -2 - c : c).max().getAsInt() + 1;
    double[] sources = new double[clusters];
    double[] values = new double[clusters];
    int[] nodes = new int[clusters];
    for (int m = 0; m < p.length; m++) {
      if (cluster[m] >= 0) {
        sources[cluster[m]] += reference.source[m];
        values[cluster[m]] += p[m];
        nodes[cluster[m]]++;
      }
    }
    double imbalance = 0;
    for (int m = 0; m < p.length; m++) {
      if (cluster[m] != -1) {
        double mean = cluster[m] < 0 ? 0 : sources[cluster[m]] / nodes[cluster[m]];
        double residual = reference.outflow(m, p) - reference.source[m] + mean;
        // Force times mobility is at most 500 a link: the right-hand side is below 1e3 a node.
        assertEquals(0, residual, 1e-11 * 1e3 * Math.sqrt(p.length));
      }
    }
    for (int c = 0; c < clusters; c++) {
      imbalance = Math.max(imbalance, Math.abs(sources[c]));
      assertEquals(0, values[c], 1e-9 * Math.max(1, nodes[c]));
    }
    // Forces add up to 0 in a cluster, up to rounding.
    assertEquals(imbalance, end.imbalance(), 1e-9);
  }

  @Test
  void chambersAreBalancedOneByOne() {
    PoissonProblem problem =
        PoissonProblem.box(40, 9, 9).mobility((x, y, z) -> x == 20 ? 0 : 1).build();
    ConjugateGradients solver = ConjugateGradients.on(dispatcher, problem);
    assertEquals(2, solver.clusters());
    assertEquals(39 * 81, solver.nodes());
    solver.addSources((x, y, z) -> x < 20 ? 0.5 : x == 30 ? -1 : 0);
    Convergence end = solver.solve(1e-10, 50);
    assertTrue(end.converged());
    assertEquals(20 * 81 * 0.5, end.imbalance(), 1e-9);
    double[] extremes = new double[2];
    solver.forEachNode(
        (x, y, z, p) -> {
          extremes[0] = x < 20 ? Math.max(extremes[0], Math.abs(p)) : extremes[0];
          extremes[1] = Math.min(extremes[1], p);
        });
    assertEquals(0, extremes[0], 1e-10, "even sources leave nothing");
    assertEquals(solver.value(30, 4, 4), extremes[1], 1e-9, "lowest at the sink");
  }

  @Test
  void pressureOfAForceInAClosedBoxIsHydrostatic() {
    ConjugateGradients solver =
        ConjugateGradients.on(
            dispatcher, PoissonProblem.box(5, 20, 33).mobility((x, y, z) -> 1 + x * y % 7).build());
    solver.addForce(0, 0, 2);
    assertTrue(solver.solve(1e-12, 50).converged());
    solver.forEachNode((x, y, z, p) -> assertEquals(2 * (z - 16), p, 1e-8));
  }

  private static double[] solution(Dispatcher dispatcher, int axes) {
    int n = 40;
    Random random = new Random(5);
    double[] mobility = random.doubles(n * n * n).map(d -> d < 0.3 ? 0 : 1000 * d * d).toArray();
    Mobility one = (x, y, z) -> mobility[x + n * (y + n * z)];
    Mobility other = (x, y, z) -> mobility[y + n * (z + n * x)];
    PoissonProblem.Builder builder =
        PoissonProblem.box(n, n, n).ends(Ends.PERIODIC, Ends.OPEN, Ends.PERIODIC);
    ConjugateGradients solver =
        ConjugateGradients.on(
            dispatcher,
            (axes == 1 ? builder.mobility(one) : builder.mobility(one, other, one)).build());
    solver.addForce(0.2, 0.1, 1);
    assertTrue(solver.solve(1e-8, 200).converged());
    double[] values = new double[n * n * n];
    solver.forEachNode((x, y, z, p) -> values[x + n * (y + n * z)] = p);
    return values;
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 3})
  void sameBitsForAnyWorkerCountAndHandout(int axes) {
    double[] expected = solution(dispatcher, axes);
    for (Handout handout : Handout.values()) {
      for (int workers = 1; workers <= 3; workers++) {
        try (Dispatcher other = Dispatcher.builder().workers(workers).handout(handout).build()) {
          assertArrayEquals(expected, solution(other, axes), handout + ", " + workers + " workers");
        }
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2})
  @SuppressWarnings("deprecation") // threadId() needs Java 19
  void allocatesNothingPerIterationAfterWarmUp(int workers) {
    try (Dispatcher own = Dispatcher.builder().workers(workers).name("measured").build()) {
      ConjugateGradients solver =
          ConjugateGradients.on(own, PoissonProblem.box(33, 34, 35).build());
      solver.addSources((x, y, z) -> x * y % 5);
      long[] measured =
          Thread.getAllStackTraces().keySet().stream()
              .filter(t -> t.getName().startsWith("measured") || t == Thread.currentThread())
              .mapToLong(Thread::getId)
              .toArray();
      assertEquals(workers, measured.length);
      AllocationMeter meter = new AllocationMeter(measured);
      long few = 0;
      long many = 1;
      for (int warmUp = 0; warmUp < 60 && few != many; warmUp++) {
        few = allocated(meter, solver, 1);
        many = allocated(meter, solver, 9);
      }
      assertEquals(few, many, "bytes of 1 and of 9 iterations");
      assertTrue(few < 500, "the result alone: bytes=" + few);
    }
  }

  private static long allocated(AllocationMeter meter, ConjugateGradients solver, int iterations) {
    long[] before = new long[meter.threads()];
    long[] after = new long[meter.threads()];
    solver.clearSolution();
    meter.read(before);
    Convergence end = solver.solve(1e-12, iterations);
    meter.read(after);
    assertEquals(iterations, end.iterations());
    return Arrays.stream(after).sum() - Arrays.stream(before).sum();
  }

  private int iterations(int n, double contrast) {
    double[] source = new Random(1).doubles(n * n * n).toArray();
    ConjugateGradients solver =
        ConjugateGradients.on(
            dispatcher,
            PoissonProblem.box(n, n, n)
                .ends(Ends.PERIODIC, Ends.OPEN, Ends.PERIODIC)
                .mobility((x, y, z) -> Math.pow(contrast, random(x / 4, y / 4, z / 4)))
                .build());
    solver.addSources((x, y, z) -> source[x + n * (y + n * z)]);
    Convergence end = solver.solve(1e-8, 100);
    assertTrue(end.converged());
    return end.iterations();
  }

  /** A random number for each block. */
  private static double random(int x, int y, int z) {
    return new Random(x + 1000L * (y + 1000L * z)).nextInt(1000) / 999.0;
  }

  @Test
  void iterationsHardlyGrowWithSizeAndContrast() {
    assertTrue(iterations(16, 1) <= 12);
    assertTrue(iterations(32, 1) <= 13);
    assertTrue(iterations(64, 1) <= 14);
    assertTrue(iterations(32, 1000) <= 20);
    assertTrue(iterations(64, 1000) <= 22);
  }

  @Test
  void lastSolutionIsTheFirstGuess() {
    ConjugateGradients solver =
        ConjugateGradients.on(dispatcher, PoissonProblem.box(20, 20, 20).build());
    solver.addSources((x, y, z) -> x - y * z);
    int cold = solver.solve(1e-8, 50).iterations();
    double value = solver.value(3, 4, 5);
    assertEquals(0, solver.solve(1e-8, 50).iterations());
    solver.clearSolution();
    assertEquals(cold, solver.solve(1e-8, 50).iterations());
    assertEquals(value, solver.value(3, 4, 5), "the same again, bit by bit");
    solver.guess((x, y, z) -> 3);
    assertTrue(solver.solve(1e-8, 50).converged());
    assertEquals(value, solver.value(3, 4, 5), 1e-6 * Math.abs(value));
    solver.scaleMobility(4);
    solver.solve(1e-8, 50);
    assertEquals(value / 4, solver.value(3, 4, 5), 1e-6 * Math.abs(value));
    solver.clearSources();
    assertEquals(new Convergence(0, 0, true, 0), solver.solve(1e-8, 50));
    assertEquals(0, solver.value(3, 4, 5));
  }

  @Test
  void saysWhenItHasNotConverged() {
    ConjugateGradients solver =
        ConjugateGradients.on(dispatcher, PoissonProblem.box(20, 20, 20).build());
    solver.addSources((x, y, z) -> x);
    Convergence end = solver.solve(1e-8, 2);
    assertEquals(2, end.iterations());
    assertTrue(!end.converged() && end.relativeResidual() > 1e-8);
  }

  @Test
  void interruptedSolveGoesOnLater() {
    ConjugateGradients solver =
        ConjugateGradients.on(dispatcher, PoissonProblem.box(40, 40, 40).build());
    solver.addSources((x, y, z) -> x);
    Thread.currentThread().interrupt();
    assertThrows(CancellationException.class, () -> solver.solve(1e-8, 50));
    assertTrue(Thread.interrupted());
    assertTrue(solver.solve(1e-8, 50).converged());
  }

  @Test
  void worksWithoutAnyActiveNode() {
    ConjugateGradients solver =
        ConjugateGradients.on(
            dispatcher, PoissonProblem.box(20, 20, 20).mobility((x, y, z) -> 0).build());
    assertEquals(new Convergence(0, 0, true, 0), solver.solve(1e-8, 50));
    assertEquals(0, solver.nodes());
    assertEquals(0, solver.clusters());
  }

  /** Laminar flow between plates of inactive nodes: y (W - y)/2, and 1/8 for the walls half way. */
  @Test
  void fixedWallsHoldAProfile() {
    int width = 9;
    PoissonProblem problem =
        PoissonProblem.box(4, width + 2, 3)
            .ends(Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC)
            .mobility((x, y, z) -> y == 0 || y == width + 1 ? 0 : 1)
            .fixedWalls(0)
            .build();
    ConjugateGradients solver = ConjugateGradients.on(dispatcher, problem);
    solver.addSources((x, y, z) -> 1);
    assertTrue(solver.solve(1e-12, 50).converged());
    solver.forEachNode(
        (x, y, z, p) -> {
          double way = y - 0.5;
          assertEquals(way * (width - way) / 2 + 0.125, p, 1e-10);
        });
    assertThrows(IllegalStateException.class, () -> solver.addForce(1, 0, 0));
  }

  /** Fixed sides on two axes that meet in the corner nodes, and a force across both. */
  @Test
  void mobilityMayDifferFromAxisToAxis() {
    PoissonProblem problem =
        PoissonProblem.box(3, 4, 5)
            .mobility((x, y, z) -> 2, (x, y, z) -> 3, (x, y, z) -> 0)
            .fixed(Side.X_FIRST, 1)
            .fixed(Side.Y_LAST, 7)
            .build();
    ConjugateGradients solver = ConjugateGradients.on(dispatcher, problem);
    assertEquals(5, solver.clusters(), "nothing flows along z");
    solver.addForce(0.5, -2, 9);
    assertTrue(solver.solve(1e-13, 50).converged());
    for (int z = 0; z < 5; z++) {
      for (int y = 0; y < 4; y++) {
        for (int x = 0; x < 3; x++) {
          double p = solver.value(x, y, z);
          double flux = x == 0 ? 4 * (p - 1 - 0.25) : 2 * (p - solver.value(x - 1, y, z) - 0.5);
          flux += x == 2 ? 0 : 2 * (p - solver.value(x + 1, y, z) + 0.5);
          flux += y == 0 ? 0 : 3 * (p - solver.value(x, y - 1, z) + 2);
          flux += y == 3 ? 6 * (p - 7 - 1) : 3 * (p - solver.value(x, y + 1, z) - 2);
          assertEquals(0, flux, 1e-11);
        }
      }
    }
  }

  @Test
  void linkMeanCanBeChosen() {
    ConjugateGradients solver =
        ConjugateGradients.on(
            dispatcher,
            PoissonProblem.box(2, 1, 1)
                .mobility((x, y, z) -> 1 + 2 * x)
                .linkMean((one, other) -> (one + other) / 2)
                .build());
    solver.addSources((x, y, z) -> x == 0 ? 1 : -1);
    assertTrue(solver.solve(1e-12, 5).converged());
    assertEquals(0.25, solver.value(0, 0, 0), 1e-15); // half of 1 / 2
  }

  @Test
  void refusesWhatIsNoNumberAndWhatIsNotThere() {
    PoissonProblem.Builder box = PoissonProblem.box(4, 4, 4);
    PoissonProblem holed = box.mobility((x, y, z) -> x == 1 ? Double.NaN : 1).build();
    refused(() -> ConjugateGradients.on(dispatcher, holed), "mobility=NaN, x=1, y=0, z=0");
    PoissonProblem unlinked =
        PoissonProblem.box(4, 4, 4).linkMean((one, other) -> Double.NaN).build();
    refused(() -> ConjugateGradients.on(dispatcher, unlinked), "link=NaN, nodes=1.0 and 1.0");
    refused(() -> box.fixed(Side.X_FIRST, Double.NaN), "side=X_FIRST, value=NaN");
    refused(
        () ->
            PoissonProblem.box(4, 4, 4)
                .ends(Ends.PERIODIC, Ends.OPEN, Ends.OPEN)
                .fixed(Side.X_LAST, 1)
                .build(),
        "side=X_LAST");
    refused(() -> box.fixedWalls(Double.NaN), "value=NaN");
    refused(() -> PoissonProblem.box(4, 0, 4), "ny=0");
    ConjugateGradients solver =
        ConjugateGradients.on(
            dispatcher, PoissonProblem.box(4, 4, 4).mobility((x, y, z) -> x == 1 ? 0 : 1).build());
    refused(() -> solver.addSources((x, y, z) -> 0 / 0.0), "source=NaN, x=0, y=0, z=0");
    refused(() -> solver.guess((x, y, z) -> 1 / 0.0), "p=Infinity, x=0, y=0, z=0");
    refused(() -> solver.addForce(0, Double.NaN, 0), "gy=NaN");
    refused(() -> solver.scaleMobility(0), "factor=0.0");
    refused(() -> solver.solve(0, 5), "tolerance=0.0");
    refused(() -> solver.solve(1e-3, -1), "iterations=-1");
    refused(() -> solver.value(1, 0, 0), "x=1, y=0, z=0");
    refused(() -> solver.value(0, 4, 0), "x=0, y=4, z=0");
  }

  private static void refused(Runnable action, String text) {
    String message = assertThrows(IllegalArgumentException.class, action::run).getMessage();
    assertTrue(message.contains(text), message);
  }

  @Test
  void tellsItsBytes() {
    ConjugateGradients solver =
        ConjugateGradients.on(dispatcher, PoissonProblem.box(64, 64, 64).build());
    double perNode = (double) solver.bytes() / solver.nodes();
    assertTrue(perNode > 100 && perNode < 180, "bytes per node=" + perNode);
    assertEquals(5, solver.levels());
  }
}
