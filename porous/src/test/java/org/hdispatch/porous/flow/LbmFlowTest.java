package org.hdispatch.porous.flow;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.PoreSpace;
import org.hdispatch.porous.pore.SpherePacking;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class LbmFlowTest {
  private static SteadyFlow solve(PoreSpace space, FlowOptions options) {
    return solve(space, options, 2);
  }

  private static SteadyFlow solve(PoreSpace space, FlowOptions options, int workers) {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(workers)) {
      return LbmFlow.solve(dispatcher, space, options, FlowListener.NONE);
    }
  }

  /** Overlapping boxes of pore, from a fixed seed; not symmetric in any way. */
  private static PoreSpace maze(int nx, int ny, int nz) {
    boolean[] pore = new boolean[nx * ny * nz];
    Random random = new Random(2011);
    for (int box = 0; box < 40; box++) {
      int x0 = random.nextInt(nx);
      int y0 = random.nextInt(ny);
      int z0 = random.nextInt(nz);
      for (int z = z0; z < Math.min(nz, z0 + 7); z++) {
        for (int y = y0; y < Math.min(ny, y0 + 6); y++) {
          for (int x = x0; x < Math.min(nx, x0 + 5); x++) {
            pore[x + nx * (y + ny * z)] = true;
          }
        }
      }
    }
    return PoreSpace.of(nx, ny, nz, (x, y, z) -> pore[x + nx * (y + ny * z)]);
  }

  @Test
  void whatDoesNotSpanHasPermeabilityZero() {
    PoreSpace twoChambers = PoreSpace.of(6, 6, 9, (x, y, z) -> z != 4);
    SteadyFlow flow = solve(twoChambers, FlowOptions.DEFAULT);
    assertEquals(0, flow.permeability());
    assertFalse(flow.percolation().percolates());
    assertTrue(flow.converged());
    assertEquals(0, flow.work().steps());
    assertTrue(flow.field().isEmpty());
    assertEquals(8.0 / 9, flow.porosity(), 1e-15);
  }

  @ParameterizedTest
  @EnumSource(Axis.class)
  void openBoxWithWallsIsADuct(Axis axis) {
    PoreSpace open = PoreSpace.of(12, 12, 12, (x, y, z) -> true);
    SteadyFlow flow =
        solve(open, FlowOptions.DEFAULT.withAxis(axis).withInletLayers(3).withTolerance(1e-5));
    // Series solution 0.0351442537 W², plus the O(1/W²) error of the lattice: 1 % at W = 12.
    assertEquals(0.0351442537 * 144, flow.permeability(), 0.012 * 0.0351442537 * 144);
    assertTrue(flow.converged());
    assertTrue(flow.errorEstimate() <= 1e-5);
  }

  @Test
  void fluidWithoutAnyWallIsRefused() {
    PoreSpace open = PoreSpace.of(8, 8, 8, (x, y, z) -> true);
    FlowOptions periodic = FlowOptions.DEFAULT.withBoundaries(Sides.PERIODIC, Inlet.SLAB);
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> solve(open, periodic));
    assertTrue(e.getMessage().startsWith("pore space must have a wall"), e.getMessage());
  }

  @Test
  void permeabilityTurnsWithTheRock() {
    PoreSpace rock = maze(14, 12, 16);
    PoreSpace turned = PoreSpace.of(16, 14, 12, (x, y, z) -> rock.isPore(y, z, x));
    FlowOptions options = FlowOptions.DEFAULT.withTolerance(1e-3).withRelaxationTime(1);
    SteadyFlow alongZ = solve(rock, options.withAxis(Axis.Z));
    SteadyFlow alongX = solve(turned, options.withAxis(Axis.X));
    assertEquals(alongZ.work().steps(), alongX.work().steps());
    // Sums run over the nodes in another order: round-off only.
    assertEquals(alongZ.permeability(), alongX.permeability(), 1e-11 * alongZ.permeability());
  }

  @Test
  void sameBitsForAnyNumberOfWorkers() {
    PoreSpace rock = maze(25, 22, 24);
    FlowOptions options =
        FlowOptions.DEFAULT.withTolerance(0.05).withVelocitySet(VelocitySet.D3Q15);
    SteadyFlow one = solve(rock, options, 1);
    for (int workers : new int[] {2, 3}) {
      SteadyFlow many = solve(rock, options, workers);
      assertEquals(one.permeability(), many.permeability());
      assertEquals(one.errorEstimate(), many.errorEstimate());
      for (Axis component : Axis.values()) {
        assertArrayEquals(
            one.field().orElseThrow().velocity(component),
            many.field().orElseThrow().velocity(component));
      }
      assertArrayEquals(
          one.field().orElseThrow().pressure(), many.field().orElseThrow().pressure());
    }
  }

  @Test
  void fieldCarriesTheFluxAndThePressureDrop() {
    PoreSpace open = PoreSpace.of(10, 10, 20, (x, y, z) -> true);
    SteadyFlow flow = solve(open, FlowOptions.DEFAULT.withInletLayers(2).withTolerance(1e-6));
    FlowField field = flow.field().orElseThrow();
    double sum = 0;
    for (float u : field.velocity(Axis.Z)) {
      sum += u;
    }
    assertEquals(flow.permeability(), sum / open.voxels(), 1e-6 * flow.permeability()); // float
    float[] p = field.pressure();
    assertEquals(0, p[open.index(5, 5, 0)], 1e-4);
    // The slabs are a duct like the rock, but for the O(1/W²) error of the lattice.
    assertEquals(-10, p[open.index(5, 5, 10)] - p[open.index(5, 5, 0)], 0.03);
  }

  @Test
  void isolatedPoresChangeNothingButThePorosity() {
    PoreSpace tube = PoreSpace.of(14, 14, 10, (x, y, z) -> x > 1 && x < 8 && y > 1 && y < 8);
    PoreSpace withVug =
        PoreSpace.of(
            14, 14, 10, (x, y, z) -> tube.isPore(x, y, z) || x > 9 && y > 9 && z > 3 && z < 7);
    FlowOptions options = FlowOptions.DEFAULT.withRelaxationTime(1);
    SteadyFlow plain = solve(tube, options);
    SteadyFlow vuggy = solve(withVug, options);
    assertEquals(plain.permeability(), vuggy.permeability());
    assertTrue(vuggy.porosity() > plain.porosity());
    assertEquals(plain.porosity(), vuggy.percolation().connectedPorosity());
    assertEquals(4 * 4 * 3, vuggy.percolation().isolatedPoreVoxels());
  }

  @Test
  void givesUpAfterTheStepsAllowedAndSaysSo() {
    SteadyFlow flow =
        solve(maze(14, 12, 16), FlowOptions.DEFAULT.withTolerance(1e-9).withMaxSteps(130));
    assertEquals(130, flow.work().steps());
    assertFalse(flow.converged());
    assertTrue(flow.permeability() > 0);
  }

  @Test
  void endsWhereTheListenerHasEnough() {
    List<FlowListener.Progress> heard = new ArrayList<>();
    FlowListener two =
        new FlowListener() {
          @Override
          public void progressed(Progress progress) {
            heard.add(progress);
          }

          @Override
          public boolean enough() {
            return heard.size() == 2;
          }
        };
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      FlowOptions options = FlowOptions.DEFAULT.withTolerance(1e-9);
      SteadyFlow flow = LbmFlow.solve(dispatcher, maze(14, 12, 16), options, two);
      assertEquals(heard.get(1).step(), flow.work().steps());
      assertEquals(heard.get(1).permeability(), flow.permeability());
      assertEquals(1, heard.get(1).corrections()); // the second follows the measurement
      assertTrue(heard.get(1).secondsPressure() > heard.get(0).secondsPressure());
      assertFalse(flow.converged());
      heard.clear();
      LbmFlow.solve(dispatcher, maze(14, 12, 16), options.withApproach(Approach.PLAIN), two);
      assertEquals(0, heard.get(1).secondsPressure());
    }
  }

  @Test
  void listenerHearsOfTheStartTheWarmUpEveryMeasurementAndTheEnd() {
    List<String> heard = new ArrayList<>();
    FlowListener listener =
        new FlowListener() {
          @Override
          public void started(Start start) {
            heard.add("start");
            assertEquals(0.9, start.relaxationTime());
          }

          @Override
          public void warmedUp() {
            heard.add("warm");
          }

          @Override
          public void progressed(Progress progress) {
            heard.add("at " + progress.step());
          }

          @Override
          public void stepped() {
            heard.add("end");
          }
        };
    FlowOptions options =
        FlowOptions.DEFAULT.withMaxSteps(130).withTolerance(1e-12).withRelaxationTime(0.9);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      LbmFlow.solve(dispatcher, maze(14, 12, 16), options, listener);
      LbmFlow.solve(dispatcher, maze(14, 12, 16), options.withApproach(Approach.PLAIN), listener);
    }
    List<String> corrected =
        List.of("at 20", "at 40", "at 60", "at 80", "at 100", "warm", "at 120", "at 130");
    List<String> plain = List.of("at 50", "at 100", "warm", "at 130");
    List<String> expected = new ArrayList<>();
    for (List<String> each : List.of(corrected, plain)) {
      expected.add("start");
      expected.addAll(each);
      expected.add("end");
    }
    assertEquals(expected, heard);
  }

  @Test
  void slabsAreAsWideAsThePoresUnlessAskedFor() {
    PoreSpace tube = PoreSpace.of(12, 12, 8, (x, y, z) -> x > 0 && x < 11 && y > 0 && y < 11);
    FlowOptions options = FlowOptions.DEFAULT.withMaxSteps(1);
    SteadyFlow flow = solve(tube, options);
    // 10 x 10: 4 volume/surface = 10, and 3/2 of it where all faces lie along the axes.
    assertEquals(15, flow.chosen().hydraulicDiameter(), 1e-12);
    assertEquals(12, flow.chosen().inletLayers());
    assertEquals(3, solve(tube, options.withInletLayers(3)).chosen().inletLayers());
    FlowOptions periodic = options.withBoundaries(Sides.WALL, Inlet.PERIODIC);
    assertEquals(0, solve(tube, periodic).chosen().inletLayers());
  }

  /** The tolerance is kept by the true error, at fitting and at unfitting tau, tight and loose. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.502, 0.52, 0.6, 1, 3})
  void trueErrorIsBelowTheTolerance(double tau) {
    PoreSpace rock = maze(14, 12, 16);
    double truth = solve(rock, FlowOptions.DEFAULT.withTolerance(1e-6)).permeability();
    for (double tolerance : new double[] {0.3, 0.1, 1e-2, 1e-3}) {
      FlowOptions options = FlowOptions.DEFAULT.withTolerance(tolerance);
      SteadyFlow flow = solve(rock, tau == 0 ? options : options.withRelaxationTime(tau));
      assertTrue(flow.converged());
      double error = Math.abs(flow.permeability() / truth - 1);
      assertTrue(error <= tolerance, "tolerance " + tolerance + ", error " + error);
    }
  }

  @Test
  void tauIsChosenLowInTightAndHighInOpenRock() {
    FlowOptions periodic = FlowOptions.DEFAULT.withBoundaries(Sides.PERIODIC, Inlet.PERIODIC);
    for (Approach approach : Approach.values()) {
      FlowOptions one = FlowOptions.DEFAULT.withMaxSteps(1).withApproach(approach);
      double tight = solve(maze(14, 12, 40), one).chosen().relaxationTime();
      double open =
          solve(
                  SpherePacking.SC.poreSpace(32, 0.125),
                  periodic.withMaxSteps(1).withApproach(approach))
              .chosen()
              .relaxationTime();
      // Where pressure is corrected, only the width of the pores counts.
      boolean asExpected = approach == Approach.PLAIN ? tight < 1 : tight == 3;
      assertTrue(asExpected && open > 5, approach + ": tight " + tight + ", open " + open);
    }
  }

  /** Two clusters that nothing connects: a wide and a narrow square duct, periodic along z. */
  @Test
  void correctsThePressureOfEachClusterByItself() {
    PoreSpace ducts =
        PoreSpace.of(
            14,
            10,
            6,
            (x, y, z) -> x >= 1 && x <= 8 && y >= 1 && y <= 8 || x >= 10 && x <= 12 && y <= 2);
    FlowOptions options =
        FlowOptions.DEFAULT.withBoundaries(Sides.WALL, Inlet.PERIODIC).withTolerance(1e-6);
    SteadyFlow corrected = solve(ducts, options);
    SteadyFlow plain = solve(ducts, options.withApproach(Approach.PLAIN));
    assertTrue(corrected.converged() && plain.converged());
    assertEquals(1, corrected.permeability() / plain.permeability(), 2e-6); // the two estimates
  }

  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void correctedAndPlainFindTheSameFlow(VelocitySet set) {
    PoreSpace rock = maze(14, 12, 40);
    long few = 0;
    long many = 0;
    for (Sides sides : Sides.values()) {
      for (Inlet inlet : Inlet.values()) {
        FlowOptions options =
            FlowOptions.DEFAULT
                .withVelocitySet(set)
                .withBoundaries(sides, inlet)
                .withTolerance(1e-5);
        SteadyFlow corrected = solve(rock, options);
        SteadyFlow plain = solve(rock, options.withApproach(Approach.PLAIN));
        String text = sides + " " + inlet;
        assertTrue(corrected.converged() && plain.converged(), text);
        // The two estimates, and what is left of the mode that alternates from step to step.
        assertEquals(1, corrected.permeability() / plain.permeability(), 3e-5, text);
        few += corrected.work().steps();
        many += plain.work().steps();
        assertTrue(corrected.corrections().orElseThrow().helpful(), text);
        assertTrue(plain.corrections().isEmpty(), text);
      }
    }
    assertTrue(2 * few < many, few + " and " + many + " steps with all boundaries");
  }

  /** As much mass flows through every section. */
  @ParameterizedTest
  @EnumSource(Approach.class)
  void singlePrecisionFindsTheSamePermeability(Approach approach) {
    PoreSpace rock = maze(24, 20, 22);
    for (Inlet inlet : Inlet.values()) {
      FlowOptions options =
          FlowOptions.DEFAULT
              .withApproach(approach)
              .withTolerance(1e-3)
              .withBoundaries(Sides.MIRROR, inlet);
      SteadyFlow inDouble = solve(rock, options);
      SteadyFlow inSingle = solve(rock, options.withStorage(Storage.SINGLE));
      assertTrue(inSingle.converged());
      // populations of 1e-3 rounded to 24 bits, k from differences of some of them
      assertEquals(1, inSingle.permeability() / inDouble.permeability(), 2e-5);
    }
  }

  /** At every measurement, not only at the last one. */
  @ParameterizedTest
  @EnumSource(Axis.class)
  void estimateIsAboveTheTrueErrorAllTheWay(Axis axis) {
    List<FlowListener.Progress> course = new ArrayList<>();
    FlowListener listener =
        new FlowListener() {
          @Override
          public void progressed(Progress progress) {
            course.add(progress);
          }
        };
    double truth;
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      FlowOptions options = FlowOptions.DEFAULT.withAxis(axis).withTolerance(1e-6);
      truth = LbmFlow.solve(dispatcher, maze(18, 16, 17), options, listener).permeability();
    }
    for (FlowListener.Progress progress : course) {
      double error = Math.abs(progress.permeability() / truth - 1);
      assertTrue(error <= progress.errorEstimate(), error + " at " + progress);
    }
    assertTrue(course.get(course.size() - 1).errorEstimate() <= 1e-6);
  }

  @Test
  void reportsHowTheFluxIsBalanced() {
    SteadyFlow flow = solve(maze(14, 12, 16), FlowOptions.DEFAULT.withTolerance(1e-4));
    assertTrue(flow.fluxImbalance() > 0 && flow.fluxImbalance() < 1e-3);
  }
}
