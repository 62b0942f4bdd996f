package org.hdispatch.app.lattice;

import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Predicate;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.StandardOptions;
import org.hdispatch.app.console.StatusLine;
import org.hdispatch.app.console.ThreadOptions;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.app.console.Version;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.app.text.Table;
import org.hdispatch.app.watch.CollectorReport;
import org.hdispatch.app.watch.CollectorWatch;
import org.hdispatch.app.watch.GcReportOption;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Tick;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.lbm.immersed.SettlingSphere;
import org.hdispatch.porous.io.ImageFileException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code hdispatch settle}: a sphere that settles in oil, against the measurement. */
@Command(
    name = "settle",
    description = {
      "Let a sphere of 15 mm settle in a box of oil, and compare its peak velocity with the"
          + " experiment of ten Cate et al., Physics of Fluids 14, 2002, 4012.",
      "Immersed moving boundaries: the sphere moves freely, no node is added or removed."
    })
public final class SettleCommand implements Callable<Integer> {
  /** Share of the peak velocity at which the sphere feels the bottom, and all is known. */
  private static final double PAST_PEAK = 0.97;

  /** Times the time to the bottom at the measured velocity after which to give up. */
  private static final double PATIENCE = 2;

  /** Heap of a node, from above: populations, plan, set-up. */
  private static final double BYTES_PER_NODE = 19 * (Double.BYTES + Integer.BYTES) + 100;

  private static final int MOST_ACROSS = 200;

  /** Steps between two looks at whether it is time for news. */
  private static final long STEPS_BETWEEN = 10;

  /** Steps after which the kernels are compiled; a multiple of those. */
  private static final long WARM_UP = 200;

  private static final double SECONDS_BETWEEN = 0.2;

  private final Host host;

  @Option(
      names = "--fluid",
      paramLabel = "FLUID",
      defaultValue = "e1",
      completionCandidates = Choices.OfFluid.class,
      description =
          "Oil of the experiment: ${COMPLETION-CANDIDATES}; Reynolds number 1.5, 4.1, 11.6, 31.9.")
  private SettlingSphere.Fluid fluid;

  @Option(
      names = "--nodes-across",
      paramLabel = "N",
      description = "Nodes across the sphere, at least 3; the work grows with the fifth power.")
  private int nodesAcross = 8;

  @Mixin private final ThreadOptions threadOptions = new ThreadOptions();

  @Option(names = "--json", description = "Print the result as one flat JSON object.")
  private boolean json;

  @Option(names = "--quiet", description = "No progress on standard error.")
  private boolean quiet;

  @Mixin private final GcReportOption gcReport = new GcReportOption();
  @Mixin private final StandardOptions standard = new StandardOptions();
  @Spec private CommandSpec spec;

  private double nextAt; // s, of the next progress
  private double peak;

  /**
   * Makes the command.
   *
   * @param host what it runs in
   */
  public SettleCommand(Host host) {
    this.host = host;
  }

  @Override
  public Integer call() throws ImageFileException {
    int threads = threadOptions.threads();
    if (nodesAcross < 3 || nodesAcross > MOST_ACROSS) {
      throw new UsageException(
          "nodes across the sphere must number 3 to " + MOST_ACROSS + ": nodes=" + nodesAcross);
    }
    double nodes = SettlingSphere.boxNodes(nodesAcross);
    host.requireHeap(
        String.format(Locale.ROOT, "a box of %.0f nodes", nodes), nodes * BYTES_PER_NODE);
    gcReport.check();
    try (CollectorWatch collector = CollectorWatch.recording();
        Dispatcher dispatcher = Dispatcher.withWorkers(threads)) {
      SettlingSphere settling = SettlingSphere.across(fluid, nodesAcross);
      TimeLoop loop = dispatcher.loop(settling.scheme());
      collector.begin();
      double seconds = settle(settling, loop, collector);
      collector.stepped();
      var left =
          new CollectorReport(
              Optional.of(collector.figures()),
              loop.stats(),
              loop.tick().step() - loop.stats().steps());
      return report(settling, loop.tick().step(), seconds, left);
    }
  }

  /** Steps until the sphere feels the bottom; progress is shown between runs, as it allocates. */
  private double settle(SettlingSphere settling, TimeLoop loop, CollectorWatch collector) {
    Predicate<Tick> pastPeak =
        tick -> {
          double velocity = settling.velocity();
          peak = Math.max(peak, velocity);
          return !(velocity >= PAST_PEAK * peak);
        };
    long last = (long) Math.ceil(PATIENCE * settling.gap() / fluid.peak() / settling.timeStep());
    long started = System.nanoTime();
    double seconds = 0;
    boolean past = false;
    try (StatusLine status = new StatusLine(console().err())) {
      while (!past && loop.tick().step() < last) {
        past = loop.runUntil(pastPeak, Math.min(STEPS_BETWEEN, last - loop.tick().step()));
        seconds = (System.nanoTime() - started) * 1e-9;
        progress(settling, loop.tick().step(), seconds, status);
        if (loop.tick().step() == WARM_UP && !past) {
          loop.resetStats();
          collector.warmedUp();
        }
      }
    }
    return seconds;
  }

  private int report(SettlingSphere settling, long steps, double seconds, CollectorReport left)
      throws ImageFileException {
    boolean past = settling.velocity() < PAST_PEAK * peak; // never for a NaN
    if (!past) {
      console()
          .err()
          .println(
              "hdispatch: sphere must slow down above the bottom: steps="
                  + steps
                  + ", velocity="
                  + settling.velocity()
                  + " m/s, gap="
                  + settling.gap()
                  + " m");
      return ExitCode.NOT_CONVERGED.code();
    }
    FlatRow row = row(settling, steps, seconds);
    left.putInto(row);
    Table table = table(settling, steps, seconds);
    left.putInto(table);
    console().print(json ? row.toJson() : table.toString());
    gcReport.write(left);
    return ExitCode.DONE.code();
  }

  private FlatRow row(SettlingSphere settling, long steps, double seconds) {
    return new FlatRow()
        .put("fluid", Choices.word(fluid))
        .put("density", fluid.density())
        .put("viscosity_dynamic", fluid.viscosity())
        .put("peak_velocity_m_s", peak)
        .put("peak_velocity_measured_m_s", fluid.peak())
        .put("deviation", peak / fluid.peak() - 1)
        .put("nodes_across", nodesAcross)
        .put("fluid_nodes", settling.scheme().nodes())
        .put("tau", settling.scheme().relaxation().relaxationTime())
        .put("time_step_s", settling.timeStep())
        .put("steps", steps)
        .put("time_s", steps * settling.timeStep())
        .put("gap_m", settling.gap())
        .put("threads", threadOptions.threads())
        .put("seconds_stepping", seconds)
        .put("version", Version.ofProject())
        .put("java", Version.ofJava());
  }

  private Table table(SettlingSphere settling, long steps, double seconds) {
    return new Table()
        .line(
            "oil",
            fluid
                + ", "
                + Numbers.significant(fluid.density(), 4)
                + " kg/m3, "
                + Numbers.significant(fluid.viscosity(), 3)
                + " Pa s")
        .line(
            "peak velocity",
            Numbers.significant(peak, 4)
                + " m/s, measured "
                + Numbers.significant(fluid.peak(), 4)
                + " m/s ("
                + String.format(Locale.ROOT, "%+.1f %%", 100 * (peak / fluid.peak() - 1))
                + ")")
        .line(
            "method",
            "lattice Boltzmann, "
                + settling.scheme().velocitySet()
                + ", immersed moving boundaries, "
                + nodesAcross
                + " nodes across the sphere, tau "
                + Numbers.significant(settling.scheme().relaxation().relaxationTime(), 4))
        .line(
            "steps",
            String.format(
                Locale.ROOT,
                "%d in %.2f s, %.3g s of the experiment, %d nodes",
                steps,
                seconds,
                steps * settling.timeStep(),
                settling.scheme().nodes()))
        .line("threads", threadOptions.threads() + ", Java " + Version.ofJava())
        .line("cite", "ten Cate, Nieuwstad, Derksen, Van den Akker,")
        .line("", "Physics of Fluids 14 (2002) 4012, doi:10.1063/1.1512918");
  }

  private void progress(SettlingSphere settling, long step, double seconds, StatusLine status) {
    if (!console().isWatched() || seconds < nextAt) {
      return;
    }
    nextAt = seconds + SECONDS_BETWEEN;
    status.show(
        String.format(
            Locale.ROOT,
            "step %d  time %.3f s  velocity %.4f m/s  gap %.1f mm",
            step,
            step * settling.timeStep(),
            settling.velocity(),
            1e3 * settling.gap()));
  }

  private CommandConsole console() {
    return new CommandConsole(spec, host, quiet);
  }
}
