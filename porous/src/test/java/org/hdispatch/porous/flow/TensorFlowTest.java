package org.hdispatch.porous.flow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.Random;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.porous.darcy.PermeabilityColumn;
import org.hdispatch.porous.darcy.PermeabilityTensor;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.PoreSpace;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class TensorFlowTest {
  private static final FlowOptions PERIODIC =
      FlowOptions.DEFAULT.withBoundaries(Sides.PERIODIC, Inlet.PERIODIC);

  private final Dispatcher dispatcher = Dispatcher.withWorkers(2);

  @AfterEach
  void close() {
    dispatcher.close();
  }

  private SteadyFlow solve(PoreSpace space, FlowOptions options) {
    return LbmFlow.solve(dispatcher, space, options, FlowListener.NONE);
  }

  private PermeabilityTensor tensor(PoreSpace space, FlowOptions options) {
    PermeabilityColumn[] columns = new PermeabilityColumn[3];
    for (Axis axis : Axis.values()) {
      SteadyFlow flow = solve(space, options.withAxis(axis));
      columns[axis.ordinal()] = flow.column().orElseThrow();
      assertEquals(flow.permeability(), columns[axis.ordinal()].entry(axis.ordinal()));
    }
    return new PermeabilityTensor(columns[0], columns[1], columns[2]);
  }

  /** Slits in the planes x - z = const, n diagonals wide, W = n/sqrt 2, half of the volume. */
  private static PoreSpace slits(int n) {
    return PoreSpace.of(2 * n, 3, 2 * n, (x, y, z) -> Math.floorMod(x - z, 2 * n) < n);
  }

  /**
   * k = phi W²/12 x [[1/2, 1/2], [1/2, 1/2]] across and along, and phi W²/12 along y. Half-way
   * bounce-back on the staircase of voxels gives 1 - 1/(8 W²) of it: the stairs are right on
   * average, and what is left is of second order.
   */
  @ParameterizedTest
  @CsvSource({"3, 2.12", "4, 2.83", "8, 5.66", "16, 11.3"})
  void slitsAt45DegreesHaveTheirTensorButForTheKnownErrorOfTheirStairs(int n, double width) {
    PermeabilityTensor k = tensor(slits(n), PERIODIC.withTolerance(1e-7));
    double exact = 0.5 * n * n / 2 / 12;
    double stairs = 1 - 1 / (4.0 * n * n);
    assertEquals(width * width, n * n / 2.0, 0.01 * n * n);
    double[][] expected = {{0.5, 0, 0.5}, {0, 1, 0}, {0.5, 0, 0.5}};
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        double part = stairs * expected[row][column];
        assertEquals(part, k.entry(row, column) / exact, 2e-6, row + ", " + column);
      }
    }
    assertEquals(stairs * exact, k.principal().get(0).value(), 2e-6 * exact);
    assertEquals(0, k.principal().get(2).value(), 2e-6 * exact);
  }

  /** D3Q15 is the same across and along the stairs, and errs by 7/(4 W²) the other way beside. */
  @Test
  void stairsOfD3Q15CountMoreAlongTheirEdges() {
    FlowOptions options = PERIODIC.withTolerance(1e-7).withVelocitySet(VelocitySet.D3Q15);
    PermeabilityTensor k = tensor(slits(8), options);
    double exact = 0.5 * 32 / 12;
    assertEquals(0.5 * (1 - 1.0 / 256), k.entry(2, 0) / exact, 2e-6);
    assertEquals(1 + 3.5 / 64, k.entry(1, 1) / exact, 2e-6);
  }

  @ParameterizedTest
  @EnumSource(Axis.class)
  void particlesFindTheColumnTooWithinTheirOwnError(Axis axis) {
    SteadyFlow flow =
        SphFlow.solve(
            dispatcher,
            PoreSpace.of(12, 6, 12, (x, y, z) -> Math.floorMod(x - z, 12) < 6),
            PERIODIC.withAxis(axis).withTolerance(1e-2),
            SphOptions.DEFAULT,
            FlowListener.NONE);
    PermeabilityColumn column = flow.column().orElseThrow();
    double exact = 0.5 * 18 / 12;
    double inPlane = axis == Axis.Y ? 0 : 0.5;
    assertEquals(inPlane, column.x() / exact, 0.01); // the tolerance, found 0.006
    assertEquals(inPlane, column.z() / exact, 0.01);
    assertEquals(axis == Axis.Y ? 1 : 0, column.y() / exact, 0.02);
  }

  /** Random boxes of pore from a fixed seed, made periodic: not symmetric in any way. */
  private static PoreSpace maze() {
    int nx = 15;
    int ny = 13;
    int nz = 16;
    boolean[] pore = new boolean[nx * ny * nz];
    Random random = new Random(2011);
    for (int box = 0; box < 40; box++) {
      int x0 = random.nextInt(nx);
      int y0 = random.nextInt(ny);
      int z0 = random.nextInt(nz);
      for (int z = z0; z < z0 + 6; z++) {
        for (int y = y0; y < y0 + 5; y++) {
          for (int x = x0; x < x0 + 4; x++) {
            pore[x % nx + nx * (y % ny + ny * (z % nz))] = true;
          }
        }
      }
    }
    return PoreSpace.of(nx, ny, nz, (x, y, z) -> pore[x + nx * (y + ny * z)]);
  }

  /**
   * Stokes flow is reciprocal, and so is the lattice's: what is left is the error of the columns.
   */
  @Test
  void tensorOfPeriodicRockIsSymmetricAndPositive() {
    PermeabilityTensor k = tensor(maze(), PERIODIC.withTolerance(1e-6));
    assertTrue(Math.abs(k.entry(0, 2)) > 1e-3 * k.entry(0, 0), "it has something to be symmetric");
    assertEquals(0, k.asymmetry(), 1e-6);
    assertTrue(k.principal().get(2).value() > 0);
  }

  @Test
  void columnHasTheSameBitsForAnyNumberOfWorkers() {
    SteadyFlow flow = solve(maze(), PERIODIC.withTolerance(0.05));
    for (int workers : new int[] {1, 3}) {
      try (Dispatcher other = Dispatcher.withWorkers(workers)) {
        SteadyFlow same =
            LbmFlow.solve(other, maze(), PERIODIC.withTolerance(0.05), FlowListener.NONE);
        assertEquals(flow.column(), same.column());
      }
    }
  }

  @Test
  void flowAcrossNeedsPeriodicSides() {
    PoreSpace solid = PoreSpace.of(6, 6, 6, (x, y, z) -> z != 3);
    for (Sides sides : Sides.values()) {
      boolean periodic = sides == Sides.PERIODIC;
      FlowOptions options = FlowOptions.DEFAULT.withBoundaries(sides, Inlet.PERIODIC);
      assertEquals(
          periodic ? Optional.of(PermeabilityColumn.ZERO) : Optional.empty(),
          solve(solid, options).column());
      SteadyFlow flow = solve(maze(), options.withTolerance(0.3));
      assertEquals(periodic, flow.column().isPresent());
    }
  }
}
