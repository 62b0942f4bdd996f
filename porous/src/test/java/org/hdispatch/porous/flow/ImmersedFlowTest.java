package org.hdispatch.porous.flow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.LoopStats;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.pore.PoreSpace;
import org.hdispatch.porous.pore.SpherePacking;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class ImmersedFlowTest {
  private static final FlowOptions PERIODIC =
      FlowOptions.IMMERSED.withBoundaries(Sides.PERIODIC, Inlet.PERIODIC);

  /** Zick and Homsy, J. Fluid Mech. 115, 1982, 13, Table 2; simple cubic, 20³ voxels. */
  @ParameterizedTest
  @CsvSource({"0.125, 4.292", "0.343, 15.4"})
  void spheresAreRightToOnePercent(double solidFraction, double drag) {
    int n = 20;
    double radius = Math.cbrt(3 * solidFraction / (4 * Math.PI));
    double exact = n * n / (6 * Math.PI * drag * radius);
    SolidFractions spheres = SolidFractions.of(SpherePacking.SC, n, solidFraction);
    SteadyFlow flow = solve(spheres, PERIODIC.withAxis(Axis.X).withTolerance(1e-4));
    assertTrue(flow.converged());
    assertEquals(0, flow.permeability() / exact - 1, 0.012);
    assertEquals(0.6, flow.chosen().relaxationTime());
    for (LoopStats.WorkerStats worker : flow.work().stats().workers()) {
      // Nothing, but for HotSpot: when C2 is first asked to compile a method of a class, the thread
      // that asks makes all string constants of that class. 1344 bytes are those of the hash map.
      long bytes = worker.allocatedBytes();
      assertTrue(bytes < 2_048, "bytes=" + bytes);
    }
    double mean = 0;
    FlowField field = flow.field().orElseThrow();
    for (float u : field.velocity(Axis.X)) {
      mean += u;
    }
    assertEquals(1, mean / (n * n * n) / flow.permeability(), 1e-4); // single precision
  }

  /** Voxels that are solid in part are pore in part. */
  @ParameterizedTest
  @CsvSource({"12, 0.02", "20, 0.343"})
  void allOfASpherePacksPoreVolumeIsConnected(int size, double solidFraction) {
    SolidFractions spheres = SolidFractions.of(SpherePacking.SC, size, solidFraction);
    SteadyFlow flow = solve(spheres, PERIODIC.withTolerance(0.1));
    assertEquals(1 - solidFraction, flow.porosity(), 1e-6); // single precision
    assertEquals(flow.porosity(), flow.connectedPorosity(), 1e-6);
    assertTrue(flow.percolation().connectedPorosity() > flow.connectedPorosity());
  }

  @ParameterizedTest
  @CsvSource({"0.02, PERIODIC", "0.343, PERIODIC", "0.52, PERIODIC", "0.1, SLAB", "0.52, SLAB"})
  void estimateOfTheHeapLiesUpTo20PercentAboveWhatIsHeld(double solidFraction, Inlet inlet) {
    int n = 48;
    SolidFractions spheres = SolidFractions.of(SpherePacking.SC, n, solidFraction);
    FlowOptions options = FlowOptions.IMMERSED.withBoundaries(Sides.PERIODIC, inlet);
    FlowDomain domain = new FlowDomain(spheres.below(1), spheres, options);
    LbmScheme scheme = LbmScheme.on(domain.lattice()).velocitySet(options.velocitySet()).build();
    long clear = n * n * n - spheres.coveredVoxels();
    long covered = domain.rockNodes() - clear;
    long perVoxel = 4 + 4 + 1 + 4 * 4; // fractions, twice, pore space, field
    long held = scheme.bytes() + 4 * scheme.nodes() + 40 * covered + perVoxel * n * n * n;
    double ratio = (double) LbmFlow.estimatedBytes(spheres, options) / held;
    assertTrue(ratio > 1 && ratio < 1.2, "ratio=" + ratio);
  }

  @ParameterizedTest
  @EnumSource(SpherePacking.class)
  void fractionsOfSpheresAddUp(SpherePacking packing) {
    for (int size : new int[] {5, 12, 21}) {
      for (double c : new double[] {0.1, packing.closePacking()}) {
        SolidFractions solid = SolidFractions.of(packing, size, c);
        assertEquals(1 - c, solid.porosity(), 1e-6); // single precision
      }
    }
  }

  /** A slot with walls and slabs: fractions of a half narrow it by half a voxel at each side. */
  @Test
  void greyWallsNarrowASlot() {
    int width = 14;
    byte[] grey = new byte[width * 6];
    for (int voxel = 0; voxel < grey.length; voxel++) {
      int x = voxel % width;
      int solid = Math.min(x, width - 1 - x) < 2 ? 200 : Math.min(x, width - 1 - x) == 2 ? 125 : 50;
      grey[voxel] = (byte) solid;
    }
    VoxelImage image = VoxelImage.of(width, 1, 6, grey);
    SolidFractions solid = SolidFractions.ofGrey(image, 50, 200);
    assertEquals(9.0 / width, solid.porosity(), 1e-6);
    double k = solve(solid, PERIODIC.withTolerance(1e-4)).permeability();
    assertEquals(9, Math.cbrt(12 * width * k), 0.05); // k = w³ / (12 width)
    FlowOptions slabs = PERIODIC.withBoundaries(Sides.PERIODIC, Inlet.SLAB);
    assertTrue(solve(solid, slabs).converged());
  }

  @Test
  void solidDoesNotPercolate() {
    SolidFractions solid = SolidFractions.of(PoreSpace.of(4, 4, 4, (x, y, z) -> z != 2));
    SteadyFlow flow = solve(solid, FlowOptions.IMMERSED);
    assertEquals(0, flow.permeability());
    assertEquals(0.75, flow.porosity(), 1e-6);
  }

  @Test
  void refusesGreyValuesThatDoNotDiffer() {
    VoxelImage image = VoxelImage.of(1, 1, 1, new byte[1]);
    assertThrows(IllegalArgumentException.class, () -> SolidFractions.ofGrey(image, 7, 7));
    assertThrows(IllegalArgumentException.class, () -> SolidFractions.ofGrey(image, 0, 256));
  }

  private static SteadyFlow solve(SolidFractions solid, FlowOptions options) {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      return LbmFlow.solve(dispatcher, solid, options, FlowListener.NONE);
    }
  }
}
