package org.hdispatch.app.gc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hdispatch.app.Cli;
import org.hdispatch.app.study.Collector;
import org.hdispatch.app.study.GcCase;
import org.hdispatch.app.study.GcFigures;
import org.hdispatch.app.study.GcOrigin;
import org.hdispatch.app.study.GcRow;
import org.hdispatch.app.study.GcRows;
import org.hdispatch.app.study.Jdk;
import org.hdispatch.app.study.RowFiles;
import org.hdispatch.app.study.ScratchPolicy;
import org.hdispatch.app.study.SmallestHeap;
import org.hdispatch.app.study.StudyScope;
import org.hdispatch.app.study.Workload;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(120)
class GcStudyCommandTest {
  private static final Jdk JDK = Jdk.running();
  private static final List<GcCase> QUICK = StudyScope.QUICK.cases(List.of(JDK));
  private static final long SMALLEST = 64L << 20;
  private static final GcOrigin HERE = here();

  @TempDir private Path folder;

  private static GcOrigin here() {
    try {
      return GcRows.here(JDK);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** All but two rows are there already: of those one lives and one dies. */
  @Test
  void goesOnWhereItWasAndTellsWhatDied() throws IOException {
    GcCase lives = quick(Collector.SERIAL, ScratchPolicy.ENDURING);
    GcCase dies = quick(Collector.EPSILON, ScratchPolicy.PER_CELL);
    RowFiles files = new RowFiles(folder);
    files.write(new SmallestHeap(Workload.LBM, 64 << 10, JDK.version(), SMALLEST, HERE.build()));
    for (GcCase each : QUICK) {
      if (!each.equals(lives) && !each.equals(dies)) {
        files.write(GcRows.by(GcRows.row(each, 2.5, 0.25), HERE));
      }
    }
    Cli study =
        Cli.run("gc-study", "--quick", "--jdk", JDK.home(), "--output", folder, "--seconds", 0.1);
    assertEquals(0, study.code(), study.err());
    assertEquals("", study.err());

    Map<GcCase, GcRow> rows =
        files.all().stream().collect(Collectors.toMap(GcRow::of, Function.identity()));
    assertEquals(QUICK.size(), rows.size());
    GcFigures figures = rows.get(lives).figures().orElseThrow();
    assertEquals(2 * SMALLEST, figures.heapBytes());
    assertTrue(figures.peakHeapBytes() > 30_000_000 && figures.peakHeapBytes() < 2 * SMALLEST);
    assertTrue(figures.steps() >= 1 && figures.seconds() >= 0.1, figures::toString);
    assertTrue(figures.workerCpuSeconds() > 0);
    boolean linux = Files.exists(Path.of("/proc/self/task"));
    double collector = figures.collectorCpuSeconds();
    assertTrue(linux ? collector >= 0 : collector == -1, figures::toString);
    assertEquals(HERE, rows.get(lives).origin());
    assertEquals(HERE, rows.get(dies).origin());
    assertEquals(0, figures.collections());
    assertEquals(0, figures.pauses().count());
    assertEquals(0, figures.bytesPerStepInAll());
    assertEquals(figures.steps(), figures.stepTimes().counts().stream().mapToLong(n -> n).sum());
    assertTrue(rows.get(dies).figures().isEmpty());
    assertTrue(rows.get(dies).why().contains("OutOfMemoryError"), rows.get(dies).why());

    assertTrue(study.out().contains("no figures: lbm, 64 KiB, Epsilon"), study.out());
    assertTrue(study.out().lines().count() > QUICK.size() + 2, study.out()); // and a verdict
    String page = Files.readString(folder.resolve("gc-study.html"));
    assertTrue(page.contains("./hdispatch gc-study --quick --jdk"), page);
    assertEquals(QUICK.size() + 1, Files.readAllLines(folder.resolve("gc-study.csv")).size());
    assertTrue(Files.readString(folder.resolve("gc-study.json")).contains("OutOfMemoryError"));

    Files.delete(folder.resolve("gc-study.csv"));
    Cli again = Cli.run("gc-study", "--report-only", folder);
    assertEquals(0, again.code(), again.err());
    assertEquals(study.out(), again.out());
    assertTrue(Files.exists(folder.resolve("gc-study.csv")));
    assertEquals(page, Files.readString(folder.resolve("gc-study.html")));
    Cli nothingLeft =
        Cli.run("gc-study", "--quick", "--jdk", JDK.home(), "--output", folder, "--seconds", 0.1);
    assertEquals(study.out(), nothingLeft.out()); // to the last digit: nothing was run again
  }

  /** Of the second round all rows are there already but one, which another build has made. */
  @Test
  void makesRowsOfAnotherBuildAnewAndSaysSo() throws IOException {
    GcCase of = quick(Collector.SERIAL, ScratchPolicy.ENDURING);
    RowFiles files = new RowFiles(folder);
    files.write(new SmallestHeap(Workload.LBM, 64 << 10, JDK.version(), SMALLEST, HERE.build()));
    for (GcCase each : QUICK) {
      files.write(GcRows.by(GcRows.row(each, 2.5, 0.25), HERE));
      files.write(GcRows.again(GcRows.by(GcRows.row(each, 2.5, 0.25), HERE), 2));
    }
    GcRow foreign = GcRows.by(GcRows.row(of, 2.5, 0.25), GcRows.ORIGIN);
    files.write(GcRows.again(foreign, 2));
    Cli study =
        Cli.run(
            "gc-study",
            "--quick",
            "--forks",
            2,
            "--jdk",
            JDK.home(),
            "--output",
            folder,
            "--seconds",
            0.1);
    assertEquals(0, study.code(), study.err());
    assertEquals(
        "hdispatch: runs in the folder differ from what would be run now, and are made anew: runs=1,"
            + " other=JVM and machine and build",
        study.err().strip());
    List<GcRow> rows = files.all();
    assertEquals(2 * QUICK.size(), rows.size());
    for (GcRow row : rows) {
      boolean again = row.of().equals(of) && row.fork() == 2;
      assertEquals(again ? 2 * SMALLEST : 96L << 20, row.figures().orElseThrow().heapBytes());
      assertEquals(HERE, row.origin());
    }
    assertTrue(study.out().contains("enduring #2"), study.out());
    String csv = Files.readString(folder.resolve("gc-study.csv"));
    assertTrue(csv.lines().findFirst().orElseThrow().endsWith(",build"), csv);
    assertEquals(2 * QUICK.size(), csv.lines().filter(line -> line.endsWith(HERE.build())).count());
  }

  private static GcCase quick(Collector collector, ScratchPolicy policy) {
    return QUICK.stream()
        .filter(run -> run.collector() == collector && run.policy() == policy)
        .filter(run -> run.heapFactor() == (collector == Collector.EPSILON ? 6 : 2))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void refusesWhatCannotBeMeant() {
    Cli.run("gc-study", "--threads", 0)
        .assertRefused(2, "threads must number 1 to 4096: threads=0");
    Cli.run("gc-study", "--forks", 0).assertRefused(2, "forks must number 1 to 100: forks=0");
    Cli.run("gc-study", "--seconds", 0).assertRefused(2, "seconds=0.0");
    Cli.run("gc-study", "--quick", "--full").assertRefused(2, "--quick", "--full");
    Cli.run("gc-study", "--jdk", folder).assertRefused(2, "--jdk must be a home of Java 17");
    Cli.run("gc-study", "--report-only", folder, "--quick")
        .assertRefused(2, "--quick must come without --report-only");
    Cli.run("gc-study", "--report-only", folder).assertRefused(3, "folder must hold runs");
    Cli.run("gc-study", "--report-only", folder.resolve("missing"))
        .assertRefused(3, "folder of a study must exist");
    assertFalse(Files.exists(folder.resolve("missing")));
  }

  @Test
  void rowThatIsDamagedIsNamed() throws IOException {
    RowFiles files = new RowFiles(folder);
    files.write(GcRows.row(QUICK.get(0), 1, 0));
    Path row;
    try (Stream<Path> rows = Files.list(folder.resolve("rows"))) {
      row = rows.findFirst().orElseThrow();
    }
    Files.writeString(row, "{");
    Cli.run("gc-study", "--report-only", folder)
        .assertRefused(3, "file of a study must be readable", row.getFileName().toString());
  }
}
