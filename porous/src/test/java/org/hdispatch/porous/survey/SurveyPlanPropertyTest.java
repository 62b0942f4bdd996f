package org.hdispatch.porous.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.LongStream;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;

/** Which blocks and jobs a survey has. */
class SurveyPlanPropertyTest {
  private static final List<Axis> ALL = List.of(Axis.values());

  @Property(tries = 1000, seed = "8")
  void blocksAreThePlacesOfTheGridThatLieInside(
      @ForAll @IntRange(min = 0, max = 5) int x0,
      @ForAll @IntRange(min = 1, max = 12) int nx,
      @ForAll @IntRange(min = 1, max = 12) int ny,
      @ForAll @IntRange(min = 1, max = 5) int block,
      @ForAll @IntRange(min = 1, max = 7) int stride) {
    VoxelBox region = new VoxelBox(x0, 3, 0, nx, ny, 9);
    Extent size = new Extent(block, block, 2);
    if (block > nx || block > ny) {
      assertThrows(
          IllegalArgumentException.class,
          () -> new BlockGrid(region, size, new Extent(stride, stride, 3)));
      return;
    }
    List<VoxelBox> expected = new ArrayList<>();
    int left = 0;
    for (int z = 0; z < 9; z += 3) {
      for (int y = 0; y < ny; y += stride) {
        for (int x = 0; x < nx; x += stride) {
          if (x + block <= nx && y + block <= ny && z + 2 <= 9) {
            expected.add(new VoxelBox(x0 + x, 3 + y, z, block, block, 2));
          } else {
            left++;
          }
        }
      }
    }
    BlockGrid grid = new BlockGrid(region, size, new Extent(stride, stride, 3));
    List<VoxelBox> found = LongStream.range(0, grid.blocks()).mapToObj(grid::block).toList();
    assertEquals(expected, found);
    assertEquals(left, grid.partialBlocks());
  }

  @Property(tries = 300, seed = "8")
  void blocksSideBySideShareNoVoxel(
      @ForAll @IntRange(min = 1, max = 9) int nx,
      @ForAll @IntRange(min = 1, max = 9) int nz,
      @ForAll @IntRange(min = 1, max = 4) int block) {
    VoxelBox region = VoxelBox.whole(nx + 3, 5, nz + 3);
    Extent size = new Extent(block, 2, block);
    BlockGrid grid = new BlockGrid(region, size, size);
    int[] taken = new int[(nx + 3) * 5 * (nz + 3)];
    for (SurveyPlan.Block each : SurveyPlan.all(grid, ALL).blocks()) {
      VoxelBox box = each.box().within(nx + 3, 5, nz + 3);
      for (int z = box.z0(); z < box.z0() + box.nz(); z++) {
        for (int y = box.y0(); y < box.y0() + box.ny(); y++) {
          for (int x = box.x0(); x < box.x0() + box.nx(); x++) {
            assertEquals(1, ++taken[x + (nx + 3) * (y + 5 * z)]);
          }
        }
      }
    }
  }

  @Property(tries = 300, seed = "8")
  void randomBlocksAreDistinctAndOfTheGrid(
      @ForAll @IntRange(min = 1, max = 60) int count, @ForAll long seed) {
    BlockGrid grid =
        new BlockGrid(VoxelBox.whole(8, 9, 10), new Extent(5, 5, 5), new Extent(1, 1, 1));
    assertEquals(4 * 5 * 6, grid.blocks());
    SurveyPlan plan = SurveyPlan.random(grid, count, seed, ALL);
    assertEquals(3 * count, plan.jobs());
    List<Long> numbers = plan.blocks().stream().map(SurveyPlan.Block::number).toList();
    assertEquals(List.copyOf(new TreeSet<>(numbers)), numbers);
    assertTrue(numbers.get(0) >= 0 && numbers.get(count - 1) < grid.blocks());
    assertEquals(plan, SurveyPlan.random(grid, count, seed, ALL));
  }

  @Example
  void allBlocksAreDrawnWhereAllAreAskedForAndSeedsDiffer() {
    BlockGrid grid =
        new BlockGrid(VoxelBox.whole(8, 9, 10), new Extent(5, 5, 5), new Extent(1, 1, 1));
    assertEquals(SurveyPlan.all(grid, ALL), SurveyPlan.random(grid, 120, 7, ALL));
    assertNotEquals(
        SurveyPlan.random(grid, 5, 1, ALL).blocks(), SurveyPlan.random(grid, 5, 2, ALL).blocks());
  }

  @Property(tries = 300, seed = "8")
  void everyJobBelongsToOneShardWithAllOfItsBlock(
      @ForAll @IntRange(min = 1, max = 40) int blocks,
      @ForAll @IntRange(min = 1, max = 3) int axes,
      @ForAll @IntRange(min = 1, max = 9) int count) {
    BlockGrid grid =
        new BlockGrid(VoxelBox.whole(blocks, 1, 1), new Extent(1, 1, 1), new Extent(1, 1, 1));
    SurveyPlan plan = SurveyPlan.all(grid, ALL.subList(0, axes));
    int all = 0;
    for (int number = 1; number <= count; number++) {
      Shard shard = Shard.parse(number + "/" + count);
      int has = 0;
      for (int job = 0; job < plan.jobs(); job++) {
        has += plan.has(shard, job) ? 1 : 0;
        assertEquals(plan.has(shard, job), plan.has(shard, job / axes * axes));
      }
      assertEquals(has, plan.jobs(shard));
      all += has;
    }
    assertEquals(plan.jobs(), all);
  }

  @Example
  void numbersThatFollowEachOtherAreARange() {
    BlockGrid grid =
        new BlockGrid(VoxelBox.whole(12, 1, 1), new Extent(1, 1, 1), new Extent(1, 1, 1));
    assertEquals("0-11", SurveyPlan.all(grid, ALL).numbers());
    assertEquals(
        "0,4,7-9,2-3", SurveyPlan.of(grid, List.of(0L, 4L, 7L, 8L, 9L, 2L, 3L), ALL).numbers());
  }

  @Example
  void jobsGoBlockByBlockAndAxisByAxis() {
    BlockGrid grid =
        new BlockGrid(VoxelBox.whole(8, 4, 4), new Extent(4, 4, 4), new Extent(4, 4, 4));
    SurveyPlan plan = SurveyPlan.all(grid, List.of(Axis.Z, Axis.X));
    assertEquals(new SurveyJob(0, 0, new VoxelBox(0, 0, 0, 4, 4, 4), Axis.Z), plan.job(0));
    assertEquals(new SurveyJob(1, 0, new VoxelBox(0, 0, 0, 4, 4, 4), Axis.X), plan.job(1));
    assertEquals(new SurveyJob(2, 1, new VoxelBox(4, 0, 0, 4, 4, 4), Axis.Z), plan.job(2));
    assertEquals(4, plan.jobs());
  }

  @Example
  void plansThatCannotBeMeantSoAreRefused() {
    BlockGrid grid =
        new BlockGrid(VoxelBox.whole(400, 400, 400), new Extent(4, 4, 4), new Extent(1, 1, 1));
    for (Runnable each :
        List.<Runnable>of(
            () -> SurveyPlan.all(grid, ALL),
            () -> SurveyPlan.of(grid, List.of(3L, 3L), ALL),
            () -> SurveyPlan.of(grid, List.of(grid.blocks()), ALL),
            () -> SurveyPlan.of(grid, List.of(-1L), ALL),
            () -> SurveyPlan.random(grid, 0, 1, ALL),
            () -> SurveyPlan.random(grid, 4, 1, List.of(Axis.X, Axis.X)),
            () -> SurveyPlan.all(grid, List.of()),
            () -> SurveyPlan.at(List.of(), ALL),
            () -> Shard.parse("0/3"),
            () -> Shard.parse("4/3"),
            () -> Shard.parse("1 of 3"),
            () -> new Extent(1, 0, 1))) {
      assertThrows(IllegalArgumentException.class, each::run);
    }
  }
}
