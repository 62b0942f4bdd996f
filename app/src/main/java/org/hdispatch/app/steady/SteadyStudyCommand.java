package org.hdispatch.app.steady;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Given;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.app.console.OutputOptions;
import org.hdispatch.app.console.StandardOptions;
import org.hdispatch.app.console.StatusLine;
import org.hdispatch.app.console.ThreadOptions;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.app.rock.ImageOptions;
import org.hdispatch.app.rock.ImageSource;
import org.hdispatch.app.rock.Rock;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.porous.block.Pores;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.flow.LbmFlow;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.io.ImageFileException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/**
 * {@code hdispatch steady-study}: how k comes to its steady value, with corrections and without.
 */
@Command(
    name = "steady-study",
    description = {
      "Follow k to its steady value, over steps and over seconds: pressure started and corrected (the"
          + " default of permeability) against plain stepping from rest (--approach plain).",
      "Without IMAGE: in rocks of overlapping random spheres. With IMAGE: in the whole of it, or in"
          + " one part for each --box.",
      "--output writes a page, steady-study.html, with curves, tables and a verdict, and the data."
    })
public final class SteadyStudyCommand implements Callable<Integer> {
  private static final String NAME = "steady-study";

  private final Host host;

  @Mixin private final ImageOptions imageOptions = new ImageOptions();
  @Mixin private final SteadyStudyOptions options = new SteadyStudyOptions();
  @Mixin private final ThreadOptions threadOptions = new ThreadOptions();
  @Mixin private final OutputOptions output = new OutputOptions();
  @Mixin private final StandardOptions standard = new StandardOptions();
  @Spec private CommandSpec spec;

  /**
   * Makes the command.
   *
   * @param host what it runs in
   */
  public SteadyStudyCommand(Host host) {
    this.host = host;
  }

  @Override
  public Integer call() throws ImageFileException {
    checkCombinations();
    FlowOptions flow = options.flow();
    int threads = threadOptions.threads();
    List<Rock> rocks = imageOptions.image().isPresent() ? parts() : options.rocks(host);
    requireHeap(rocks, flow);
    SteadyStudy study = new SteadyStudy(rocks, flow, threads, console()::warn);
    if (output.folder().isEmpty()) {
      run(study, rocks.size());
      return report(study.result(), Optional.empty());
    }
    try (OutputFolder folder = OutputFolder.open(output.folder().get())) {
      run(study, rocks.size());
      return report(study.result(), Optional.of(folder));
    }
  }

  /** The parts of the image that the options say. */
  private List<Rock> parts() throws ImageFileException {
    ImageSource source = ImageSource.of(imageOptions);
    List<VoxelBox> boxes = new ArrayList<>();
    for (VoxelBox box : imageOptions.boxes()) {
      boxes.add(Rock.boxOf(source, Optional.of(box)));
    }
    if (boxes.isEmpty()) {
      boxes.add(Rock.boxOf(source, Optional.empty()));
    }
    List<Rock> rocks = new ArrayList<>();
    for (VoxelBox box : boxes) {
      rocks.add(Rock.of(source, box, imageOptions, host));
    }
    return rocks;
  }

  private void requireHeap(List<Rock> rocks, FlowOptions flow) {
    long voxels = rocks.stream().mapToLong(rock -> rock.space().voxels()).sum();
    for (Rock rock : rocks) {
      long bytes = UsageException.orRefused(() -> LbmFlow.estimatedBytes(rock.space(), flow));
      host.requireHeap(
          "the flow of " + rock.space().poreVoxels() + " pore voxels",
          bytes + (double) voxels * Pores.BYTES_PER_VOXEL);
    }
  }

  private void run(SteadyStudy study, int rocks) {
    try (StatusLine status = new StatusLine(console().err())) {
      study.run(
          console().isWatched() ? new SteadyProgress(status, rocks) : SteadyStudy.Listener.NONE);
    } catch (CancellationException e) {
      interrupted(study.result(), rocks);
      throw e;
    }
  }

  /** Prints what there is; files are only written whole. */
  private void interrupted(SteadyResult result, int rocks) {
    console()
        .warn(result.rocks().size() + " of " + rocks + " rocks are done, no files are written");
    if (!result.rocks().isEmpty()) {
      console().out().print(output.form(SteadyReport.rows(result), SteadyReport.text(result)));
      console().out().flush();
    }
  }

  private int report(SteadyResult result, Optional<OutputFolder> folder) throws ImageFileException {
    List<FlatRow> rows = SteadyReport.rows(result);
    console().print(output.form(rows, SteadyReport.text(result)));
    if (folder.isPresent()) {
      write(result, rows, folder.get());
    }
    for (SteadyComparison each : result.rocks()) {
      if (!each.reference().converged()) {
        return notConverged(result, each);
      }
    }
    return ExitCode.DONE.code();
  }

  private void write(SteadyResult result, List<FlatRow> rows, OutputFolder folder)
      throws ImageFileException {
    String csv = NAME + ".csv";
    String json = NAME + ".json";
    String curves = NAME + "-curves.csv";
    folder.write(csv, FlatRow.toCsv(rows));
    folder.write(json, FlatRow.toJson(rows));
    folder.write(curves, FlatRow.toCsv(SteadyReport.curves(result)));
    List<String> given = spec.root().commandLine().getParseResult().originalArgs();
    String command = "./hdispatch " + String.join(" ", given);
    folder.write(NAME + ".html", new SteadyPage(result).page(command, List.of(csv, json, curves)));
  }

  private int notConverged(SteadyResult result, SteadyComparison each) {
    console()
        .err()
        .println(
            "hdispatch: steady k must be known (give more --max-steps): rock="
                + each.rock().name()
                + ", steps="
                + each.reference().steps()
                + ", error="
                + each.reference().errorEstimate()
                + ", tolerance="
                + result.referenceTolerance());
    return ExitCode.NOT_CONVERGED.code();
  }

  private CommandConsole console() {
    return new CommandConsole(spec, host, output.quiet());
  }

  private void checkCombinations() {
    output.folder();
    Given given = new Given(spec.commandLine().getParseResult());
    if (imageOptions.image().isPresent()) {
      SteadyStudyOptions.ROCKS.forEach(name -> given.refuse(name, "random spheres, not an image"));
    } else {
      ImageOptions.NAMES.forEach(name -> given.refuse(name, "an IMAGE"));
      given.refuse("--voxel-edge", "an IMAGE");
    }
  }
}
