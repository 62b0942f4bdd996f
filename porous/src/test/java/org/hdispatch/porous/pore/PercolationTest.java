package org.hdispatch.porous.pore;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hdispatch.cell.Ends;
import org.hdispatch.porous.image.Axis;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class PercolationTest {

  /** A space drawn along z and turned so that the drawn axis becomes {@code axis}. */
  private static PoreSpace turned(
      Axis axis, int nx, int ny, int nz, PoreSpace.VoxelPredicate drawn) {
    return switch (axis) {
      case Z -> PoreSpace.of(nx, ny, nz, drawn);
      case Y -> PoreSpace.of(ny, nz, nx, (x, y, z) -> drawn.isPore(z, x, y));
      case X -> PoreSpace.of(nz, nx, ny, (x, y, z) -> drawn.isPore(y, z, x));
    };
  }

  private static Percolation open(PoreSpace space, Axis axis) {
    return Percolation.along(space, axis, Ends.OPEN, Ends.OPEN);
  }

  @ParameterizedTest
  @EnumSource
  void aStraightTubeSpansItsAxisOnly(Axis axis) {
    PoreSpace space = turned(axis, 3, 4, 5, (x, y, z) -> x == 1 && y == 2);
    for (Axis each : Axis.values()) {
      Percolation percolation = open(space, each);
      assertEquals(each == axis, percolation.percolates());
      assertEquals(each == axis ? 1 : 0, percolation.spanningClusters());
      assertEquals(each == axis ? 0 : 5, percolation.isolatedPoreVoxels());
      assertEquals(each == axis ? 5 / 60.0 : 0, percolation.connectedPorosity());
    }
  }

  @ParameterizedTest
  @EnumSource
  void edgesAndCornersDoNotConnect(Axis axis) {
    PoreSpace edge = turned(axis, 2, 1, 4, (x, y, z) -> x == z / 2);
    assertFalse(open(edge, axis).percolates());
    PoreSpace corner = turned(axis, 2, 2, 4, (x, y, z) -> x == z / 2 && y == z / 2);
    assertFalse(open(corner, axis).percolates());
    PoreSpace faces = turned(axis, 2, 1, 4, (x, y, z) -> x == z / 2 || z == 1);
    assertTrue(open(faces, axis).percolates());
  }

  @ParameterizedTest
  @EnumSource
  void aPoreThatLeavesThroughASideSpansOnlyWithPeriodicSides(Axis axis) {
    // Up at x = 0 to the middle, then through the side, and on at x = 4.
    PoreSpace space =
        turned(
            axis,
            5,
            3,
            6,
            (x, y, z) -> y == 1 && (z < 3 ? x == 0 : x == 4) || y == 1 && z == 3 && x == 0);
    assertFalse(open(space, axis).percolates());
    Percolation periodic = Percolation.along(space, axis, Ends.PERIODIC, Ends.OPEN);
    assertTrue(periodic.percolates());
    assertEquals(7, periodic.connected().poreVoxels());
    // The same through the other pair of sides.
    PoreSpace other =
        turned(axis, 3, 5, 6, (x, y, z) -> x == 1 && (z < 3 ? y == 0 : y == 4 || z == 3 && y == 0));
    assertFalse(open(other, axis).percolates());
    assertTrue(Percolation.along(other, axis, Ends.PERIODIC, Ends.OPEN).percolates());
  }

  @ParameterizedTest
  @EnumSource
  void deadEndsBelongToTheClusterAndPocketsDoNot(Axis axis) {
    // A tube, a branch of 2 voxels, and a pocket of 2 that touches only the first layer.
    PoreSpace space =
        turned(
            axis, 6, 1, 4, (x, y, z) -> x == 1 || z == 2 && (x == 2 || x == 3) || x == 5 && z < 2);
    Percolation percolation = open(space, axis);
    assertEquals(1, percolation.spanningClusters());
    assertEquals(6, percolation.connected().poreVoxels());
    assertEquals(2, percolation.isolatedPoreVoxels());
    assertEquals(8 / 24.0, space.porosity());
    assertEquals(6 / 24.0, percolation.connectedPorosity());
  }

  @ParameterizedTest
  @EnumSource
  void separateTubesAreSeparateClusters(Axis axis) {
    PoreSpace space = turned(axis, 5, 5, 3, (x, y, z) -> x % 2 == 0 && y % 2 == 0);
    assertEquals(9, open(space, axis).spanningClusters());
    assertEquals(0, open(space, axis).isolatedPoreVoxels());
  }

  @ParameterizedTest
  @EnumSource
  void endsThatDoNotMeetSpanTheOpenBoxButNotThePeriodicOne(Axis axis) {
    // Enters at x = 0 and leaves at x = 3: the next period does not go on there.
    PoreSpace space = turned(axis, 4, 1, 5, (x, y, z) -> z < 2 ? x == 0 : z == 2 ? true : x == 3);
    assertTrue(open(space, axis).percolates());
    Percolation periodic = Percolation.along(space, axis, Ends.OPEN, Ends.PERIODIC);
    assertFalse(periodic.percolates());
    assertEquals(space.poreVoxels(), periodic.isolatedPoreVoxels());
  }

  @ParameterizedTest
  @EnumSource
  void aLoopThatCrossesThePeriodAndComesBackDoesNotWind(Axis axis) {
    // A closed ring in (x, z) that crosses the period face twice: touches both layers, winds never.
    PoreSpace ring =
        turned(
            axis,
            5,
            1,
            8,
            (x, y, z) -> {
              boolean legs = (x == 1 || x == 3) && (z <= 2 || z >= 6);
              boolean bridges = (z == 2 || z == 6) && x == 2;
              return legs || bridges;
            });
    assertFalse(Percolation.along(ring, axis, Ends.OPEN, Ends.PERIODIC).percolates());
    PoreSpace tube = turned(axis, 5, 1, 8, (x, y, z) -> x == 1);
    assertTrue(Percolation.along(tube, axis, Ends.OPEN, Ends.PERIODIC).percolates());
  }

  @ParameterizedTest
  @EnumSource
  void aHelixThatClosesAfterTwoPeriodsWinds(Axis axis) {
    // Two tubes that change places: x = 0 goes on at x = 4 in the next period and the reverse,
    // by a crossing in two planes of y that do not touch.
    PoreSpace.VoxelPredicate helix =
        (x, y, z) -> {
          boolean first =
              (z < 2 && x == 0 && y == 0) || (z == 2 && y == 0) || (z > 2 && x == 4 && y == 0);
          boolean second =
              (z < 4 && x == 4 && y == 2) || (z == 4 && y == 2) || (z > 4 && x == 0 && y == 2);
          boolean change = z == 6 && (x == 0 || x == 4);
          return first || second || change;
        };
    PoreSpace space = turned(axis, 5, 3, 7, helix);
    Percolation periodic = Percolation.along(space, axis, Ends.OPEN, Ends.PERIODIC);
    assertEquals(1, periodic.spanningClusters());
    assertEquals(space.poreVoxels(), periodic.connected().poreVoxels());
    // Without the last change the ends do not meet in one period nor in two.
    PoreSpace broken =
        turned(axis, 5, 3, 7, (x, y, z) -> helix.isPore(x, y, z) && !(z == 6 && y == 1));
    assertEquals(
        broken.poreVoxels(),
        Percolation.along(broken, axis, Ends.OPEN, Ends.PERIODIC).isolatedPoreVoxels());
  }

  @ParameterizedTest
  @EnumSource
  void aDiagonalThatWindsOnlyWithPeriodicSidesIsFound(Axis axis) {
    // One step aside per layer: after 4 periods of 3 layers it is back, the sides being 12 wide.
    PoreSpace space = turned(axis, 12, 1, 3, (x, y, z) -> x % 3 == z || x % 3 == (z + 1) % 3);
    assertFalse(
        Percolation.along(
                turned(axis, 12, 1, 3, (x, y, z) -> x == z || x == z + 1),
                axis,
                Ends.PERIODIC,
                Ends.PERIODIC)
            .percolates());
    Percolation wound = Percolation.along(space, axis, Ends.PERIODIC, Ends.PERIODIC);
    assertTrue(wound.percolates());
    assertEquals(1, wound.spanningClusters());
  }

  @Test
  void oneLayerSpansAndWinds() {
    PoreSpace layer = PoreSpace.of(3, 3, 1, (x, y, z) -> x == y);
    assertEquals(3, open(layer, Axis.Z).spanningClusters());
    assertEquals(3, Percolation.along(layer, Axis.Z, Ends.OPEN, Ends.PERIODIC).spanningClusters());
    PoreSpace row = PoreSpace.of(1, 1, 1, (x, y, z) -> true);
    for (Axis axis : Axis.values()) {
      assertTrue(open(row, axis).percolates());
      assertTrue(Percolation.along(row, axis, Ends.PERIODIC, Ends.PERIODIC).percolates());
    }
  }

  @Test
  void allSolidDoesNotPercolateAndAllPoreDoes() {
    PoreSpace solid = PoreSpace.of(4, 4, 4, (x, y, z) -> false);
    PoreSpace pore = PoreSpace.of(4, 4, 4, (x, y, z) -> true);
    for (Axis axis : Axis.values()) {
      for (Ends wrap : Ends.values()) {
        assertFalse(Percolation.along(solid, axis, wrap, wrap).percolates());
        Percolation all = Percolation.along(pore, axis, wrap, wrap);
        assertEquals(1, all.spanningClusters());
        assertEquals(1, all.connectedPorosity());
      }
    }
  }
}
