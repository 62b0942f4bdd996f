package org.hdispatch.app;

import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.lbm.immersed.ImmersedBodies;
import org.hdispatch.porous.darcy.PhysicalFlow;
import org.hdispatch.porous.flow.FlowListener;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.flow.Inlet;
import org.hdispatch.porous.flow.LbmFlow;
import org.hdispatch.porous.flow.Sides;
import org.hdispatch.porous.flow.SphFlow;
import org.hdispatch.porous.flow.SteadyFlow;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.pore.PoreSpace;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;

/** {@code hdispatch permeability}: from a rock image, or regular spheres, to k. */
@Command(
    name = "permeability",
    description = {
      "Compute the permeability of a rock image along one axis.",
      "Without IMAGE and --spheres: of the bundled sample of Berea sandstone."
    })
final class PermeabilityCommand implements Callable<Integer> {
  /** Above this the drag is no longer proportional to the velocity, and k means little. */
  private static final double DARCY_REYNOLDS = 1;

  private final Host host;

  @Mixin private final ImageOptions imageOptions = new ImageOptions();
  @Mixin private final SphereOptions spheres = new SphereOptions();
  @Mixin private final MethodOptions methodOptions = new MethodOptions();
  @Mixin private final FlowSettings settings = new FlowSettings();
  @Mixin private final FluidOptions fluidOptions = new FluidOptions();
  @Mixin private final ThreadOptions threadOptions = new ThreadOptions();
  @Mixin private final OutputOptions output = new OutputOptions();
  @Mixin private final GcReportOption gcReport = new GcReportOption();
  @Mixin private final StandardOptions standard = new StandardOptions();
  @Spec private CommandSpec spec;

  PermeabilityCommand(Host host) {
    this.host = host;
  }

  @Override
  public Integer call() throws ImageFileException {
    checkCombinations();
    FlowOptions options = flowOptions();
    PhysicalFlow fluid = fluidOptions.fluid();
    threadOptions.threads();
    methodOptions.particles();
    int finer = methodOptions.refine();
    Rock whole =
        spheres.packing().isPresent()
            ? Rock.of(spheres, imageOptions, settings.walls(), host)
            : Rock.of(ImageSource.of(imageOptions), imageOptions, settings, host);
    Rock rock = whole.refined(finer, host);
    requireHeap(rock, options);
    gcReport.check();
    if (output.folder().isEmpty()) {
      return report(compute(rock, options, fluid), Optional.empty());
    }
    try (OutputFolder folder = OutputFolder.open(output.folder().get())) {
      return report(compute(rock, options, fluid), Optional.of(folder));
    }
  }

  private Outcome compute(Rock rock, FlowOptions options, PhysicalFlow fluid) {
    try (CollectorWatch collector = new CollectorWatch();
        ProgressLine progress = new ProgressLine(err(), rock.voxelEdge());
        Dispatcher dispatcher = Dispatcher.withWorkers(threadOptions.threads())) {
      List<FlowListener> listeners = new ArrayList<>(List.of(collector));
      if (host.terminal() && !output.quiet()) {
        listeners.add(progress);
      }
      FlowListener all = new Listeners(listeners);
      SteadyFlow flow = solve(dispatcher, rock, options, all);
      return new Outcome(
          methodOptions.method(), rock, fluid, flow, threadOptions.threads(), figures(collector));
    }
  }

  private SteadyFlow solve(
      Dispatcher dispatcher, Rock rock, FlowOptions options, FlowListener listener) {
    if (methodOptions.method() == Method.SPH) {
      return SphFlow.solve(dispatcher, rock.space(), options, methodOptions.particles(), listener);
    }
    return rock.solid().isPresent()
        ? LbmFlow.solve(dispatcher, rock.solid().get(), options, listener)
        : LbmFlow.solve(dispatcher, rock.space(), options, listener);
  }

  private Optional<CollectorWatch.Figures> figures(CollectorWatch collector) {
    try {
      return Optional.of(collector.figures());
    } catch (UncheckedIOException e) { // a pity, but k is worth more
      warn("figures of the collector must be readable: cause=" + e.getCause());
      return Optional.empty();
    }
  }

  private int report(Outcome outcome, Optional<OutputFolder> folder) throws ImageFileException {
    FlatRow row = OutcomeRow.of(outcome);
    PrintWriter out = spec.commandLine().getOut();
    out.print(output.form(row, OutcomeTable.of(outcome)));
    if (out.checkError()) {
      throw new ImageFileException("standard output must be writable");
    }
    if (folder.isPresent()) {
      new FieldFiles(outcome).write(folder.get());
      folder.get().write("result.json", row.toJson());
    }
    gcReport.write(outcome.collectorReport());
    OptionalDouble reynolds = outcome.reynolds();
    if (reynolds.isPresent() && reynolds.getAsDouble() > DARCY_REYNOLDS) {
      warn(
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
      warn(
          "immersed boundaries bring nothing to a segmented image (grey values need"
              + " --solid-fraction-range): image="
              + outcome.rock().name());
    }
    if (outcome.percolates()) {
      double tau = outcome.flow().chosen().relaxationTime();
      String caution = ImmersedBodies.caution(outcome.options().collision().at(tau));
      if (!caution.isEmpty()) {
        warn(caution);
      }
    }
  }

  private int notConverged(Outcome outcome) {
    err()
        .println(
            "hdispatch: permeability must converge (give more --max-steps): steps="
                + outcome.flow().work().steps()
                + ", error="
                + outcome.flow().errorEstimate()
                + ", tolerance="
                + outcome.options().tolerance());
    return ExitCode.NOT_CONVERGED.code();
  }

  private PrintWriter err() {
    return spec.commandLine().getErr();
  }

  private void warn(String line) {
    if (!output.quiet()) {
      err().println("hdispatch: warning: " + line);
    }
  }

  private FlowOptions flowOptions() {
    FlowOptions options = settings.options();
    if (methodOptions.method() == Method.SPH && !given().hasMatchedOption("--tolerance")) {
      options = options.withTolerance(MethodOptions.SPH_TOLERANCE);
    }
    if (settings.walls() == Walls.IMB) {
      if (!given().hasMatchedOption("--lattice")) {
        options = options.withVelocitySet(FlowOptions.IMMERSED.velocitySet());
      }
      if (!given().hasMatchedOption("--collision")) {
        options = options.withCollision(FlowOptions.IMMERSED.collision());
      }
    }
    return spheres.packing().isPresent()
        ? options.withBoundaries(Sides.PERIODIC, Inlet.PERIODIC)
        : options;
  }

  private void requireHeap(Rock rock, FlowOptions options) {
    PoreSpace space = rock.space();
    long flow = // refused: rock without any wall
        UsageException.orRefused(
            () ->
                methodOptions.method() == Method.SPH
                    ? SphFlow.estimatedBytes(space, options)
                    : rock.solid().isPresent()
                        ? LbmFlow.estimatedBytes(rock.solid().get(), options)
                        : LbmFlow.estimatedBytes(space, options));
    double bytes = flow + (double) space.voxels() * Rock.BYTES_PER_VOXEL;
    host.requireHeap("the flow of " + space.poreVoxels() + " pore voxels", bytes);
  }

  private void checkCombinations() {
    output.folder();
    if (methodOptions.method() == Method.SPH) {
      MethodOptions.LBM_NAMES.forEach(name -> refuse(name, "--method lbm"));
    } else {
      MethodOptions.SPH_NAMES.forEach(name -> refuse(name, "--method sph"));
    }
    if (settings.walls() != Walls.IMB) {
      refuse("--solid-fraction-range", "--walls imb");
    }
    if (settings.solidFractionRange().isPresent()) {
      refuse("--pore-value", "a segmented image, not --solid-fraction-range");
    }
    if (spheres.packing().isPresent()) {
      if (imageOptions.image().isPresent()) {
        throw new UsageException(
            "--spheres must not be combined with an image: image=" + imageOptions.image().get());
      }
      ImageOptions.NAMES.forEach(name -> refuse(name, "an image, not --spheres"));
      refuse("--solid-fraction-range", "an image, not --spheres");
      requirePeriodic("--sides", Sides.PERIODIC);
      requirePeriodic("--inlet", Inlet.PERIODIC);
      refuse("--inlet-layers", "--inlet slab, not --spheres");
    } else {
      SphereOptions.NAMES.forEach(name -> refuse(name, "--spheres"));
      if (settings.options().inlet() != Inlet.SLAB) {
        refuse("--inlet-layers", "--inlet slab");
      }
    }
  }

  private ParseResult given() {
    return spec.commandLine().getParseResult();
  }

  private void refuse(String option, String belongsTo) {
    if (given().hasMatchedOption(option)) {
      throw new UsageException(option + " must come with " + belongsTo);
    }
  }

  private void requirePeriodic(String option, Enum<?> periodic) {
    if (given().hasMatchedOption(option) && given().matchedOptionValue(option, null) != periodic) {
      throw new UsageException("spheres must be periodic on all sides: leave out " + option);
    }
  }
}
