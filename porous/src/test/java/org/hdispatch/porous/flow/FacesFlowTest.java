package org.hdispatch.porous.flow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.pore.Percolation;
import org.hdispatch.porous.pore.PoreSpace;
import org.hdispatch.porous.pore.SpherePacking;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Mirrors at the sides, pressure at the ends. */
class FacesFlowTest {
  private static final int NX = 12;
  private static final int NY = 10;
  private static final int NZ = 14;

  private static final FlowOptions MIRRORED =
      FlowOptions.DEFAULT.withBoundaries(Sides.MIRROR, Inlet.PRESSURE).withRelaxationTime(1);
  private static final FlowOptions PERIODIC =
      MIRRORED.withBoundaries(Sides.PERIODIC, Inlet.PERIODIC);

  private static SteadyFlow solve(PoreSpace space, FlowOptions options) {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      return LbmFlow.solve(dispatcher, space, options, FlowListener.NONE);
    }
  }

  /** Grey values of overlapping boxes of pore, from a fixed seed; not symmetric in any way. */
  private static byte[] rubble() {
    byte[] grey = new byte[NX * NY * NZ];
    Random random = new Random(2011);
    for (int box = 0; box < 30; box++) {
      int x0 = random.nextInt(NX);
      int y0 = random.nextInt(NY);
      int z0 = random.nextInt(NZ);
      for (int z = z0; z < Math.min(NZ, z0 + 6); z++) {
        for (int y = y0; y < Math.min(NY, y0 + 4); y++) {
          for (int x = x0; x < Math.min(NX, x0 + 5); x++) {
            grey[x + NX * (y + NY * z)] += 1;
          }
        }
      }
    }
    return grey;
  }

  /** The rubble, pore where its grey value is not 0. */
  private static PoreSpace rock() {
    byte[] grey = rubble();
    return PoreSpace.of(NX, NY, NZ, (x, y, z) -> grey[x + NX * (y + NY * z)] > 0);
  }

  private static int fold(int coordinate, int extent) {
    return coordinate < extent ? coordinate : 2 * extent - 1 - coordinate;
  }

  /** A rock beside its mirror image along each axis: eight times the voxels. */
  private static PoreSpace doubled(PoreSpace rock) {
    return PoreSpace.of(
        2 * NX, 2 * NY, 2 * NZ, (x, y, z) -> rock.isPore(fold(x, NX), fold(y, NY), fold(z, NZ)));
  }

  /** After the same steps, not only in the end; the field is that of the rock's own box. */
  @ParameterizedTest
  @EnumSource(Axis.class)
  void mirrorsGiveWhatTheMirroredImageGives(Axis axis) {
    SteadyFlow whole =
        solve(
            doubled(rock()),
            PERIODIC.withAxis(axis).withApproach(Approach.PLAIN).withTolerance(1e-4));
    SteadyFlow part =
        solve(
            rock(),
            MIRRORED
                .withAxis(axis)
                .withApproach(Approach.PLAIN)
                .withTolerance(1e-12)
                .withMaxSteps(whole.work().steps()));
    assertTrue(whole.converged() && part.permeability() > 0.01);
    assertEquals(1, part.permeability() / whole.permeability(), 1e-10);
    assertEquals(whole.porosity(), part.porosity(), 1e-15);
    FlowField exact = whole.field().orElseThrow();
    FlowField found = part.field().orElseThrow();
    assertEquals(NX, found.nx());
    for (int voxel = 0; voxel < NX * NY * NZ; voxel++) {
      int x = voxel % NX;
      int y = voxel / NX % NY;
      int z = voxel / (NX * NY);
      int there = x + 2 * NX * (y + 2 * NY * z);
      assertEquals(exact.pressure()[there], found.pressure()[voxel], 1e-4); // single precision
      for (Axis component : Axis.values()) {
        assertEquals(exact.velocity(component)[there], found.velocity(component)[voxel], 1e-6);
      }
    }
  }

  /** No cluster spans the mirrored image that does not span the rock from face to face. */
  @ParameterizedTest
  @EnumSource(Axis.class)
  void whatSpansIsWhatSpansInTheMirroredImage(Axis axis) {
    int spanning = 0;
    for (int seed = 0; seed < 100; seed++) {
      Random random = new Random(seed);
      boolean[] pore = new boolean[NX * NY * NZ];
      for (int voxel = 0; voxel < pore.length; voxel++) {
        pore[voxel] = random.nextInt(100) < 33; // near the threshold
      }
      PoreSpace rock = PoreSpace.of(NX, NY, NZ, (x, y, z) -> pore[x + NX * (y + NY * z)]);
      int part =
          Percolation.along(rock, axis, Sides.MIRROR.ends(), Inlet.PRESSURE.ends())
              .connected()
              .poreVoxels();
      int whole =
          Percolation.along(doubled(rock), axis, Ends.PERIODIC, Ends.PERIODIC)
              .connected()
              .poreVoxels();
      assertEquals(whole, 8 * part, "seed=" + seed);
      spanning += part > 0 ? 1 : 0;
    }
    assertTrue(spanning > 10 && spanning < 90, "spanning=" + spanning);
  }

  /** Symmetric themselves, they are their mirror image. */
  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void spheresGiveTheSameMirroredAndPeriodic(VelocitySet set) {
    PoreSpace spheres = SpherePacking.SC.poreSpace(16, 0.216);
    SteadyFlow periodic = solve(spheres, PERIODIC.withVelocitySet(set).withTolerance(1e-5));
    SteadyFlow mirrored = solve(spheres, MIRRORED.withVelocitySet(set).withTolerance(1e-5));
    assertTrue(mirrored.converged());
    assertEquals(1, mirrored.permeability() / periodic.permeability(), 1e-6);
  }

  @Test
  void pressureAtTheEndsOfADuctMakesNoDifference() {
    PoreSpace open = PoreSpace.of(10, 8, 12, (x, y, z) -> true);
    FlowOptions duct = MIRRORED.withTolerance(1e-8);
    double endless = solve(open, duct.withBoundaries(Sides.WALL, Inlet.PERIODIC)).permeability();
    SteadyFlow flow = solve(open, duct.withBoundaries(Sides.WALL, Inlet.PRESSURE));
    assertEquals(1, flow.permeability() / endless, 1e-7);
    assertEquals(0, flow.chosen().inletLayers());
    float[] p = flow.field().orElseThrow().pressure();
    assertEquals(-11, p[open.index(5, 5, 11)] - p[open.index(5, 5, 0)], 1e-4);
  }

  /** Stokes flow may be turned round. */
  @Test
  void permeabilityIsTheSameFromBothEnds() {
    PoreSpace rock = rock();
    PoreSpace turned = PoreSpace.of(NX, NY, NZ, (x, y, z) -> rock.isPore(x, y, NZ - 1 - z));
    double forth = solve(rock, MIRRORED.withTolerance(1e-7)).permeability();
    double back = solve(turned, MIRRORED.withTolerance(1e-7)).permeability();
    assertEquals(1, back / forth, 1e-6);
  }

  /** A slot between mirrors is the channel between plates of which it is a part. */
  @Test
  void mirroredSidesAreNoWalls() {
    PoreSpace half = PoreSpace.of(5, 4, 6, (x, y, z) -> x > 0);
    FlowOptions options = MIRRORED.withTolerance(1e-8);
    double k = solve(half, options).permeability();
    // Plates 8 apart: w²/12 + 1/24, the mean over the nodes of an exact parabola; 4 of 5 voxels.
    assertEquals(1, k / ((64 / 12.0 + 1 / 24.0) * 4 / 5), 1e-6);
    PoreSpace open = PoreSpace.of(5, 4, 6, (x, y, z) -> true);
    assertThrows(IllegalArgumentException.class, () -> solve(open, options));
  }

  @Test
  void immersedBoundariesMayBeMirroredToo() {
    byte[] grey = rubble();
    byte[] eight = new byte[8 * grey.length];
    for (int voxel = 0; voxel < eight.length; voxel++) {
      int x = fold(voxel % (2 * NX), NX);
      int y = fold(voxel / (2 * NX) % (2 * NY), NY);
      int z = fold(voxel / (4 * NX * NY), NZ);
      eight[voxel] = grey[x + NX * (y + NY * z)];
    }
    SolidFractions part = SolidFractions.ofGrey(VoxelImage.of(NX, NY, NZ, grey), 3, 0);
    SolidFractions whole =
        SolidFractions.ofGrey(VoxelImage.of(2 * NX, 2 * NY, 2 * NZ, eight), 3, 0);
    FlowOptions options =
        FlowOptions.IMMERSED.withRelaxationTime(0.6).withTolerance(1e-12).withMaxSteps(600);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      double exact =
          LbmFlow.solve(
                  dispatcher,
                  whole,
                  options.withBoundaries(Sides.PERIODIC, Inlet.PERIODIC),
                  FlowListener.NONE)
              .permeability();
      double found =
          LbmFlow.solve(
                  dispatcher,
                  part,
                  options.withBoundaries(Sides.MIRROR, Inlet.PRESSURE),
                  FlowListener.NONE)
              .permeability();
      assertTrue(exact > 0);
      assertEquals(1, found / exact, 1e-9);
    }
  }
}
