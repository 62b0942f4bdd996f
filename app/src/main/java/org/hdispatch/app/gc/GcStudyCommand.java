package org.hdispatch.app.gc;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.app.console.StandardOptions;
import org.hdispatch.app.console.StatusLine;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.app.study.GcRow;
import org.hdispatch.app.study.GcStudy;
import org.hdispatch.app.study.Jdk;
import org.hdispatch.app.study.RowFiles;
import org.hdispatch.app.study.StudyScope;
import org.hdispatch.app.study.page.GcPage;
import org.hdispatch.app.study.page.GcVerdict;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.porous.io.ImageFileException;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code hdispatch gc-study}: what enduring scratch is worth, on every collector. */
@Command(
    name = "gc-study",
    description = {
      "Compare scratch kept by enduring threads with scratch made for every step or cell, borrowed,"
          + " or thread-local, on every collector of every Java installed: a JVM for each run, a few"
          + " seconds each. Use the machine for nothing else meanwhile.",
      "Runs that are in the folder already are not run again, so a study that was ended goes on"
          + " where it was; unless another build, JVM or machine made them."
    })
public final class GcStudyCommand implements Callable<Integer> {
  private static final String NAME = "gc-study";
  private static final String COMMAND = NAME + ".command";
  private static final int MOST_THREADS = 4096;
  private static final int MOST_FORKS = 100;
  private static final double MOST_SECONDS = 600;
  private static final double QUICK_SECONDS = 0.5;
  private static final double USUAL_SECONDS = 1.6;

  private final Host host;

  @Option(
      names = "--jdk",
      paramLabel = "PATH",
      arity = "1..*",
      description =
          "Homes of the Java installations to study, 17 or newer. Default: the running one, and"
              + " those in JAVA_HOME, /usr/lib/jvm, ~/.sdkman and /Library/Java, each version"
              + " once.")
  private List<Path> homes;

  /** How much is run. */
  static final class Scope {
    @Option(
        names = "--quick",
        description =
            "Less than 3 minutes with two Javas: enduring scratch and scratch made for every cell"
                + " alone.")
    private boolean quick;

    @Option(
        names = "--full",
        description = "Everything: policies, collectors, heaps, sizes, workloads; hours.")
    private boolean full;
  }

  @ArgGroup private Scope scope = new Scope();

  @Option(
      names = "--report-only",
      paramLabel = "DIR",
      description = "Run nothing, but report what is in this folder. Default: none.")
  private Path reported;

  @Option(
      names = "--output",
      paramLabel = "DIR",
      defaultValue = NAME,
      description = "Folder for the runs and the report, made if missing.")
  private Path output;

  @Option(
      names = "--threads",
      paramLabel = "N",
      defaultValue = "2",
      description = "Threads that step (1 to 4096).")
  private int threads;

  @Option(
      names = "--forks",
      paramLabel = "N",
      defaultValue = "1",
      description =
          "How often each case is run (1 to 100), in rounds over all cases. What is said is medians"
              + " and the spread.")
  private int forks;

  @Option(
      names = "--seconds",
      paramLabel = "S",
      description = "Length of each measurement, after warm-up. Default: 1.6, with --quick 0.5.")
  private Double seconds;

  @Option(names = "--quiet", description = "No progress on standard error.")
  private boolean quiet;

  @Mixin private final StandardOptions standard = new StandardOptions();
  @Spec private CommandSpec spec;

  /**
   * Makes the command.
   *
   * @param host what it runs in
   */
  public GcStudyCommand(Host host) {
    this.host = host;
  }

  @Override
  public Integer call() throws ImageFileException {
    check();
    if (reported != null) {
      if (!Files.isDirectory(reported)) {
        throw new ImageFileException("folder of a study must exist: folder=" + reported);
      }
      try (OutputFolder folder = OutputFolder.open(reported)) {
        report(reported, folder, commandOf(reported));
      }
      return ExitCode.DONE.code();
    }
    List<Jdk> jdks = jdks();
    try (OutputFolder folder = OutputFolder.open(output)) {
      List<String> given = spec.root().commandLine().getParseResult().originalArgs();
      String command = "./hdispatch " + String.join(" ", given);
      folder.write(COMMAND, command + "\n");
      run(jdks);
      report(output, folder, command);
    }
    return ExitCode.DONE.code();
  }

  /** What the runs in a folder were asked for with. */
  private static String commandOf(Path folder) throws ImageFileException {
    Path file = folder.resolve(COMMAND);
    try {
      return Files.exists(file) ? Files.readString(file).strip() : "./hdispatch " + NAME;
    } catch (IOException e) {
      throw new ImageFileException("file of a study must be readable: file=" + file, e);
    }
  }

  private void check() {
    if (threads < 1 || threads > MOST_THREADS) {
      throw new UsageException("threads must number 1 to " + MOST_THREADS + ": threads=" + threads);
    }
    if (forks < 1 || forks > MOST_FORKS) {
      throw new UsageException("forks must number 1 to " + MOST_FORKS + ": forks=" + forks);
    }
    if (seconds != null && !(seconds > 0 && seconds <= MOST_SECONDS)) {
      throw new UsageException(
          "seconds must lie between 0 and " + MOST_SECONDS + ": seconds=" + seconds);
    }
    if (output.toString().isEmpty()) {
      throw new UsageException("--output must name a folder: --output=");
    }
    if (reported != null) {
      for (String each :
          List.of("--jdk", "--quick", "--full", "--forks", "--output", "--threads", "--seconds")) {
        if (spec.commandLine().getParseResult().hasMatchedOption(each)) {
          throw new UsageException(each + " must come without --report-only");
        }
      }
    }
  }

  private List<Jdk> jdks() {
    if (homes == null) {
      return Jdk.found(System.getenv(), Path.of(System.getProperty("user.home")));
    }
    Map<String, Jdk> byVersion = new LinkedHashMap<>();
    for (Path home : homes) {
      Jdk jdk =
          Jdk.at(home)
              .orElseThrow(
                  () -> new UsageException("--jdk must be a home of Java 17 or newer: " + home));
      byVersion.putIfAbsent(jdk.version(), jdk);
    }
    return new ArrayList<>(byVersion.values());
  }

  private void run(List<Jdk> jdks) throws ImageFileException {
    StudyScope which =
        scope.quick ? StudyScope.QUICK : scope.full ? StudyScope.FULL : StudyScope.USUAL;
    double length = seconds != null ? seconds : scope.quick ? QUICK_SECONDS : USUAL_SECONDS;
    long begin = System.nanoTime();
    try (StatusLine status = new StatusLine(console().err())) {
      GcStudy study = new GcStudy(jdks, which, forks, threads, length, output);
      tell(study.foreign());
      study.run(
          (what, number, of) -> {
            if (console().isWatched()) {
              status.show("run " + number + " of " + of + left(begin, number, of) + what);
            }
          });
    } catch (IOException e) {
      throw new ImageFileException(e.getMessage(), e);
    }
  }

  /** That runs which are there cannot be used. */
  private void tell(List<List<String>> foreign) {
    if (!foreign.isEmpty()) {
      console()
          .err()
          .println(
              "hdispatch: runs in the folder differ from what would be run now, and are made anew:"
                  + " runs="
                  + foreign.size()
                  + ", other="
                  + foreign.stream()
                      .flatMap(List::stream)
                      .distinct()
                      .collect(Collectors.joining(" and ")));
    }
  }

  private static String left(long begin, int number, int of) {
    if (number == 1) {
      return "  ";
    }
    double each = 1e-9 * (System.nanoTime() - begin) / (number - 1);
    long left = Math.round(each * (of - number + 1));
    return String.format("  %d:%02d left  ", left / 60, left % 60);
  }

  private void report(Path from, OutputFolder folder, String command) throws ImageFileException {
    List<GcRow> rows;
    String json;
    try {
      rows = new RowFiles(from).all();
      json = RowFiles.json(rows);
    } catch (IOException e) {
      throw new ImageFileException(e.getMessage(), e);
    }
    if (rows.isEmpty()) {
      throw new ImageFileException("folder must hold runs of a study: folder=" + from);
    }
    List<String> files = List.of(NAME + ".csv", NAME + ".json");
    folder.write(files.get(0), FlatRow.toCsv(GcStudyTable.rows(rows)));
    folder.write(files.get(1), json);
    folder.write(NAME + ".html", GcPage.html(rows, command, files));
    console().out().println(GcStudyTable.text(rows));
    GcVerdict.sentences(rows).forEach(console().out()::println);
    console().print(""); // which looks whether all could be printed
  }

  private CommandConsole console() {
    return new CommandConsole(spec, host, quiet);
  }
}
