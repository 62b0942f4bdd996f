package org.hdispatch.porous.flow;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.PoreSpace;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class SphFlowTest {
  private static final FlowOptions COARSE = FlowOptions.DEFAULT.withTolerance(1e-2);

  /** A bent pore of 6 x 6 voxels, wider in its middle; along z. */
  private static final PoreSpace BENT =
      PoreSpace.of(
          12,
          10,
          14,
          (x, y, z) -> {
            int left = z < 6 ? 2 : 4;
            int width = z >= 5 && z <= 8 ? 8 : 6;
            return x >= left && x < Math.min(12, left + width) && y >= 2 && y < 8;
          });

  private static SteadyFlow solve(PoreSpace space, FlowOptions options, int workers) {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(workers)) {
      return SphFlow.solve(dispatcher, space, options, SphOptions.DEFAULT, FlowListener.NONE);
    }
  }

  @Test
  void whatDoesNotSpanHasPermeabilityZero() {
    PoreSpace twoChambers = PoreSpace.of(6, 6, 9, (x, y, z) -> z != 4);
    SteadyFlow flow = solve(twoChambers, COARSE, 2);
    assertEquals(0, flow.permeability());
    assertFalse(flow.percolation().percolates());
    assertTrue(flow.particles().isEmpty());
  }

  @ParameterizedTest
  @EnumSource(Axis.class)
  void openBoxWithWallsIsADuct(Axis axis) {
    PoreSpace open = PoreSpace.of(12, 12, 12, (x, y, z) -> true);
    SteadyFlow flow = solve(open, COARSE.withAxis(axis).withInletLayers(2), 2);
    assertTrue(flow.converged());
    // Series 0.0351442537 W²; the stop rule allows 1 %, 12 particles across err by less.
    assertEquals(1, flow.permeability() / (0.0351442537 * 12 * 12), 0.015);
    assertEquals(0, flow.fluxImbalance(), 1e-3);
  }

  @Test
  void bentPoreIsThatOfTheLatticeBoltzmannMethod() {
    SteadyFlow flow = solve(BENT, COARSE, 2);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      SteadyFlow lattice = LbmFlow.solve(dispatcher, BENT, COARSE, FlowListener.NONE);
      assertTrue(flow.converged());
      // Six voxels across, two methods that both err by percents there.
      assertEquals(1, flow.permeability() / lattice.permeability(), 0.15);
    }
    FlowField field = flow.field().orElseThrow();
    double sum = 0;
    for (float along : field.velocity(Axis.Z)) {
      sum += along;
    }
    // The mean of the field along the flow is k; particles stand for the volume of a voxel.
    assertEquals(flow.permeability(), sum / BENT.voxels(), 1e-6 * flow.permeability());
  }

  @Test
  void stopIsWithinTheToleranceOfFiveTimesTheSteps() {
    SteadyFlow flow = solve(BENT, COARSE, 2);
    long steps = flow.work().steps();
    SteadyFlow later = solve(BENT, COARSE.withTolerance(1e-9).withMaxSteps(5 * steps), 2);
    assertEquals(5 * steps, later.work().steps());
    assertTrue(flow.converged());
    assertEquals(1, flow.permeability() / later.permeability(), 0.01); // the tolerance
    assertTrue(steps <= 300, "steps " + steps);
  }

  @Test
  void sameBitsForAnyWorkerCount() {
    SteadyFlow one = solve(BENT, COARSE.withMaxSteps(60), 1);
    SteadyFlow three = solve(BENT, COARSE.withMaxSteps(60), 3);
    assertEquals(one.permeability(), three.permeability());
    for (Axis axis : Axis.values()) {
      assertArrayEquals(
          one.field().orElseThrow().velocity(axis), three.field().orElseThrow().velocity(axis));
    }
  }

  /** A particle would see another and its image. */
  @Test
  void refusesAPeriodicRockShorterThanParticlesReach() {
    FlowOptions periodic = COARSE.withBoundaries(Sides.PERIODIC, Inlet.PERIODIC);
    PoreSpace thin = PoreSpace.of(8, 3, 8, (x, y, z) -> x > 1);
    String message =
        assertThrows(IllegalArgumentException.class, () -> solve(thin, periodic, 1)).getMessage();
    assertTrue(message.endsWith("axis=Y, length=3 voxels, reach=3.1 voxels"), message);
    SphOptions wide = new SphOptions(2, 4);
    PoreSpace cube = PoreSpace.of(6, 8, 8, (x, y, z) -> x > 1);
    assertThrows(
        IllegalArgumentException.class, () -> SphFlow.estimatedBytes(cube, periodic, wide));
  }

  /** Lists of neighbours grow as h^3: cells hold 372 bytes a particle at h = 1, 1124 at 2. */
  @Test
  void estimateOfTheHeapCountsListsAndWalls() {
    FlowOptions periodic = COARSE.withBoundaries(Sides.PERIODIC, Inlet.PERIODIC);
    PoreSpace half = PoreSpace.of(16, 16, 16, (x, y, z) -> x < 8);
    int voxels = 16 * 16 * 16;
    long narrow = SphFlow.estimatedBytes(half, periodic, SphOptions.DEFAULT);
    long wide = SphFlow.estimatedBytes(half, periodic, new SphOptions(2, 4));
    assertTrue(narrow > 372 * voxels && wide > 1124 * voxels, narrow + " " + wide);
    assertTrue(wide - narrow > (1124 - 372) * voxels, narrow + " " + wide);
    FlowOptions walled = COARSE.withBoundaries(Sides.WALL, Inlet.PERIODIC);
    long withWalls = SphFlow.estimatedBytes(half, walled, SphOptions.DEFAULT);
    int layers = 16 * (22 * 22 - 16 * 16); // three on each side
    assertTrue(withWalls - narrow > 372 * layers, narrow + " " + withWalls);
  }

  @Test
  void refusesFacesThatParticlesDoNotHave() {
    IllegalArgumentException mirror =
        assertThrows(
            IllegalArgumentException.class,
            () -> solve(BENT, COARSE.withBoundaries(Sides.MIRROR, Inlet.SLAB), 1));
    assertTrue(mirror.getMessage().contains("sides=MIRROR"), mirror.getMessage());
    assertThrows(
        IllegalArgumentException.class,
        () -> solve(BENT, COARSE.withBoundaries(Sides.WALL, Inlet.PRESSURE), 1));
  }
}
