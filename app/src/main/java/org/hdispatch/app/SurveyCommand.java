package org.hdispatch.app;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import org.hdispatch.app.text.Table;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.porous.darcy.PhysicalFlow;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.flow.Inlet;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.io.WholeFiles;
import org.hdispatch.porous.survey.BlockGrid;
import org.hdispatch.porous.survey.Shard;
import org.hdispatch.porous.survey.SurveyFiles;
import org.hdispatch.porous.survey.SurveyJob;
import org.hdispatch.porous.survey.SurveyPlan;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveySettings;
import org.hdispatch.porous.survey.SurveyStatus;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Spec;

/** {@code hdispatch survey}: the permeability of the blocks of an image, one row for each. */
@Command(
    name = "survey",
    description = {
      "Cut an image into blocks and compute the permeability of each, along one axis or several.",
      "Without IMAGE: of the bundled sample of Berea sandstone.",
      "Rows go to survey.csv in --output, one by one. The same command again goes on where it was"
          + " ended. A block that does not percolate, does not converge, lies outside or fails is a"
          + " row that says so; then the exit code is 0 for the first and third, 4 for the others."
    })
final class SurveyCommand implements Callable<Integer> {
  private static final List<String> WITH_COLLECT =
      List.of("--collect", "--json", "--csv", "--quiet", "--stacktrace");
  private static final double MIB = 1 << 20;

  private final Host host;

  @Mixin private final ImageOptions imageOptions = new ImageOptions();
  @Mixin private final SurveyOptions survey = new SurveyOptions();
  @Mixin private final MethodOptions methodOptions = new MethodOptions();
  @Mixin private final FlowSettings settings = new FlowSettings();
  @Mixin private final FluidOptions fluidOptions = new FluidOptions();
  @Mixin private final ThreadOptions threadOptions = new ThreadOptions();
  @Mixin private final OutputOptions output = new OutputOptions();
  @Mixin private final StandardOptions standard = new StandardOptions();
  @Spec private CommandSpec spec;

  SurveyCommand(Host host) {
    this.host = host;
  }

  /**
   * What is to be done.
   *
   * @param source the image
   * @param plan its blocks and axes
   * @param left blocks left out as the image ends within them
   * @param shard which of the jobs
   * @param choice how flows are computed
   * @param fluid fluid and drive
   * @param study does the jobs
   */
  private record Task(
      ImageSource source,
      SurveyPlan plan,
      long left,
      Shard shard,
      FlowChoice choice,
      PhysicalFlow fluid,
      BlockStudy study) {
    int jobs() {
      return shard.share(plan.jobs());
    }
  }

  @Override
  public Integer call() throws ImageFileException {
    Given given = new Given(spec.commandLine().getParseResult());
    Optional<Path> to = output.folder();
    if (survey.collect().isPresent()) {
      return collect(given, survey.collect().get());
    }
    Task task = task(given);
    int threads = threadOptions.threads();
    if (survey.dryRun()) {
      FlatRow row = planned(task, heapOfFirst(task));
      Table table = new Table();
      row.forEach((key, value) -> table.line(key.replace('_', ' '), value));
      console().print(output.form(row, table.toString()));
      return ExitCode.DONE.code();
    }
    if (to.isEmpty()) {
      throw new UsageException("--output must be given: the folder of the rows");
    }
    Optional<Long> check = check(task);
    String heap = heapOfFirst(task); // after the check, as this block is kept for the first job
    try (OutputFolder folder = OutputFolder.open(to.get());
        SurveyFiles files = open(folder.path(), task, check)) {
      run(task, heap, files, threads);
      files.sort();
      return report(files, task.jobs());
    }
  }

  private Task task(Given given) throws ImageFileException {
    survey.check(given);
    FlowChoice choice = FlowChoice.of(methodOptions, settings, given);
    if (choice.options().inlet() != Inlet.SLAB) {
      given.refuse("--inlet-layers", "--inlet slab");
    }
    PhysicalFlow fluid = fluidOptions.fluid();
    Shard shard = survey.shard();
    int refine = methodOptions.refine();
    ImageSource source = ImageSource.of(imageOptions);
    Rock.edgeOf(source, imageOptions);
    VoxelBox whole = source.whole();
    VoxelBox region = // may be too large for one image, as it is not read as such
        UsageException.orRefused(
            () -> imageOptions.box().orElse(whole).within(whole.nx(), whole.ny(), whole.nz()));
    Optional<BlockGrid> grid = survey.grid(region);
    SurveyPlan plan = survey.plan(whole, grid);
    if (shard.share(plan.jobs()) < 1) {
      throw new UsageException(
          "shards must be at most as many as jobs: shards="
              + shard.count()
              + ", jobs="
              + plan.jobs());
    }
    double voxels = plan.blocks().get(0).box().voxels();
    host.requireHeap("a block of " + (long) voxels + " voxels", Rock.BYTES_PER_VOXEL * voxels);
    BlockStudy study =
        new BlockStudy(source, imageOptions, settings, choice, fluid, refine, survey, host);
    return new Task(
        source, plan, grid.map(BlockGrid::partialBlocks).orElse(0L), shard, choice, fluid, study);
  }

  /**
   * Checksum of the first, the middle and the last block: of a round core, the corners are all
   * outside. Empty if one of them cannot be read, which its row will say.
   */
  private static Optional<Long> check(Task task) throws ImageFileException {
    List<SurveyPlan.Block> blocks = task.plan().blocks();
    List<VoxelBox> some =
        IntStream.of(0, blocks.size() / 2, blocks.size() - 1)
            .distinct()
            .mapToObj(n -> blocks.get(n).box())
            .toList();
    try {
      return Optional.of(task.study().checksum(some));
    } catch (ImageFileException | HeapException e) {
      if (Faults.code(e) == ExitCode.INTERRUPTED) {
        throw e;
      }
      return Optional.empty();
    }
  }

  /** What heap the first block needs, in words; that it is bad does not matter here. */
  private static String heapOfFirst(Task task) throws ImageFileException {
    SurveyJob job = task.plan().job(0);
    try {
      BlockStudy.Block block = task.study().block(job.box());
      try {
        return task.study()
            .estimatedBytes(block, job.axis())
            .map(bytes -> String.format(Locale.ROOT, "%.0f MiB", bytes / MIB))
            .orElse("unknown (it lies outside)");
      } catch (UsageException e) {
        return "unknown (" + e.getMessage() + ")";
      }
    } catch (ImageFileException | HeapException e) {
      if (Faults.code(e) == ExitCode.INTERRUPTED) {
        throw e;
      }
      return "unknown (" + e.getMessage() + ")";
    }
  }

  private SurveyFiles open(Path folder, Task task, Optional<Long> check) throws ImageFileException {
    try {
      return SurveyFiles.open(
          folder,
          task.shard(),
          settingsOf(task, check),
          SurveyColumns.FIGURES,
          SurveyColumns.TIMES);
    } catch (IllegalArgumentException e) { // other settings than those of the rows there
      throw new UsageException(e.getMessage());
    }
  }

  private FlatRow planned(Task task, String heapOfFirst) {
    VoxelBox whole = task.source().whole();
    return new FlatRow()
        .put("image", task.source().name())
        .put("size", whole.nx() + "," + whole.ny() + "," + whole.nz())
        .put("block", survey.block().toString())
        .put("blocks", task.plan().blocks().size())
        .put("partial_blocks_left_out", task.left())
        .put("axes", String.join(",", task.plan().axes().stream().map(Choices::word).toList()))
        .put("jobs", task.plan().jobs())
        .put("shard", task.shard().toString())
        .put("jobs_of_shard", task.jobs())
        .put("heap_of_first_block", heapOfFirst)
        .put("heap_given", String.format(Locale.ROOT, "%.0f MiB", host.heapBytes() / MIB));
  }

  private void run(Task task, String heapOfFirst, SurveyFiles files, int threads)
      throws ImageFileException {
    int earlier = done(task, files);
    note(
        "survey: "
            + task.jobs()
            + " jobs in "
            + task.plan().blocks().size()
            + " blocks of "
            + survey.block()
            + (task.left() > 0 ? ", " + task.left() + " partial ones left out" : "")
            + (earlier > 0 ? ", " + earlier + " done before" : "")
            + "; heap for the first block "
            + heapOfFirst
            + String.format(Locale.ROOT, ", given %.0f MiB", host.heapBytes() / MIB));
    if (earlier == task.jobs()) {
      return;
    }
    Map<String, String> same = new LinkedHashMap<>();
    SurveyColumns.SETTINGS.forEach(
        key -> same.put(key, files.settings().values().getOrDefault(key, "")));
    double edge = Rock.edgeOf(task.source(), imageOptions).getAsDouble();
    same.put("voxel_edge_m", Double.toString(edge / methodOptions.refine())); // that k is in
    try (StatusLine status = new StatusLine(console().err());
        Dispatcher dispatcher = Dispatcher.withWorkers(threads)) {
      SurveyProgress progress =
          new SurveyProgress(
              console().isWatched() ? status::show : line -> {}, this::note, task.jobs(), earlier);
      for (int number = 0; number < task.plan().jobs(); number++) {
        if (task.shard().has(number) && !files.isDone(number)) {
          SurveyJob job = task.plan().job(number);
          long begun = System.nanoTime();
          progress.begun(job);
          BlockStudy.Done done = task.study().run(dispatcher, job, same, progress);
          double seconds = (System.nanoTime() - begun) * 1e-9;
          files.append(done.row(), BlockStudy.times(done, seconds, threads));
          progress.done(seconds);
        }
      }
    } catch (CancellationException | ImageFileException e) {
      if (Faults.code(e) == ExitCode.INTERRUPTED) {
        console()
            .warn(
                done(task, files)
                    + " of "
                    + task.jobs()
                    + " jobs are done and kept, the same command goes on: file="
                    + files.file());
      }
      throw e;
    }
  }

  private static int done(Task task, SurveyFiles files) {
    int done = 0;
    for (int number = 0; number < task.plan().jobs(); number++) {
      done += task.shard().has(number) && files.isDone(number) ? 1 : 0;
    }
    return done;
  }

  /** What the rows depend on, and which image and blocks they are of. */
  private SurveySettings settingsOf(Task task, Optional<Long> check) {
    FlowOptions options = task.choice().options();
    boolean lattice = task.choice().method() == Method.LBM;
    FlatRow row =
        new FlatRow()
            .put(SurveySettings.JOBS, task.plan().jobs())
            .put("image", imageName(task.source()))
            .put("image_size", sizeOf(task.source().whole()))
            .put("box", imageOptions.box().map(VoxelBox::toString).orElse(null))
            .put("block", survey.block())
            .put("stride", survey.strideWords())
            .put("blocks", survey.choiceWords(task.plan()))
            .put("axes", String.join(",", task.plan().axes().stream().map(Choices::word).toList()))
            .put("outside", survey.outsideWords())
            .put("voxel_edge_m", Rock.edgeOf(task.source(), imageOptions))
            .put("refine", methodOptions.refine())
            .put("method", Choices.word(task.choice().method()))
            .put("sides", Choices.word(options.sides()))
            .put("inlet", Choices.word(options.inlet()))
            .put(
                "inlet_layers",
                options.inletLayers().isPresent() ? options.inletLayers().getAsInt() : "chosen")
            .put("approach", Choices.word(options.approach()))
            .put("tolerance", options.tolerance())
            .put("max_steps", options.maxSteps())
            .put("viscosity", task.fluid().viscosity())
            .put("density", task.fluid().density())
            .put("pressure_gradient", task.fluid().pressureGradient());
    if (settings.solidFractionRange().isPresent()) {
      List<Integer> grey = settings.solidFractionRange().get();
      row.put("solid_fraction_range", grey.get(0) + "," + grey.get(1));
    } else {
      row.put("pore_values", imageOptions.rule().toString().replace("pore=", ""));
    }
    if (lattice) {
      row.put("lattice", options.velocitySet().name())
          .put("storage", Choices.word(options.storage()))
          .put("collision", Choices.word(options.collision()))
          .put(
              "tau",
              options.relaxationTime().isPresent()
                  ? options.relaxationTime().getAsDouble()
                  : "chosen")
          .put("walls", Choices.word(settings.walls()));
    } else {
      row.put("smoothing_length", task.choice().particles().smoothingLength())
          .put("wall_factor", task.choice().particles().wallFactor());
    }
    row.put("version", Version.ofProject());
    check.ifPresent(sum -> row.put(SurveySettings.BLOCKS_CRC, Long.toHexString(sum)));
    Map<String, String> values = new LinkedHashMap<>();
    row.forEach(values::put);
    return new SurveySettings(values);
  }

  private static String sizeOf(VoxelBox whole) {
    return whole.nx() + "," + whole.ny() + "," + whole.nz();
  }

  /** The name of the image without its folder, which may differ between machines. */
  private String imageName(ImageSource source) {
    return imageOptions
        .image()
        .map(file -> source.name().replace(file.toString(), file.getFileName().toString()))
        .orElse(source.name());
  }

  private int collect(Given given, Path folder) throws ImageFileException {
    for (OptionSpec each : given.parsed().matchedOptions()) {
      if (!WITH_COLLECT.contains(each.longestName())) {
        throw new UsageException("--collect must come without " + each.longestName());
      }
    }
    if (imageOptions.image().isPresent()) {
      throw new UsageException("--collect must come without an image");
    }
    try (SurveyFiles files =
        SurveyFiles.collect(folder, SurveyColumns.FIGURES, SurveyColumns.TIMES)) {
      int code = report(files, files.settings().jobs());
      List<Integer> missing = files.missing();
      if (missing.isEmpty()) {
        return code;
      }
      console()
          .err()
          .println(
              "hdispatch: rows of all jobs must be there (let the shards go on): missing="
                  + missing.size()
                  + " of "
                  + files.settings().jobs()
                  + ", jobs="
                  + listed(missing)
                  + ", folder="
                  + folder);
      return ExitCode.FILE.code();
    }
  }

  private static String listed(List<Integer> jobs) {
    List<String> first = jobs.stream().limit(10).map(String::valueOf).toList();
    return String.join(",", first) + (jobs.size() > 10 ? ",..." : "");
  }

  private int report(SurveyFiles files, int jobs) throws ImageFileException {
    List<SurveyRow> found = files.rows();
    SurveySummary summary = new SurveySummary(jobs, found);
    List<FlatRow> rows = found.stream().map(SurveyColumns::flat).toList();
    WholeFiles.write(files.jsonFile(), FlatRow.toJson(summary.row(), rows));
    Table table = summary.table();
    table
        .line("rows", files.file().toString())
        .line("", files.jsonFile().toString())
        .line("times", files.timesFile().toString())
        .line("settings", files.settingsFile().toString());
    console().print(output.form(summary.row(), rows, table.toString()));
    int failed = summary.count(SurveyStatus.FAILED);
    int unsteady = summary.count(SurveyStatus.NOT_CONVERGED);
    if (failed + unsteady == 0) {
      return ExitCode.DONE.code();
    }
    console()
        .err()
        .println(
            "hdispatch: every block must have a converged k (its row says why not): failed="
                + failed
                + ", not converged="
                + unsteady
                + ", file="
                + files.file());
    return ExitCode.NOT_CONVERGED.code();
  }

  /** Says a line on standard error, if that is wanted. */
  private void note(String line) {
    if (!output.quiet()) {
      console().err().println("hdispatch: " + line);
    }
  }

  private CommandConsole console() {
    return new CommandConsole(spec, host, output);
  }
}
