package org.hdispatch.example.spark;

import java.io.IOException;
import java.io.Serializable;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.apache.spark.SparkConf;
import org.apache.spark.TaskContext;
import org.apache.spark.api.java.JavaSparkContext;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.porous.block.BlockColumns;
import org.hdispatch.porous.block.BlockSettings;
import org.hdispatch.porous.block.BlockStudy;
import org.hdispatch.porous.block.HeapLimit;
import org.hdispatch.porous.flow.FlowListener;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.io.Hdf5Images;
import org.hdispatch.porous.io.ImageFile;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.survey.BlockGrid;
import org.hdispatch.porous.survey.Extent;
import org.hdispatch.porous.survey.Shard;
import org.hdispatch.porous.survey.SurveyFiles;
import org.hdispatch.porous.survey.SurveyJob;
import org.hdispatch.porous.survey.SurveyPlan;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveySettings;
import scala.Function2;
import scala.collection.Iterator;
import scala.jdk.javaapi.CollectionConverters;
import scala.reflect.ClassTag;
import scala.reflect.ClassTag$;
import scala.runtime.BoxedUnit;

/**
 * A survey on a Spark cluster: a task for each block, and a row for each of its axes. The driver
 * writes a row as soon as its block is done; the same command goes on where it was ended, and in the
 * end {@code survey.csv} equals that of {@code ./hdispatch survey}, byte by byte.
 *
 * <p>A task takes all cores of its executor ({@code spark.task.cpus}), so that a node does one block
 * at a time with all its threads, and needs the heap of one block. A task that is lost with its
 * executor is done again elsewhere. Speculation is off: a second copy of a block brings nothing but
 * the same row. Should two arrive all the same, the first counts.
 */
public final class SparkSurvey {
  private static final String USAGE =
      "usage: SparkSurvey IMAGE.h5 BLOCK AXES FOLDER [FIRST-LAST]"
          + " (the image where all nodes see it, the folder where the driver does)";

  private SparkSurvey() {}

  /**
   * What a task sends back for each axis of its block.
   *
   * @param row what was found
   * @param times what it took, as {@link BlockColumns#TIMES} names it
   */
  private record Found(SurveyRow row, List<String> times) implements Serializable {}

  /**
   * What a task needs to know beside its block.
   *
   * @param image path of the image, the same on all nodes
   * @param settings what is computed
   * @param jobs all jobs, block by block
   * @param axes how many belong to a block
   */
  private record Work(String image, BlockSettings settings, List<SurveyJob> jobs, int axes)
      implements Serializable {

    /** Does the jobs of a block; runs on an executor. */
    ArrayList<Found> block(int number, int threads) {
      ArrayList<Found> found = new ArrayList<>();
      try (Dispatcher dispatcher = Dispatcher.withWorkers(threads)) {
        BlockStudy study = study(image, settings);
        for (SurveyJob job : jobs.subList(number * axes, (number + 1) * axes)) {
          long begun = System.nanoTime();
          BlockStudy.Done done = study.run(dispatcher, job, FlowListener.NONE);
          double seconds = (System.nanoTime() - begun) * 1e-9;
          found.add(new Found(done.row(), BlockStudy.times(done, seconds, threads)));
        }
      } catch (ImageFileException e) { // the task fails, and is tried again
        throw new UncheckedIOException(e);
      }
      return found;
    }
  }

  private static BlockStudy study(String file, BlockSettings settings) throws ImageFileException {
    ImageFile image = Hdf5Images.open(Path.of(file), Optional.empty());
    String name = BlockStudy.nameOf(image, Path.of(file));
    return new BlockStudy(image, name, settings, HeapLimit.ofThisProcess());
  }

  /**
   * The driver.
   *
   * @param args image, edge of a block in voxels, axes such as {@code z} or {@code x,y,z}, folder of
   *     the rows, and, if not all blocks are wanted, which
   */
  public static void main(String[] args) throws IOException {
    if (args.length < 4 || args.length > 5) {
      throw new IllegalArgumentException(USAGE);
    }
    ImageFile image = Hdf5Images.open(Path.of(args[0]), Optional.empty());
    int edge = Integer.parseInt(args[1]);
    Extent block = new Extent(edge, edge, edge);
    List<Axis> axes =
        Arrays.stream(args[2].split(",")).map(axis -> Axis.valueOf(axis.toUpperCase(Locale.ROOT))).toList();
    BlockGrid grid = new BlockGrid(image.whole(), block, block);
    SurveyPlan plan = args.length < 5 ? SurveyPlan.all(grid, axes) : some(grid, args[4], axes);
    BlockSettings settings = BlockSettings.of(image.voxelEdge().orElseThrow());
    Map<String, String> which = new LinkedHashMap<>();
    which.put("box", "");
    which.put("block", block.toString());
    which.put("stride", block.toString());
    which.put("blocks", plan.numbers());
    SurveySettings rowsDependOn = study(args[0], settings).settings(plan, which);

    Path folder = Files.createDirectories(Path.of(args[3]));
    List<SurveyJob> jobs = new ArrayList<>();
    for (int job = 0; job < plan.jobs(); job++) {
      jobs.add(plan.job(job));
    }
    try (SurveyFiles files =
        SurveyFiles.open(
            folder, Shard.WHOLE, rowsDependOn, BlockColumns.FIGURES, BlockColumns.TIMES)) {
      survey(new Work(args[0], settings, jobs, axes.size()), files);
      files.sort();
    }
  }

  private static SurveyPlan some(BlockGrid grid, String range, List<Axis> axes) {
    String[] ends = range.split("-");
    return SurveyPlan.of(
        grid,
        LongStream.rangeClosed(Long.parseLong(ends[0]), Long.parseLong(ends[1])).boxed().toList(),
        axes);
  }

  private static void survey(Work work, SurveyFiles files) {
    int axes = work.axes();
    List<Integer> left =
        IntStream.range(0, work.jobs().size() / axes)
            .filter(
                block ->
                    !IntStream.range(block * axes, (block + 1) * axes).allMatch(files::isDone))
            .boxed()
            .toList();
    if (left.isEmpty()) {
      return;
    }
    SparkConf conf = new SparkConf().setAppName("hdispatch survey");
    conf.set("spark.task.cpus", conf.get("spark.executor.cores", "1"));
    conf.set("spark.speculation", "false");
    conf.setIfMissing("spark.task.maxFailures", "8");
    try (JavaSparkContext spark = new JavaSparkContext(conf)) {
      Function2<TaskContext, Iterator<Integer>, ArrayList<Found>> task =
          (Function2<TaskContext, Iterator<Integer>, ArrayList<Found>> & Serializable)
              (context, block) -> work.block(block.next(), context.cpus());
      Function2<Object, ArrayList<Found>, BoxedUnit> arrived =
          (partition, found) -> {
            found.forEach(each -> keep(each, files));
            return BoxedUnit.UNIT;
          };
      spark
          .sc()
          .runJob(
              spark.parallelize(left, left.size()).rdd(), // a partition, hence a task, a block
              task,
              CollectionConverters.<Object>asScala(
                      IntStream.range(0, left.size()).<Object>mapToObj(n -> n).toList())
                  .toSeq(),
              arrived,
              tag());
    }
  }

  @SuppressWarnings("unchecked") // the tag is of the class alone
  private static ClassTag<ArrayList<Found>> tag() {
    return (ClassTag<ArrayList<Found>>) (ClassTag<?>) ClassTag$.MODULE$.apply(ArrayList.class);
  }

  /** Writes a row; called in the driver, one block at a time. */
  private static void keep(Found found, SurveyFiles files) {
    if (!files.isDone(found.row().job().number())) {
      try {
        files.append(found.row(), found.times());
      } catch (ImageFileException e) {
        throw new UncheckedIOException(e);
      }
    }
  }
}
