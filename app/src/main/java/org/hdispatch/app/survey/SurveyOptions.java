package org.hdispatch.app.survey;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Given;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.porous.block.Outside;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.survey.BlockGrid;
import org.hdispatch.porous.survey.Extent;
import org.hdispatch.porous.survey.Shard;
import org.hdispatch.porous.survey.SurveyPlan;
import picocli.CommandLine.Option;

/** Which blocks of an image, and who does them. */
final class SurveyOptions {
  private static final Pattern RANGE = Pattern.compile("(\\d{1,18})(-(\\d{1,18}))?");
  private static final Pattern PLACE = Pattern.compile("(\\d{1,9}),(\\d{1,9}),(\\d{1,9})");

  @Option(
      names = "--block",
      paramLabel = "N|NX,NY,NZ",
      split = ",",
      hideParamSyntax = true,
      description = "Size of a block, voxels. Default: none, it must be given.")
  private List<Integer> block;

  @Option(
      names = "--stride",
      paramLabel = "N|NX,NY,NZ",
      split = ",",
      hideParamSyntax = true,
      description =
          "From the first voxel of a block to that of the next. Default: the block, side by side.")
  private List<Integer> stride;

  @Option(
      names = "--overlap",
      paramLabel = "N|NX,NY,NZ",
      split = ",",
      hideParamSyntax = true,
      description = "Voxels that a block shares with the next, in place of --stride. Default: 0.")
  private List<Integer> overlap;

  @Option(
      names = "--blocks",
      paramLabel = "LIST",
      split = ",",
      hideParamSyntax = true,
      description =
          "Only the blocks of these numbers, such as 0,4,7-9; x fastest. Default: all that lie"
              + " inside as a whole.")
  private List<String> numbers;

  @Option(
      names = "--origin",
      paramLabel = "X0,Y0,Z0",
      hideParamSyntax = true,
      description =
          "A block that begins at this voxel, in place of regular ones; may come several times."
              + " Default: none.")
  private List<String> origins;

  @Option(
      names = "--random",
      paramLabel = "N",
      description =
          "Only so many blocks, drawn at random; with --stride 1 they may lie anywhere."
              + " Default: all.")
  private Integer random;

  @Option(names = "--seed", paramLabel = "S", description = "With --random: seed of the draw.")
  private long seed = 2011;

  @Option(
      names = "--axis",
      paramLabel = "AXES",
      split = ",",
      hideParamSyntax = true,
      defaultValue = "z",
      description = "Directions of the flow: x, y, z, several of them as x,z, or all.")
  private List<String> axes;

  @Option(
      names = "--outside-value",
      paramLabel = "LABEL",
      split = ",",
      hideParamSyntax = true,
      description = "Labels of voxels outside the sample, as around a round core. Default: none.")
  private List<Integer> outsideValue;

  @Option(
      names = "--outside",
      paramLabel = "WHAT",
      defaultValue = "flag",
      completionCandidates = Choices.OfOutside.class,
      description =
          "What to do with blocks that touch --outside-value: ${COMPLETION-CANDIDATES}. Flag: not"
              + " computed. Cut: voxels outside are solid, and porosity is that of the others; k is"
              + " still that of the whole cross-section.")
  private Outside outside;

  @Option(
      names = "--shard",
      paramLabel = "I/N",
      description =
          "Do only every N-th block from the I-th on, into files of its own; shards may run at"
              + " the same time into one folder. Default: all blocks.")
  private String shard;

  @Option(
      names = "--collect",
      paramLabel = "DIR",
      description =
          "Compute nothing: join the shards in this folder into survey.csv, and say what is missing."
              + " Default: none.")
  private Path collect;

  @Option(
      names = "--dry-run",
      description = "Say how many blocks and jobs there are and what they need, and end.")
  private boolean dryRun;

  /** The folder whose shards are to be joined, if any. */
  Optional<Path> collect() {
    return Optional.ofNullable(collect);
  }

  boolean dryRun() {
    return dryRun;
  }

  Outside outside() {
    return outside;
  }

  Shard shard() {
    return shard == null ? Shard.WHOLE : UsageException.orRefused(() -> Shard.parse(shard));
  }

  /** Labels outside the sample; none if all voxels are of it. */
  List<Integer> outsideLabels() {
    return outsideValue == null ? List.of() : outsideValue;
  }

  /**
   * The options that say which blocks there are, checked against each other.
   *
   * @throws UsageException if they do not go together
   */
  void check(Given given) {
    if (outsideValue == null) {
      given.refuse("--outside", "--outside-value");
    }
    if (random == null) {
      given.refuse("--seed", "--random");
    }
    if (stride != null) {
      given.refuse("--overlap", "blocks without --stride");
    }
    if (numbers != null) {
      given.refuse("--random", "blocks without --blocks");
    }
    if (origins != null) {
      for (String name : List.of("--stride", "--overlap", "--blocks", "--random", "--box")) {
        given.refuse(name, "regular blocks, not --origin");
      }
    }
    if (block == null) {
      throw new UsageException("--block must be given: the size of a block, voxels");
    }
  }

  Extent block() {
    return extent("--block", block);
  }

  private static Extent extent(String option, List<Integer> given) {
    if (given.size() != 1 && given.size() != 3) {
      throw new UsageException(option + " must be 1 or 3 integers: " + option + "=" + given);
    }
    return UsageException.orRefused(
        () -> new Extent(given.get(0), given.get(given.size() / 2), given.get(given.size() - 1)));
  }

  private Extent stride() {
    if (overlap == null) {
      return stride == null ? block() : extent("--stride", stride);
    }
    Extent size = block();
    boolean three = overlap.size() == 3;
    if (!three && overlap.size() != 1) {
      throw new UsageException("--overlap must be 1 or 3 integers: --overlap=" + overlap);
    }
    int[] shared = {overlap.get(0), overlap.get(three ? 1 : 0), overlap.get(three ? 2 : 0)};
    if (Arrays.stream(shared).min().getAsInt() < 0
        || shared[0] >= size.nx()
        || shared[1] >= size.ny()
        || shared[2] >= size.nz()) {
      throw new UsageException(
          "overlap must be 0 to less than the block: overlap="
              + joined(overlap)
              + ", block="
              + size);
    }
    return new Extent(size.nx() - shared[0], size.ny() - shared[1], size.nz() - shared[2]);
  }

  /** The regular blocks of a part of an image; empty if places are given instead. */
  Optional<BlockGrid> grid(VoxelBox region) {
    Extent steps = stride();
    return origins != null
        ? Optional.empty()
        : Optional.of(UsageException.orRefused(() -> new BlockGrid(region, block(), steps)));
  }

  /**
   * The plan.
   *
   * @param whole the whole image
   * @param grid its regular blocks, if it has them
   */
  SurveyPlan plan(VoxelBox whole, Optional<BlockGrid> grid) {
    List<Axis> along = axes();
    return UsageException.orRefused(
        () -> {
          if (grid.isEmpty()) {
            return SurveyPlan.at(places(whole), along);
          }
          if (random != null) {
            return SurveyPlan.random(grid.get(), random, seed, along);
          }
          return numbers == null
              ? SurveyPlan.all(grid.get(), along)
              : SurveyPlan.of(grid.get(), listed(grid.get()), along);
        });
  }

  /**
   * Which blocks, in words: the same numbers or places in the same order always by the same words,
   * however they were given; of a draw, its count and seed.
   *
   * @param plan the plan of these options
   */
  String choiceWords(SurveyPlan plan) {
    if (origins != null) {
      List<String> places =
          plan.blocks().stream()
              .map(SurveyPlan.Block::box)
              .map(box -> box.x0() + "," + box.y0() + "," + box.z0())
              .toList();
      return "at " + String.join("; ", places);
    }
    if (random != null) {
      return random + " at random, seed " + seed;
    }
    return plan.numbers();
  }

  /** The distance between blocks as settings keep it; empty if places are given. */
  String strideWords() {
    return origins == null ? stride().toString() : "";
  }

  private List<VoxelBox> places(VoxelBox whole) {
    Extent size = block();
    List<VoxelBox> boxes = new ArrayList<>();
    for (String each : origins) {
      Matcher place = PLACE.matcher(each.trim());
      if (!place.matches()) {
        throw new UsageException("--origin must be 3 integers from 0: --origin=" + each);
      }
      boxes.add(
          new VoxelBox(
                  Integer.parseInt(place.group(1)),
                  Integer.parseInt(place.group(2)),
                  Integer.parseInt(place.group(3)),
                  size.nx(),
                  size.ny(),
                  size.nz())
              .within(whole.nx(), whole.ny(), whole.nz()));
    }
    return boxes;
  }

  private List<Long> listed(BlockGrid grid) {
    List<Long> found = new ArrayList<>();
    for (String each : numbers) {
      Matcher range = RANGE.matcher(each.trim());
      if (!range.matches()) {
        throw new UsageException(
            "--blocks must be numbers or ranges, such as 0,4,7-9: --blocks=" + each);
      }
      long first = Long.parseLong(range.group(1));
      long last = range.group(3) == null ? first : Long.parseLong(range.group(3));
      grid.block(last); // before a long list is made
      for (long number = first; number <= last; number++) {
        if (found.size() == SurveyPlan.MOST_JOBS) {
          throw new UsageException("blocks must number at most " + SurveyPlan.MOST_JOBS);
        }
        found.add(number);
      }
    }
    return found;
  }

  private List<Axis> axes() {
    if (axes.equals(List.of("all"))) {
      return List.of(Axis.values());
    }
    List<Axis> along = new ArrayList<>();
    for (String word : axes) {
      Optional<Axis> axis =
          Arrays.stream(Axis.values())
              .filter(each -> Choices.word(each).equalsIgnoreCase(word.trim()))
              .findFirst();
      along.add(
          axis.orElseThrow(
              () ->
                  new UsageException(
                      "--axis must be x, y, z, several of them, or all: --axis=" + joined(axes))));
    }
    return along;
  }

  private static String joined(List<?> values) {
    return String.join(",", values.stream().map(Object::toString).toList());
  }
}
