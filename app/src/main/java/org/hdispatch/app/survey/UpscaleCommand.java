package org.hdispatch.app.survey;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.app.console.OutputOptions;
import org.hdispatch.app.console.StandardOptions;
import org.hdispatch.app.console.ThreadOptions;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.survey.SurveyTable;
import org.hdispatch.porous.upscale.BlockMap;
import org.hdispatch.porous.upscale.Upscaling;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hdispatch upscale}: from the blocks of a survey to the permeability of the sample. */
@Command(
    name = "upscale",
    description = {
      "Find the permeability of a sample from a survey of its blocks: Darcy's law between blocks"
          + " that lie side by side, and bounds.",
      "Where blocks lie outside or were left out nothing flows; blocks that do not percolate have"
          + " k = 0. A survey with failed blocks is refused; with blocks that did not converge, the"
          + " exit code is 4."
    })
public final class UpscaleCommand implements Callable<Integer> {
  private final Host host;

  @Parameters(
      index = "0",
      paramLabel = "DIR",
      description =
          "Folder of a survey: survey.csv and survey.properties. Default: none, it must be given.")
  private Path folder;

  @Mixin private final ThreadOptions threadOptions = new ThreadOptions();
  @Mixin private final OutputOptions output = new OutputOptions();
  @Mixin private final StandardOptions standard = new StandardOptions();
  @Spec private CommandSpec spec;

  /**
   * Makes the command.
   *
   * @param host what it runs in
   */
  public UpscaleCommand(Host host) {
    this.host = host;
  }

  @Override
  public Integer call() throws ImageFileException {
    Optional<Path> to = output.folder();
    int threads = threadOptions.threads();
    SurveyTable survey = SurveyTable.read(folder);
    UpscaledSample sample = upscale(survey, threads);
    List<FlatRow> rows = sample.rows();
    CommandConsole console = new CommandConsole(spec, host, output.quiet());
    console.print(output.form(rows, sample.table().toString()));
    if (to.isPresent()) {
      try (OutputFolder files = OutputFolder.open(to.get())) {
        files.write("upscale.csv", FlatRow.toCsv(rows));
        files.write("upscale.json", FlatRow.toJson(rows));
      }
    }
    if (sample.isUnsteady()) {
      console
          .err()
          .println(
              "hdispatch: every permeability must have converged (its row says which did not):"
                  + " folder="
                  + folder);
      return ExitCode.NOT_CONVERGED.code();
    }
    return ExitCode.DONE.code();
  }

  private UpscaledSample upscale(SurveyTable survey, int threads) throws ImageFileException {
    BlockMap map = map(survey);
    boolean all = map.axes().equals(EnumSet.allOf(Axis.class));
    List<UpscaledSample.Along> axes = new ArrayList<>();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(threads)) {
      for (Axis axis : map.axes()) {
        axes.add(
            new UpscaledSample.Along(
                axis,
                Upscaling.bounds(map, axis),
                all ? Optional.of(Upscaling.along(dispatcher, map, axis)) : Optional.empty()));
      }
    }
    return new UpscaledSample(survey, map, axes);
  }

  private BlockMap map(SurveyTable survey) throws ImageFileException {
    int jobs = survey.settings().jobs();
    if (survey.rows().size() < jobs) {
      throw new ImageFileException(
          "rows of all jobs must be there (let the survey go on): rows="
              + survey.rows().size()
              + " of "
              + jobs
              + ", folder="
              + folder);
    }
    try {
      return BlockMap.of(survey.rows());
    } catch (IllegalArgumentException e) { // what a survey may be, but no map
      throw new ImageFileException(e.getMessage() + ", folder=" + folder, e);
    }
  }
}
