package org.hdispatch.app.permeability;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Given;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.app.console.OutputOptions;
import org.hdispatch.app.console.StandardOptions;
import org.hdispatch.app.console.ThreadOptions;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.app.rock.FlowChoices;
import org.hdispatch.app.rock.FlowSettings;
import org.hdispatch.app.rock.FluidOptions;
import org.hdispatch.app.rock.ImageOptions;
import org.hdispatch.app.rock.ImageSource;
import org.hdispatch.app.rock.MethodOptions;
import org.hdispatch.app.rock.Rock;
import org.hdispatch.app.rock.SphereOptions;
import org.hdispatch.app.rock.TensorFigures;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.app.text.Table;
import org.hdispatch.app.watch.CollectorWatch;
import org.hdispatch.app.watch.GcReportOption;
import org.hdispatch.app.watch.Listeners;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.lbm.immersed.ImmersedBodies;
import org.hdispatch.porous.block.FlowChoice;
import org.hdispatch.porous.darcy.PermeabilityColumn;
import org.hdispatch.porous.darcy.PhysicalFlow;
import org.hdispatch.porous.flow.FlowListener;
import org.hdispatch.porous.flow.Inlet;
import org.hdispatch.porous.flow.Sides;
import org.hdispatch.porous.flow.SteadyFlow;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.io.ImageFileException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code hdispatch permeability}: from a rock image, or regular spheres, to k. */
@Command(
    name = "permeability",
    description = {
      "Compute the permeability of a rock image along one axis, or its tensor.",
      "Without IMAGE and --spheres: of the bundled sample of Berea sandstone."
    })
public final class PermeabilityCommand implements Callable<Integer> {
  /** Above this the drag is no longer proportional to the velocity, and k means little. */
  private static final double DARCY_REYNOLDS = 1;

  private final Host host;

  @Mixin private final ImageOptions imageOptions = new ImageOptions();
  @Mixin private final SphereOptions spheres = new SphereOptions();
  @Mixin private final MethodOptions methodOptions = new MethodOptions();
  @Mixin private final AxisOption axisOption = new AxisOption();
  @Mixin private final FlowSettings settings = new FlowSettings();
  @Mixin private final FluidOptions fluidOptions = new FluidOptions();
  @Mixin private final ThreadOptions threadOptions = new ThreadOptions();
  @Mixin private final OutputOptions output = new OutputOptions();
  @Mixin private final GcReportOption gcReport = new GcReportOption();
  @Mixin private final StandardOptions standard = new StandardOptions();
  @Spec private CommandSpec spec;

  /**
   * Makes the command.
   *
   * @param host what it runs in
   */
  public PermeabilityCommand(Host host) {
    this.host = host;
  }

  @Override
  public Integer call() throws ImageFileException {
    FlowChoice choice = choice();
    PhysicalFlow fluid = fluidOptions.fluid();
    threadOptions.threads();
    List<Axis> axes = axisOption.axes();
    int finer = methodOptions.refine();
    Rock whole =
        spheres.packing().isPresent()
            ? Rock.of(spheres, imageOptions, settings.walls(), host)
            : Rock.of(ImageSource.of(imageOptions), imageOptions, settings, host);
    Rock rock = whole.refined(finer, host);
    for (Axis axis : axes) {
      requireHeap(choice.along(axis), rock);
    }
    gcReport.check();
    if (output.folder().isEmpty()) {
      return compute(rock, choice, fluid, axes, Optional.empty());
    }
    try (OutputFolder folder = OutputFolder.open(output.folder().get())) {
      return compute(rock, choice, fluid, axes, Optional.of(folder));
    }
  }

  private int compute(
      Rock rock,
      FlowChoice choice,
      PhysicalFlow fluid,
      List<Axis> axes,
      Optional<OutputFolder> folder)
      throws ImageFileException {
    return axes.size() == 1
        ? report(compute(rock, choice.along(axes.get(0)), fluid), folder)
        : tensor(rock, choice, fluid, folder);
  }

  /** The flows along all axes, one after the other; of each, only its figures are kept. */
  private int tensor(
      Rock rock, FlowChoice choice, PhysicalFlow fluid, Optional<OutputFolder> folder)
      throws ImageFileException {
    List<FlatRow> rows = new ArrayList<>();
    StringBuilder text = new StringBuilder();
    List<Double> diagonal = new ArrayList<>();
    List<Optional<PermeabilityColumn>> columns = new ArrayList<>();
    int code = ExitCode.DONE.code();
    for (Axis axis : Axis.values()) {
      Outcome outcome = compute(rock, choice.along(axis), fluid);
      FlatRow row = OutcomeRow.of(outcome);
      rows.add(row);
      text.append(OutcomeTable.of(outcome)).append(System.lineSeparator());
      diagonal.add(outcome.flow().permeability());
      columns.add(outcome.flow().column());
      if (folder.isPresent()) {
        try (OutputFolder own = OutputFolder.open(folder.get().file(Choices.word(axis)))) {
          write(outcome, row, own);
        }
      }
      code = Math.max(code, judge(outcome));
    }
    TensorFigures tensor = TensorFigures.of(diagonal, columns, rock.voxelEdge());
    Table table = new Table();
    tensor.putInto(table);
    FlatRow summary = tensor.putInto(new FlatRow());
    console().print(output.form(summary, rows, text.append(table).toString()));
    if (folder.isPresent()) {
      folder.get().write("tensor.json", summary.toJson());
    }
    return code;
  }

  private void requireHeap(FlowChoice choice, Rock rock) {
    try {
      choice.requireHeap(rock.pores(), host.heap());
    } catch (IllegalArgumentException e) { // rock without any wall
      throw new UsageException(e.getMessage());
    }
  }

  private Outcome compute(Rock rock, FlowChoice choice, PhysicalFlow fluid) {
    try (CollectorWatch collector = gcReport.watch();
        ProgressLine progress = new ProgressLine(console().err(), rock.voxelEdge());
        Dispatcher dispatcher = Dispatcher.withWorkers(threadOptions.threads())) {
      List<FlowListener> listeners = new ArrayList<>(List.of(collector));
      if (console().isWatched()) {
        listeners.add(progress);
      }
      FlowListener all = new Listeners(listeners);
      SteadyFlow flow = choice.solve(dispatcher, rock.pores(), all);
      return new Outcome(
          choice.method(),
          rock,
          fluid,
          flow,
          threadOptions.threads(),
          collector.figures(console()));
    }
  }

  private int report(Outcome outcome, Optional<OutputFolder> folder) throws ImageFileException {
    FlatRow row = OutcomeRow.of(outcome);
    console().print(output.form(row, OutcomeTable.of(outcome)));
    if (folder.isPresent()) {
      write(outcome, row, folder.get());
    }
    gcReport.write(outcome.collectorReport());
    return judge(outcome);
  }

  private static void write(Outcome outcome, FlatRow row, OutputFolder folder)
      throws ImageFileException {
    new FieldFiles(outcome).write(folder);
    folder.write("result.json", row.toJson());
  }

  /** Warns of what may be wrong with a result; returns the exit code. */
  private int judge(Outcome outcome) {
    OptionalDouble reynolds = outcome.reynolds();
    if (reynolds.isPresent() && reynolds.getAsDouble() > DARCY_REYNOLDS) {
      console()
          .warn(
              "Reynolds number should be below 1 for Darcy's law to hold at this pressure gradient: Re="
                  + Numbers.significant(reynolds.getAsDouble(), 3));
    }
    if (outcome.rock().solid().isPresent()) {
      warnOfImmersion(outcome);
    }
    return outcome.flow().converged() ? ExitCode.DONE.code() : notConverged(outcome);
  }

  private void warnOfImmersion(Outcome outcome) {
    if (spheres.packing().isEmpty() && settings.solidFractionRange().isEmpty()) {
      console()
          .warn(
              "immersed boundaries bring nothing to a segmented image (grey values need"
                  + " --solid-fraction-range): image="
                  + outcome.rock().name());
    }
    if (outcome.percolates()) {
      double tau = outcome.flow().chosen().relaxationTime();
      String caution = ImmersedBodies.caution(outcome.options().collision().at(tau));
      if (!caution.isEmpty()) {
        console().warn(caution);
      }
    }
  }

  private int notConverged(Outcome outcome) {
    console()
        .err()
        .println(
            "hdispatch: permeability must converge (give more --max-steps): steps="
                + outcome.flow().work().steps()
                + ", error="
                + outcome.flow().errorEstimate()
                + ", tolerance="
                + outcome.options().tolerance());
    return ExitCode.NOT_CONVERGED.code();
  }

  private CommandConsole console() {
    return new CommandConsole(spec, host, output.quiet());
  }

  private FlowChoice choice() {
    output.folder();
    Given given = new Given(spec.commandLine().getParseResult());
    if (axisOption.axes().size() > 1) {
      given.refuse("--gc-report", "one axis, not --axis all");
    }
    FlowChoice choice = FlowChoices.of(methodOptions, settings, given);
    if (spheres.packing().isEmpty()) {
      SphereOptions.NAMES.forEach(name -> given.refuse(name, "--spheres"));
      if (choice.options().inlet() != Inlet.SLAB) {
        given.refuse("--inlet-layers", "--inlet slab");
      }
      return choice;
    }
    if (imageOptions.image().isPresent()) {
      throw new UsageException(
          "--spheres must not be combined with an image: image=" + imageOptions.image().get());
    }
    ImageOptions.NAMES.forEach(name -> given.refuse(name, "an image, not --spheres"));
    given.refuse("--solid-fraction-range", "an image, not --spheres");
    requirePeriodic(given, "--sides", Sides.PERIODIC);
    requirePeriodic(given, "--inlet", Inlet.PERIODIC);
    given.refuse("--inlet-layers", "--inlet slab, not --spheres");
    return choice.with(choice.options().withBoundaries(Sides.PERIODIC, Inlet.PERIODIC));
  }

  private static void requirePeriodic(Given given, String option, Enum<?> periodic) {
    if (given.has(option) && given.parsed().matchedOptionValue(option, null) != periodic) {
      throw new UsageException("spheres must be periodic on all sides: leave out " + option);
    }
  }
}
