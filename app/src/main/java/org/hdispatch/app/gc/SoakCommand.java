package org.hdispatch.app.gc;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.app.console.OutputOptions;
import org.hdispatch.app.console.StandardOptions;
import org.hdispatch.app.console.StatusLine;
import org.hdispatch.app.console.ThreadOptions;
import org.hdispatch.app.console.Version;
import org.hdispatch.app.study.ChildJvm;
import org.hdispatch.app.study.Collector;
import org.hdispatch.app.study.Jdk;
import org.hdispatch.app.study.Soak;
import org.hdispatch.app.study.SoakJob;
import org.hdispatch.app.study.SoakResult;
import org.hdispatch.app.study.SoakResult.Verdict;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.porous.io.ImageFileException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code hdispatch soak}: the proof that long runs leave nothing to the garbage collector. */
@Command(
    name = "soak",
    description = {
      "Prove that stepping leaves nothing to the garbage collector: 10^6 steps of lattice Boltzmann"
          + " (a duct of 16^3 nodes) and 10^5 of smoothed particle hydrodynamics (1000 particles"
          + " in a shear flow that is driven, in a periodic box), plain kernels, in a JVM of their"
          + " own for each collector.",
      "A run passes with 0 collections, 0 stops of all threads by the collector, 0 stalls, and not"
          + " a byte allocated in most of the hundred equal parts of the run, all after warm-up."
          + " Not in all parts: the JVM itself may allocate some hundred bytes on a stepping thread"
          + " once, when it replaces compiled code, and a cell of particles grows when it holds"
          + " more than ever before, more and more seldom. All these bytes are told, exactly.",
      "Epsilon never reclaims anything: it must do with 16 MB beside what is in use after the"
          + " set-up, warm-up included. That is measured by a JVM before, and holds what the start"
          + " of the JVM and the set-up have left behind, which is more than the live set. The"
          + " others get 128 MB; what ZGC and Shenandoah would collect by the clock, every five"
          + " minutes, is switched off.",
      "Bytes are counted by thread, collections by the management beans, safepoints and stalls by"
          + " the JVM's log; Flight Recorder is off, for it allocates. A collector that a JDK does"
          + " not have is left out, or fails if it was asked for by --collectors."
    })
public final class SoakCommand implements Callable<Integer> {
  private static final int WORD = 10;
  private static final int MEBIBYTE = 1 << 20;

  private final Host host;

  @Mixin private final SoakOptions options = new SoakOptions();
  @Mixin private final ThreadOptions threadOptions = new ThreadOptions();
  @Mixin private final OutputOptions output = new OutputOptions();
  @Mixin private final StandardOptions standard = new StandardOptions();
  @Spec private CommandSpec spec;

  /**
   * Makes the command.
   *
   * @param host what it runs in
   */
  public SoakCommand(Host host) {
    this.host = host;
  }

  @Override
  public Integer call() throws ImageFileException {
    Optional<Path> folder = output.folder();
    List<SoakJob> jobs = options.jobs(threadOptions.threads());
    List<Jdk> jdks = options.jdks();
    List<SoakResult> results = new ArrayList<>();
    if (folder.isEmpty()) {
      results.addAll(soak(jdks, jobs));
    } else {
      try (OutputFolder files = OutputFolder.open(folder.get())) {
        results.addAll(soak(jdks, jobs));
        List<FlatRow> rows = results.stream().map(SoakCommand::row).toList();
        files.write("soak.json", FlatRow.toJson(rows));
        files.write("soak.csv", FlatRow.toCsv(rows));
      }
    }
    if (!printsLines()) {
      console().print(output.form(results.stream().map(SoakCommand::row).toList(), ""));
    }
    boolean passed =
        results.stream().allMatch(this::isGood)
            && results.stream().anyMatch(result -> result.verdict() == Verdict.PASSED);
    if (!passed) {
      console().err().println("hdispatch: soak must leave nothing to the collector: see above");
    }
    return (passed ? ExitCode.DONE : ExitCode.NOT_CONVERGED).code();
  }

  /** Left out is good enough where nobody asked for it. */
  private boolean isGood(SoakResult result) {
    return result.verdict() == Verdict.PASSED
        || result.verdict() == Verdict.LEFT_OUT && !options.namesCollectors();
  }

  private boolean printsLines() {
    return output.form(new FlatRow(), "text").equals("text");
  }

  private CommandConsole console() {
    return new CommandConsole(spec, host, output.quiet());
  }

  private List<SoakResult> soak(List<Jdk> jdks, List<SoakJob> jobs) throws ImageFileException {
    List<SoakResult> results = new ArrayList<>();
    try {
      Path folder = Files.createTempDirectory("hdispatch-soak");
      try (StatusLine status = new StatusLine(console().err())) {
        for (Jdk jdk : jdks) {
          for (SoakJob job : jobs) {
            soak(new ChildJvm(jdk, folder), job, status, results);
          }
        }
      } finally {
        remove(folder);
      }
    } catch (IOException e) {
      throw new ImageFileException("soak must run: cause=" + e.getMessage(), e);
    }
    return results;
  }

  private void soak(ChildJvm jvm, SoakJob job, StatusLine status, List<SoakResult> results)
      throws IOException, ImageFileException {
    Soak soak = Soak.of(jvm, job);
    for (Collector collector : options.collectors()) {
      if (console().isWatched()) {
        status.show(Choices.word(job.workload()) + "  " + collector.title() + "  ...");
      }
      SoakResult result = soak.run(collector);
      status.close();
      results.add(result);
      if (printsLines()) {
        console().print(line(result) + System.lineSeparator());
      }
    }
  }

  private static void remove(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path each : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(each);
      }
    }
  }

  private static String line(SoakResult result) {
    StringBuilder line = new StringBuilder();
    line.append(
        String.format(
            Locale.ROOT,
            "%-4s Java %-" + WORD + "s %-16s %d steps, live %.1f MiB, heap %d MiB",
            Choices.word(result.job().workload()),
            result.java(),
            result.collector().title(),
            result.job().steps(),
            (double) result.liveBytes() / MEBIBYTE,
            result.heapBytes() / MEBIBYTE));
    result
        .figures()
        .ifPresent(
            f ->
                line.append(
                    String.format(
                        Locale.ROOT,
                        ", %.1f s, %s bytes (none in %d %% of the run), %d collections, %d safepoints of the collector (%d in"
                            + " all), %d stalls, %s",
                        f.seconds(),
                        f.bytes() < 0 ? "unknown" : Long.toString(f.bytes()),
                        f.partsWithoutBytes(),
                        f.collections(),
                        f.collectorSafepoints(),
                        f.safepoints(),
                        f.stalls(),
                        f.result())));
    line.append(": ").append(Choices.word(result.verdict()).replace('-', ' '));
    return result.why().isEmpty() ? line.toString() : line + " (" + result.why() + ")";
  }

  private static FlatRow row(SoakResult result) {
    Optional<SoakResult.Figures> figures = result.figures();
    FlatRow row =
        new FlatRow()
            .put("method", Choices.word(result.job().workload()))
            .put("java", result.java())
            .put("collector", result.collector().title())
            .put("verdict", Choices.word(result.verdict()))
            .put("why", result.why())
            .put("steps", result.job().steps())
            .put("warm_up_steps", result.job().warmUpSteps())
            .put("threads", result.job().threads())
            .put("scratch", Choices.word(result.job().lifetime()))
            .put("live_bytes", result.liveBytes())
            .put("heap_bytes", result.heapBytes())
            .put("seconds", figures.map(SoakResult.Figures::seconds).orElse(null))
            .put("bytes", figures.map(SoakResult.Figures::bytes).filter(b -> b >= 0).orElse(null))
            .put(
                "percent_without_bytes",
                figures.map(SoakResult.Figures::partsWithoutBytes).orElse(null))
            .put("collections", figures.map(SoakResult.Figures::collections).orElse(null))
            .put(
                "collector_safepoints",
                figures.map(SoakResult.Figures::collectorSafepoints).orElse(null))
            .put("safepoints", figures.map(SoakResult.Figures::safepoints).orElse(null))
            .put("stalls", figures.map(SoakResult.Figures::stalls).orElse(null))
            .put("result", figures.map(SoakResult.Figures::result).orElse(null));
    return row.put("processors", Runtime.getRuntime().availableProcessors())
        .put("architecture", System.getProperty("os.arch"))
        .put("version", Version.ofProject());
  }
}
