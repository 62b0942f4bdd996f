package org.hdispatch.porous.survey;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;

/**
 * The jobs of a survey in their order: block by block, and for each block axis by axis.
 *
 * @param blocks the blocks
 * @param axes the directions of the flow, each once
 */
public record SurveyPlan(List<Block> blocks, List<Axis> axes) {
  /** The most jobs of one survey. */
  public static final int MOST_JOBS = 1_000_000;

  /**
   * A block of a plan.
   *
   * @param number its number: in the grid, or in the list of places that were given
   * @param box the block, in voxels of the image
   */
  public record Block(long number, VoxelBox box) {}

  /**
   * Keeps copies of the lists.
   *
   * @throws IllegalArgumentException if there is no block or no axis, or one of them twice, or more
   *     than {@link #MOST_JOBS} jobs
   */
  public SurveyPlan {
    requireOnce("axes", axes);
    requireOnce("blocks", blocks.stream().map(Block::number).toList());
    requireFew(blocks.size(), axes);
    blocks = List.copyOf(blocks);
    axes = List.copyOf(axes);
  }

  private static void requireOnce(String what, List<?> all) {
    if (all.isEmpty() || all.stream().distinct().count() < all.size()) {
      throw new IllegalArgumentException(what + " must be given, each once: " + what + "=" + all);
    }
  }

  private static void requireFew(long blocks, List<Axis> axes) {
    if (blocks > MOST_JOBS / axes.size()) {
      throw new IllegalArgumentException(
          "jobs must number at most " + MOST_JOBS + ": blocks=" + blocks + ", axes=" + axes.size());
    }
  }

  /**
   * All blocks of a grid.
   *
   * @throws IllegalArgumentException if the jobs are too many, or axes are missing or come twice
   */
  public static SurveyPlan all(BlockGrid grid, List<Axis> axes) {
    requireOnce("axes", axes);
    requireFew(grid.blocks(), axes);
    List<Long> numbers = new ArrayList<>();
    for (long number = 0; number < grid.blocks(); number++) {
      numbers.add(number);
    }
    return of(grid, numbers, axes);
  }

  /**
   * Some blocks of a grid.
   *
   * @param numbers their numbers, in any order
   * @throws IllegalArgumentException if there is no such block, the jobs are too many, or blocks or
   *     axes are missing or come twice
   */
  public static SurveyPlan of(BlockGrid grid, List<Long> numbers, List<Axis> axes) {
    return new SurveyPlan(
        numbers.stream().map(number -> new Block(number, grid.block(number))).toList(), axes);
  }

  /**
   * Blocks of a grid drawn at random, none twice, in rising order. The same seed draws the same
   * blocks everywhere ({@link Random}; sampling by Floyd, see Bentley, Commun. ACM 30(9), 1987).
   *
   * @param count how many
   * @throws IllegalArgumentException if there are not so many, the jobs are too many, or axes are
   *     missing or come twice
   */
  public static SurveyPlan random(BlockGrid grid, int count, long seed, List<Axis> axes) {
    if (count < 1 || count > grid.blocks()) {
      throw new IllegalArgumentException(
          "random blocks must number 1 to " + grid.blocks() + ": blocks=" + count);
    }
    requireOnce("axes", axes);
    requireFew(count, axes);
    Random random = new Random(seed);
    TreeSet<Long> drawn = new TreeSet<>();
    for (long last = grid.blocks() - count; last < grid.blocks(); last++) {
      long number = (long) (random.nextDouble() * (last + 1));
      if (!drawn.add(number)) {
        drawn.add(last);
      }
    }
    return of(grid, List.copyOf(drawn), axes);
  }

  /**
   * Blocks at given places, numbered in their order.
   *
   * @param boxes the blocks, inside the image
   * @throws IllegalArgumentException if the jobs are too many, or blocks or axes are missing, or
   *     axes come twice
   */
  public static SurveyPlan at(List<VoxelBox> boxes, List<Axis> axes) {
    List<Block> blocks = new ArrayList<>();
    for (VoxelBox box : boxes) {
      blocks.add(new Block(blocks.size(), box));
    }
    return new SurveyPlan(blocks, axes);
  }

  /** Number of jobs. */
  public int jobs() {
    return blocks.size() * axes.size();
  }

  /** Number of jobs of a shard. */
  public int jobs(Shard shard) {
    return shard.share(blocks.size()) * axes.size();
  }

  /** Whether a job belongs to a shard. */
  public boolean has(Shard shard, int job) {
    return shard.has(job / axes.size());
  }

  /** The numbers of the blocks in their order, those that follow each other as a range: 0,4,7-9. */
  public String numbers() {
    List<String> words = new ArrayList<>();
    for (int from = 0, to; from < blocks.size(); from = to) {
      to = from + 1;
      while (to < blocks.size() && number(to) == number(to - 1) + 1) {
        to++;
      }
      words.add(to - from == 1 ? "" + number(from) : number(from) + "-" + number(to - 1));
    }
    return String.join(",", words);
  }

  private long number(int place) {
    return blocks.get(place).number();
  }

  /**
   * A job.
   *
   * @param number its number, 0 to {@link #jobs()} - 1
   */
  public SurveyJob job(int number) {
    Block block = blocks.get(number / axes.size());
    return new SurveyJob(number, block.number(), block.box(), axes.get(number % axes.size()));
  }
}
