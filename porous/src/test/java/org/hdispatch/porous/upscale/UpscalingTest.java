package org.hdispatch.porous.upscale;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.survey.Extent;
import org.hdispatch.porous.survey.SurveyJob;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveyStatus;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class UpscalingTest {
  private static final Set<Axis> ALL = EnumSet.allOf(Axis.class);
  private static final Extent BOARD = new Extent(10, 14, 25);

  private final Dispatcher dispatcher = Dispatcher.withWorkers(2);

  @AfterEach
  void close() {
    dispatcher.close();
  }

  private static double[] layers(int n) {
    return new Random(7).doubles(n).map(each -> Math.pow(1e4, each)).toArray();
  }

  /** Layers across z: harmonic mean across, arithmetic mean along, whatever the blocks' shape. */
  @ParameterizedTest
  @EnumSource(Axis.class)
  void layersGiveTheExactHarmonicAndArithmeticMeans(Axis across) {
    int n = 20;
    double[] k = layers(n);
    double sum = 0;
    double inverse = 0;
    for (double each : k) {
      sum += each;
      inverse += 1 / each;
    }
    BlockMap map =
        BlockMap.of(
            BOARD,
            across == Axis.X ? n : 3,
            across == Axis.Y ? n : 4,
            across == Axis.Z ? n : 5,
            ALL,
            (axis, x, y, z) -> k[across.length(x, y, z)]);
    for (Axis axis : Axis.values()) {
      double exact = axis == across ? n / inverse : sum / n;
      Upscaling.Result found = Upscaling.along(dispatcher, map, axis);
      assertTrue(found.converged());
      assertEquals(exact, found.permeability(), 1e-9 * exact); // contrasts of 1e4, residual 1e-12
      Bounds bounds = Upscaling.bounds(map, axis);
      assertEquals(exact, bounds.columns(), 1e-13 * exact, "both bounds are sharp here");
      assertEquals(exact, bounds.layers(), 1e-13 * exact);
      assertEquals(sum / n, bounds.arithmetic(), 1e-13 * sum / n);
      assertEquals(n / inverse, bounds.harmonic(), 1e-13 * n / inverse);
    }
  }

  @Test
  void tensorThatIsTheSameEverywhereIsThatOfTheSample() {
    BlockMap map = BlockMap.of(BOARD, 3, 1, 6, ALL, (axis, x, y, z) -> axis.length(2000, 3, 500));
    for (Axis axis : Axis.values()) {
      double exact = axis.length(2000, 3, 500);
      assertEquals(exact, Upscaling.along(dispatcher, map, axis).permeability(), 1e-10 * exact);
      Bounds bounds = Upscaling.bounds(map, axis);
      assertEquals(exact, bounds.harmonic(), 1e-13 * exact);
      assertEquals(exact, bounds.arithmetic(), 1e-13 * exact);
    }
  }

  /** A chessboard of squares, each of m x m blocks, in a plane; exact: the geometric mean. */
  private double chessboard(int m) {
    BlockMap map =
        BlockMap.of(
            new Extent(4, 4, 4),
            4 * m,
            1,
            4 * m,
            ALL,
            (axis, x, y, z) -> (x / m + z / m) % 2 == 0 ? 1 : 9);
    Upscaling.Result found = Upscaling.along(dispatcher, map, Axis.Z);
    assertTrue(found.converged());
    double other = Upscaling.along(dispatcher, map, Axis.X).permeability();
    assertEquals(other, found.permeability(), 1e-9);
    return found.permeability();
  }

  /**
   * Mean of squares of 1 and 9 in the plane: 3 (Dykhne 1971, duality). One block a square comes
   * near the harmonic mean of neighbours, 1.8; finer ones come to 3 slowly, as the flux is singular
   * in the corners.
   */
  @Test
  void chessboardConvergesToTheGeometricMean() {
    assertEquals(2, chessboard(1), 0.25);
    double coarse = 3 - chessboard(4);
    double fine = 3 - chessboard(16);
    assertTrue(fine > 0 && fine < 0.5 * coarse, coarse + ", " + fine);
    assertEquals(3, chessboard(64), 0.05 * 3);
  }

  /** Blocks three times as tall and nine times as permeable along z conduct three times as well. */
  @Test
  void stretchingTheBlocksIsTheSameAsStretchingThePermeability() {
    Random random = new Random(3);
    double[] k = random.doubles(6 * 5 * 4).map(each -> Math.pow(100, each)).toArray();
    BlockMap.Values plain = (axis, x, y, z) -> k[x + 6 * (y + 5 * z)];
    BlockMap flat = BlockMap.of(new Extent(8, 8, 8), 6, 5, 4, ALL, plain);
    BlockMap tall =
        BlockMap.of(
            new Extent(8, 8, 24),
            6,
            5,
            4,
            ALL,
            (axis, x, y, z) -> plain.at(axis, x, y, z) * (axis == Axis.Z ? 9 : 1));
    double z = Upscaling.along(dispatcher, flat, Axis.Z).permeability();
    double x = Upscaling.along(dispatcher, flat, Axis.X).permeability();
    assertEquals(9 * z, Upscaling.along(dispatcher, tall, Axis.Z).permeability(), 1e-8 * z);
    assertEquals(x, Upscaling.along(dispatcher, tall, Axis.X).permeability(), 1e-8 * x);
  }

  /** Random maps with blocks that do not percolate and places without a block. */
  @Test
  void liesBetweenTheLayeredBoundsAndTheseBetweenTheMeans() {
    for (int seed = 0; seed < 30; seed++) {
      Random random = new Random(seed);
      double holes = seed % 3 * 0.1;
      double[][] k = new double[3][5 * 6 * 7];
      for (int place = 0; place < k[0].length; place++) {
        boolean hole = random.nextDouble() < holes;
        for (double[] along : k) {
          double value = random.nextDouble() < holes ? 0 : Math.pow(1000, random.nextDouble());
          along[place] = hole ? Double.NaN : value;
        }
      }
      BlockMap map =
          BlockMap.of(
              BOARD, 5, 6, 7, ALL, (axis, x, y, z) -> k[axis.ordinal()][x + 5 * (y + 6 * z)]);
      for (Axis axis : Axis.values()) {
        Upscaling.Result found = Upscaling.along(dispatcher, map, axis);
        Bounds bounds = Upscaling.bounds(map, axis);
        double slack = 1e-7 * bounds.arithmetic();
        assertTrue(found.converged());
        assertTrue(bounds.harmonic() <= bounds.columns() + slack);
        assertTrue(bounds.columns() <= found.permeability() + slack, axis + " " + bounds);
        assertTrue(found.permeability() <= bounds.layers() + slack, axis + " " + bounds);
        assertTrue(bounds.layers() <= bounds.arithmetic() + slack);
        assertTrue(found.permeability() > 0);
      }
    }
  }

  @Test
  void sameBitsForAnyNumberOfWorkers() {
    double[] k = layers(40 * 20 * 20);
    BlockMap map = BlockMap.of(BOARD, 40, 20, 20, ALL, (axis, x, y, z) -> k[x + 40 * (y + 20 * z)]);
    Upscaling.Result expected = Upscaling.along(dispatcher, map, Axis.Y);
    for (int workers : new int[] {1, 3}) {
      try (Dispatcher other = Dispatcher.withWorkers(workers)) {
        assertEquals(expected, Upscaling.along(other, map, Axis.Y));
      }
    }
  }

  /** Every second column of blocks is there: k is that of the cross-section that is there. */
  @Test
  void crossSectionIsThatOfTheBlocks() {
    BlockMap map =
        BlockMap.of(BOARD, 4, 4, 3, ALL, (axis, x, y, z) -> (x + y) % 2 == 0 ? 5 : Double.NaN);
    assertEquals(24, map.blocks());
    assertEquals(48, map.places());
    assertEquals(5, Upscaling.along(dispatcher, map, Axis.Z).permeability(), 1e-10);
    Bounds bounds = Upscaling.bounds(map, Axis.Z);
    assertEquals(5, bounds.columns(), 1e-13);
    assertEquals(5, bounds.arithmetic(), 1e-13);
    assertEquals(0, bounds.harmonic(), "some places have no permeability");
    Upscaling.Result across = Upscaling.along(dispatcher, map, Axis.X);
    assertEquals(new Upscaling.Result(0, false, 0, 0, true), across);
  }

  @Test
  void wayMayLeadRoundBlocksThatDoNotPercolate() {
    // A wall across x with a gate, which lets flow pass along x only.
    BlockMap map =
        BlockMap.of(
            BOARD, 5, 3, 1, ALL, (axis, x, y, z) -> x != 2 ? 1 : y == 1 && axis == Axis.X ? 1 : 0);
    assertTrue(Upscaling.along(dispatcher, map, Axis.X).permeability() > 0);
    assertEquals(0, Upscaling.bounds(map, Axis.X).harmonic());
    BlockMap shut =
        BlockMap.of(
            BOARD, 5, 3, 1, ALL, (axis, x, y, z) -> x != 2 ? 1 : y == 1 && axis == Axis.Y ? 1 : 0);
    assertFalse(Upscaling.along(dispatcher, shut, Axis.X).percolates());
    assertEquals(0, Upscaling.bounds(shut, Axis.X).layers());
  }

  private static SurveyRow row(int job, VoxelBox box, Axis axis, SurveyStatus status, double k) {
    Map<String, String> figures =
        status == SurveyStatus.OUTSIDE || status == SurveyStatus.FAILED
            ? Map.of()
            : Map.of("permeability_voxel2", Double.toString(k));
    return new SurveyRow(new SurveyJob(job, job / 3, box, axis), status, "cause", figures);
  }

  /** Blocks of 8 x 4 x 2 at places (0, 0, 0) and (1, 0, 1) that percolate, and others. */
  private static List<SurveyRow> rows(SurveyStatus second) {
    List<SurveyRow> rows = new ArrayList<>();
    VoxelBox here = new VoxelBox(100, 50, 20, 8, 4, 2);
    VoxelBox there = new VoxelBox(108, 50, 22, 8, 4, 2);
    for (Axis axis : Axis.values()) {
      rows.add(row(axis.ordinal(), here, axis, SurveyStatus.DONE, 1 + axis.ordinal()));
      rows.add(row(3 + axis.ordinal(), there, axis, second, 0.5));
    }
    return rows;
  }

  @Test
  void rowsOfASurveyAreBlocksAtTheirPlaces() {
    BlockMap map = BlockMap.of(rows(SurveyStatus.NOT_CONVERGED));
    assertEquals(new Extent(8, 4, 2), map.block());
    assertEquals(List.of(2, 1, 2), List.of(map.nx(), map.ny(), map.nz()));
    assertEquals(2, map.blocks());
    assertEquals(3, map.permeability(Axis.Z, 0, 0, 0));
    assertEquals(0.5, map.permeability(Axis.Y, 1, 0, 1));
    assertEquals(0, map.permeability(Axis.Y, 1, 0, 0), "no block there");
    assertEquals(1, BlockMap.of(rows(SurveyStatus.OUTSIDE)).blocks());
    assertEquals(0, BlockMap.of(rows(SurveyStatus.OUTSIDE)).permeability(Axis.Y, 1, 0, 1));
  }

  private static void refused(String text, List<SurveyRow> rows) {
    String message =
        assertThrows(IllegalArgumentException.class, () -> BlockMap.of(rows)).getMessage();
    assertTrue(message.contains(text), message);
  }

  @Test
  void refusesBlocksThatAreNoMap() {
    refused("survey must have rows", List.of());
    refused("failed=3, block=1, cause=cause", rows(SurveyStatus.FAILED));
    List<SurveyRow> some = rows(SurveyStatus.DONE);
    refused("blocks that lack one=1", some.subList(0, 5));
    some.set(5, row(5, new VoxelBox(109, 50, 22, 8, 4, 2), Axis.Z, SurveyStatus.DONE, 1));
    refused("must lie side by side", some);
    some.set(5, row(5, new VoxelBox(108, 50, 22, 9, 4, 2), Axis.Z, SurveyStatus.DONE, 1));
    refused("must be of one size", some);
    some.set(5, row(5, new VoxelBox(108, 50, 22, 8, 4, 2), Axis.Y, SurveyStatus.DONE, 1));
    refused("each once", some);
    List<SurveyRow> negative = rows(SurveyStatus.DONE);
    negative.set(0, row(0, new VoxelBox(100, 50, 20, 8, 4, 2), Axis.X, SurveyStatus.DONE, -1));
    refused("job=0, permeability_voxel2=-1.0", negative);
  }

  @Test
  void refusesToSolveWithoutPermeabilitiesAcross() {
    BlockMap map = BlockMap.of(BOARD, 2, 2, 2, EnumSet.of(Axis.Z), (axis, x, y, z) -> 1 + z);
    assertEquals(4.0 / 3, Upscaling.bounds(map, Axis.Z).layers(), 1e-15);
    assertThrows(IllegalArgumentException.class, () -> Upscaling.along(dispatcher, map, Axis.Z));
    assertThrows(IllegalArgumentException.class, () -> Upscaling.bounds(map, Axis.X));
  }
}
