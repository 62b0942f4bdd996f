package org.hdispatch.app.particles;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.app.console.OutputOptions;
import org.hdispatch.app.console.StandardOptions;
import org.hdispatch.app.console.ThreadOptions;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.app.text.Table;
import org.hdispatch.app.watch.GcReportOption;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.cases.SphRun;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code hdispatch sph CASE}: a flow of which something is known, and how right it is. */
@Command
final class SphCaseCommand implements Callable<Integer> {
  private static final int DIGITS = 5;

  /** Steps that a run may take. */
  private static final double MOST_STEPS = 1e8;

  private final Host host;
  private final ReadyCase which;

  @Option(
      names = "--size",
      paramLabel = "N",
      description = "Particles across. Default: as many as show what is known in little time.")
  private Integer size;

  @Option(
      names = "--time",
      paramLabel = "T",
      description =
          "Time to run, in the unit of the case. Default: until all that is known can be compared.")
  private Double time;

  @Mixin private final SphSchemeOptions options = new SphSchemeOptions();
  @Mixin private final ThreadOptions threadOptions = new ThreadOptions();
  @Mixin private final OutputOptions output = new OutputOptions();
  @Mixin private final GcReportOption gcReport = new GcReportOption();
  @Mixin private final StandardOptions standard = new StandardOptions();
  @Spec private CommandSpec spec;

  SphCaseCommand(Host host, ReadyCase which) {
    this.host = host;
    this.which = which;
  }

  @Override
  public Integer call() throws ImageFileException {
    output.folder();
    threadOptions.threads();
    int across = size == null ? which.usualSize() : size;
    ReadyFlow flow = UsageException.orRefused(() -> which.flow(across));
    double duration = time == null ? flow.duration() : time;
    if (!(duration > 0 && Double.isFinite(duration))) {
      throw new UsageException("time must be positive and finite: time=" + duration);
    }
    SphSchemeBuilder settings = flow.settings();
    options.form(settings.kernel());
    gcReport.check();
    if (output.folder().isEmpty()) {
      run(flow, settings, across, duration, Optional.empty());
    } else {
      try (OutputFolder folder = OutputFolder.open(output.folder().get())) {
        run(flow, settings, across, duration, Optional.of(folder));
      }
    }
    return ExitCode.DONE.code();
  }

  private void run(
      ReadyFlow flow,
      SphSchemeBuilder settings,
      int across,
      double duration,
      Optional<OutputFolder> folder)
      throws ImageFileException {
    SphHeap.requireSites(host, settings.sites());
    Particles particles = flow.particles();
    double support = settings.kernel().supportRadius() / flow.spacing();
    int dimensions = settings.kernel().dimensions();
    SphHeap.require(host, options.search(), dimensions, particles.count(), support);
    SphScheme scheme = options.scheme(settings, flow.spacing(), particles);
    SphRun run = runFor(duration, scheme);
    CommandConsole console = new CommandConsole(spec, host, output.quiet());
    SphStepper stepper = new SphStepper(console, options, threadOptions.threads());
    SphReport report = stepper.run(Choices.word(which), scheme, flow.spacing(), run);
    double reached = (run.warmUpSteps() + run.steps()) * scheme.timeStep();
    List<ReadyFlow.Finding> findings = flow.findings(scheme, reached);
    FlatRow row = row(findings, across, reached);
    report.putInto(row);
    console.print(output.form(row, text(findings, across, reached, report)));
    if (folder.isPresent()) {
      new ParticleFiles(scheme, flow.spacing()).write(folder.get());
      folder.get().write("sph.json", row.toJson());
    }
    gcReport.write(report.collector());
  }

  /** The steps that end nearest to a time, the first of them as warm-up. */
  private static SphRun runFor(double duration, SphScheme scheme) {
    double steps = Math.max(2, Math.rint(duration / scheme.timeStep()));
    if (steps > MOST_STEPS) {
      throw new UsageException(
          "time must be at most "
              + MOST_STEPS
              + " steps: time="
              + duration
              + ", step="
              + scheme.timeStep());
    }
    long warmUp = Math.min(SphRun.warmUpFor(scheme.particles()), (long) steps / 2);
    return new SphRun(warmUp, (long) steps - warmUp);
  }

  private FlatRow row(List<ReadyFlow.Finding> findings, int across, double reached) {
    FlatRow row =
        new FlatRow().put("case", Choices.word(which)).put("size", across).put("time", reached);
    for (ReadyFlow.Finding each : findings) {
      row.put(each.key(), each.found())
          .put(each.key() + "_known", each.known())
          .put(each.key() + "_error", each.error());
    }
    return row;
  }

  private String text(
      List<ReadyFlow.Finding> findings, int across, double reached, SphReport report) {
    Table table =
        new Table()
            .line("case", Choices.word(which) + ", " + across + " particles across")
            .line(
                "time", (Numbers.significant(reached, DIGITS) + " " + which.unitOfTime()).strip());
    for (ReadyFlow.Finding each : findings) {
      table.line(
          each.name(),
          Numbers.significant(each.found(), DIGITS)
              + (each.known() == 0 ? "" : ", known " + Numbers.significant(each.known(), DIGITS))
              + ", error "
              + Numbers.percent(each.error()));
    }
    report.putInto(table);
    return table.toString();
  }
}
