package org.hdispatch.app.lattice;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.app.console.OutputOptions;
import org.hdispatch.app.console.StandardOptions;
import org.hdispatch.app.console.StatusLine;
import org.hdispatch.app.console.ThreadOptions;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.watch.CollectorReport;
import org.hdispatch.app.watch.CollectorWatch;
import org.hdispatch.app.watch.GcReportOption;
import org.hdispatch.app.watch.RunListener;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.lbm.duct.BandwidthProbe;
import org.hdispatch.lbm.duct.Duct;
import org.hdispatch.lbm.duct.DuctFigures;
import org.hdispatch.lbm.duct.DuctRun;
import org.hdispatch.porous.io.ImageFileException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code hdispatch duct}: how fast this machine steps a square duct, and with which bundle. */
@Command(
    name = "duct",
    description = {
      "Measure how fast a square duct is stepped, beside the bandwidth of the memory.",
      "Without --size: sweep over bundles and threads (Leonardi et al. 2011, figure 4), find the"
          + " best bundle for this machine, and store it as the default of --bundle."
    })
public final class DuctCommand implements Callable<Integer> {
  private final Host host;

  @Mixin private final DuctOptions options = new DuctOptions();
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
  public DuctCommand(Host host) {
    this.host = host;
  }

  @Override
  public Integer call() throws ImageFileException {
    output.folder();
    threadOptions.threads();
    checkCombinations();
    requireKernel();
    gcReport.check();
    if (output.folder().isEmpty()) {
      measure(Optional.empty());
    } else {
      try (OutputFolder folder = OutputFolder.open(output.folder().get())) {
        measure(Optional.of(folder));
      }
    }
    return ExitCode.DONE.code();
  }

  private void measure(Optional<OutputFolder> folder) throws ImageFileException {
    if (options.isSweep()) {
      sweep(folder);
    } else {
      one(folder);
    }
  }

  /** A bundle, and who said so. */
  private record Choice(BundleShape shape, String origin) {}

  private Choice bundle(int side) {
    if (!options.bundles().isEmpty()) {
      return new Choice(options.bundles().get(0), "given");
    }
    MachineFile machine = machineFile();
    return machine
        .bundle(options.settings(), side)
        .map(shape -> new Choice(shape, "stored in " + machine.path().orElseThrow()))
        .orElse(new Choice(BundleShape.LONG_ROWS, "default"));
  }

  private void one(Optional<OutputFolder> folder) throws ImageFileException {
    BundleShape any = BundleShape.parse("1"); // the size is checked before the file is read
    UsageException.orRefused(() -> options.settings().duct(options.size(), any));
    Choice bundle = bundle(options.size());
    Duct duct =
        UsageException.orRefused(() -> options.settings().duct(options.size(), bundle.shape()));
    DuctRun run = options.run(duct);
    BandwidthProbe probe = new BandwidthProbe(DuctHeap.require(host, duct));
    try (CollectorWatch collector = CollectorWatch.recording()) {
      DuctFigures figures = measure(run, duct, probe, collector);
      var report =
          new CollectorReport(collector.figures(console()), figures.stats(), run.warmUpSteps());
      FlatRow row = DuctReport.row(figures).put("probe_bytes", probe.bytes());
      report.putInto(row.put("bundle_origin", bundle.origin()));
      Host.describe(row);
      console().print(output.form(row, DuctReport.text(figures, bundle.origin(), probe, report)));
      if (folder.isPresent()) {
        folder.get().write("duct.json", row.toJson());
      }
      gcReport.write(report);
    }
  }

  private DuctFigures measure(
      DuctRun run, Duct duct, BandwidthProbe probe, CollectorWatch collector) {
    try (StatusLine status = new StatusLine(console().err());
        Dispatcher dispatcher = Dispatcher.withWorkers(threadOptions.threads())) {
      StatusLine shown = console().isWatched() ? status : null;
      return run.measure(
          dispatcher, duct, probe, new RunListener(collector, shown, "duct " + duct.side() + "^3"));
    }
  }

  private void sweep(Optional<OutputFolder> folder) throws ImageFileException {
    SweepResult result;
    try (StatusLine status = new StatusLine(console().err())) {
      SweepProgress progress = new SweepProgress(status);
      DuctSweep.Listener shown = console().isWatched() ? progress::show : DuctSweep.Listener.NONE;
      result = new DuctSweep(host, options, threadOptions.threads(), console()::warn).run(shown);
    }
    List<FlatRow> rows = SweepReport.rows(result);
    console().print(output.form(rows, SweepReport.text(result, store(result))));
    if (folder.isPresent()) {
      folder.get().write("duct.csv", FlatRow.toCsv(rows));
      folder.get().write("duct.json", FlatRow.toJson(rows));
      folder.get().write("duct.svg", SweepPlot.of(result));
    }
  }

  /** Stores what is recommended, if that is wanted, and says what became of it. */
  private String store(SweepResult result) {
    if (!options.store()) {
      return options.bundles().isEmpty() ? "no (--no-store)" : "no (--bundle was given)";
    }
    return machineFile().keepRecommended(result);
  }

  private MachineFile machineFile() {
    return new MachineFile(host.machineFile(), console()::warn);
  }

  private CommandConsole console() {
    return new CommandConsole(spec, host, output.quiet());
  }

  private void checkCombinations() {
    if (options.isSweep()) {
      refuse("--steady", "--size");
      refuse("--gc-report", "--size");
      return;
    }
    refuse("--sizes", "a sweep, not --size");
    refuse("--rounds", "a sweep, not --size");
    refuse("--no-store", "a sweep, not --size");
    if (options.bundles().size() > 1) {
      throw new UsageException(
          "--bundle must come once with --size: --bundle=" + options.bundles());
    }
  }

  private void refuse(String option, String belongsTo) {
    if (spec.commandLine().getParseResult().hasMatchedOption(option)) {
      throw new UsageException(option + " must come with " + belongsTo);
    }
  }

  /** Refuses a form of the kernel that this Java cannot run, before anything is made. */
  private void requireKernel() {
    try {
      options.settings().duct(1, BundleShape.parse("1")).scheme();
    } catch (IllegalStateException e) {
      throw new UsageException(e.getMessage());
    }
  }
}
