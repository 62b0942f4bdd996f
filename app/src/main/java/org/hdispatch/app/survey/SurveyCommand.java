package org.hdispatch.app.survey;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Given;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.app.console.OutputOptions;
import org.hdispatch.app.console.StandardOptions;
import org.hdispatch.app.console.ThreadOptions;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.app.rock.FlowSettings;
import org.hdispatch.app.rock.FluidOptions;
import org.hdispatch.app.rock.ImageOptions;
import org.hdispatch.app.rock.MethodOptions;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Table;
import org.hdispatch.porous.block.BlockColumns;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.survey.SurveyFiles;
import org.hdispatch.porous.survey.SurveySettings;
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
public final class SurveyCommand implements Callable<Integer> {
  private static final List<String> WITH_COLLECT =
      List.of("--collect", "--json", "--csv", "--quiet", "--stacktrace");

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

  /**
   * Makes the command.
   *
   * @param host what it runs in
   */
  public SurveyCommand(Host host) {
    this.host = host;
  }

  @Override
  public Integer call() throws ImageFileException {
    Given given = new Given(spec.commandLine().getParseResult());
    Optional<Path> to = output.folder();
    if (survey.collect().isPresent()) {
      return collect(given, survey.collect().get());
    }
    SurveyTask task =
        new SurveyPlanner(imageOptions, survey, methodOptions, settings, fluidOptions, host)
            .task(given);
    int threads = threadOptions.threads();
    if (survey.dryRun()) {
      FlatRow row = task.planned();
      Table table = new Table();
      row.forEach((key, value) -> table.line(key.replace('_', ' '), value));
      console().print(output.form(row, table.toString()));
      return ExitCode.DONE.code();
    }
    if (to.isEmpty()) {
      throw new UsageException("--output must be given: the folder of the rows");
    }
    SurveySettings rowsDependOn = task.settings();
    String heap = task.heapOfFirst(); // after the settings, as this block is kept for the first job
    try (OutputFolder folder =
            task.shard().count() > 1
                ? OutputFolder.openShared(to.get())
                : OutputFolder.open(to.get());
        SurveyFiles files = task.open(folder.path(), rowsDependOn)) {
      new SurveyRun(task, files, threads, console(), this::note).run(heap);
      files.sort();
      return new SurveyReport(files, task.jobs(), output, console()).tell();
    }
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
        SurveyFiles.collect(folder, BlockColumns.FIGURES, BlockColumns.TIMES)) {
      int code = new SurveyReport(files, files.settings().jobs(), output, console()).tell();
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

  /** Says a line on standard error, if that is wanted. */
  private void note(String line) {
    if (!output.quiet()) {
      console().err().println("hdispatch: " + line);
    }
  }

  private CommandConsole console() {
    return new CommandConsole(spec, host, output.quiet());
  }
}
