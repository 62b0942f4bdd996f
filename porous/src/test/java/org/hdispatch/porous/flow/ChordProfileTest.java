package org.hdispatch.porous.flow;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.PoreSpace;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ChordProfileTest {
  private static double[] profile(PoreSpace rock, FlowOptions options, int workers) {
    FlowDomain domain = new FlowDomain(rock, options);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(workers)) {
      int nodes = domain.lattice().nx() * domain.lattice().ny() * domain.lattice().nz();
      double[] profile = new double[nodes];
      ChordProfile.find(dispatcher, domain, profile);
      return profile;
    }
  }

  private static FlowOptions along(Axis axis, Sides sides) {
    return FlowOptions.DEFAULT.withAxis(axis).withBoundaries(sides, Inlet.PERIODIC);
  }

  /** Laminar flow between walls 9 apart, at a distance from one: y (9 - y)/2. */
  private static double slit(int node) {
    return (node + 0.5) * (8.5 - node) / 2;
  }

  @ParameterizedTest
  @EnumSource(Axis.class)
  void isTheFlowInASlitAcrossEachAxis(Axis across) {
    Axis along = across == Axis.X ? Axis.Y : Axis.X;
    int n = 11;
    PoreSpace rock = PoreSpace.of(n, n, n, (x, y, z) -> across.length(x, y, z) % (n - 1) != 0);
    double[] profile = profile(rock, along(along, Sides.PERIODIC), 2);
    for (int i = 0; i < profile.length; i++) {
      int at = across.length(i % n, i / n % n, i / (n * n));
      assertEquals(at % (n - 1) == 0 ? 0 : slit(at - 1), profile[i], 1e-12);
    }
  }

  @Test
  void takesPeriodicEndsMirrorsAndSideWallsForWhatTheyAre() {
    PoreSpace middle = PoreSpace.of(10, 1, 1, (x, y, z) -> x != 4); // periodic: 9 nodes from 5 to 3
    double[] periodic = profile(middle, along(Axis.Z, Sides.PERIODIC), 1);
    PoreSpace end = PoreSpace.of(10, 1, 1, (x, y, z) -> x < 9);
    double[] mirrored = profile(end, along(Axis.Z, Sides.MIRROR), 1);
    PoreSpace square = PoreSpace.of(9, 9, 1, (x, y, z) -> true);
    double[] walled = profile(square, along(Axis.Z, Sides.WALL), 1);
    for (int i = 0; i < 9; i++) {
      assertEquals(slit(i), periodic[(i + 5) % 10], 1e-12);
      assertEquals((9 + i + 0.5) * (8.5 - i) / 2, mirrored[i], 1e-12); // half of a slit of 18
      assertEquals(1 / (1 / slit(i) + 1 / slit(4)), walled[i + 4 * 9], 1e-12);
    }
  }

  @Test
  void comesCloseToTheFlowInASlantingSlitAndInATube() {
    PoreSpace slanting = PoreSpace.of(40, 40, 1, (x, y, z) -> (x + y) % 40 < 30);
    double[] slit = profile(slanting, along(Axis.Z, Sides.PERIODIC), 1);
    double width = 30 / Math.sqrt(2);
    assertEquals(width * width / 8, slit[7 + 40 * 7], 0.01 * width * width / 8); // steps of 1 in 30
    double radius = 15.3;
    PoreSpace tube = PoreSpace.of(41, 41, 1, (x, y, z) -> Math.hypot(x - 20, y - 20) < radius);
    double[] round = profile(tube, along(Axis.Z, Sides.WALL), 1);
    for (int x = 10; x <= 30; x++) {
      double exact = (radius * radius - (x - 20) * (x - 20)) / 4;
      assertEquals(exact, round[x + 41 * 20], 0.06 * exact); // the wall is off by 1/2 at most
    }
  }

  @Test
  void isFiniteWhereNoLineMeetsAWall() {
    PoreSpace rock = PoreSpace.of(6, 6, 6, (x, y, z) -> x > 0 || y > 0 || z > 0);
    double[] profile = profile(rock, along(Axis.X, Sides.PERIODIC), 1);
    assertEquals(6 * 6 / 8.0, profile[1 + 6 * (1 + 6)]);
  }

  @Test
  void sameBitsForAnyNumberOfWorkers() {
    Random random = new Random(11);
    PoreSpace rock = PoreSpace.of(13, 17, 19, (x, y, z) -> random.nextInt(4) > 0);
    for (Sides sides : Sides.values()) {
      FlowOptions options = FlowOptions.DEFAULT.withAxis(Axis.Y).withBoundaries(sides, Inlet.SLAB);
      double[] one = profile(rock, options, 1);
      assertArrayEquals(one, profile(rock, options, 2));
      assertArrayEquals(one, profile(rock, options, 3));
    }
  }
}
