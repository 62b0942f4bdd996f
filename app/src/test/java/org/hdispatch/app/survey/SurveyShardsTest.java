package org.hdispatch.app.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.hdispatch.app.Cli;
import org.hdispatch.app.Forked;
import org.hdispatch.app.RawFile;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.porous.block.BlockColumns;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.io.CsvLine;
import org.hdispatch.porous.survey.Shard;
import org.hdispatch.porous.survey.SurveyFiles;
import org.hdispatch.porous.survey.SurveyJob;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveySettings;
import org.hdispatch.porous.survey.SurveyStatus;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Shards of a survey in processes of their own, side by side. */
class SurveyShardsTest {
  private static final List<String> JVM =
      List.of("-Xmx64m", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC");

  @TempDir Path folder;

  private Path image() {
    Random solid = new Random(4);
    return RawFile.write(folder, 32, 32, 16, (x, y, z) -> solid.nextInt(100) < 70);
  }

  private String[] command(Path image, String to, String... more) {
    List<String> all =
        new ArrayList<>(
            List.of(
                image.toString(),
                "--dims=32,32,16",
                "--voxel-edge=1e-6",
                "--block=8",
                "--axis=all",
                "--threads=1",
                "--quiet",
                "--output=" + folder.resolve(to)));
    all.addAll(List.of(more));
    return all.toArray(new String[0]);
  }

  private int rows(String file) throws IOException {
    Path table = folder.resolve("shards").resolve(file);
    return Files.exists(table) ? Files.readAllLines(table).size() - 1 : 0;
  }

  @Test
  void fourSideBySideOneOfThemKilledGiveTheTableOfASingleProcess() throws Exception {
    Path image = image();
    assertEquals(0, Forked.ended(Forked.survey(JVM, command(image, "one"))));
    List<Process> shards = new ArrayList<>();
    for (int number = 1; number <= 4; number++) {
      shards.add(Forked.survey(JVM, command(image, "shards", "--shard=" + number + "/4")));
    }
    Process victim = shards.get(2);
    while (rows("survey-3-of-4.csv") < 2 && victim.isAlive()) {
      victim.waitFor(1, TimeUnit.MILLISECONDS);
    }
    victim.destroyForcibly();
    assertTrue(Forked.ended(victim) != 0, "it was to be killed before its end");
    for (Process each : shards) {
      if (each != victim) {
        assertEquals(0, Forked.ended(each));
      }
    }
    Path together = folder.resolve("shards");
    Cli some = Cli.run("survey", "--collect=" + together, "--quiet");
    assertEquals(3, some.code(), some.err());
    assertTrue(some.err().contains("rows of all jobs must be there"), some.err());
    assertEquals(0, Forked.ended(Forked.survey(JVM, command(image, "shards", "--shard=3/4"))));
    assertEquals(24, rows("survey-3-of-4.csv")); // 8 of 32 blocks, along three axes
    Cli all = Cli.run("survey", "--collect=" + together, "--quiet");
    assertEquals(0, all.code(), all.err());
    for (String file : List.of("survey.csv", "survey.json", "survey.properties")) {
      assertEquals(
          Files.readString(folder.resolve("one").resolve(file)),
          Files.readString(together.resolve(file)));
    }
  }

  /** A lock is lost with the first of a process's channels that is closed; it must not be. */
  @Test
  void whoIsRefusedInThisProcessDoesNotLetOthersIn() throws Exception {
    Path image = image();
    assertEquals(0, Forked.ended(Forked.survey(JVM, command(image, "held", "--blocks=0"))));
    Map<String, String> values = new LinkedHashMap<>();
    for (String line : Files.readAllLines(folder.resolve("held/survey.properties"))) {
      if (!line.startsWith("#")) {
        values.put(line.substring(0, line.indexOf('=')), line.substring(line.indexOf('=') + 1));
      }
    }
    try (SurveyFiles held =
        SurveyFiles.open(
            folder.resolve("held"),
            Shard.WHOLE,
            new SurveySettings(values),
            BlockColumns.FIGURES,
            BlockColumns.TIMES)) {
      List<Object> here = new ArrayList<>(List.of("survey"));
      here.addAll(List.of(command(image, "held", "--blocks=0")));
      Cli.run(here.toArray()).assertRefused(3, "rows must be written by one process at a time");
      SurveyFiles.open( // reads the settings of the whole, which are held
              folder.resolve("held"),
              new Shard(1, 2),
              held.settings(),
              BlockColumns.FIGURES,
              BlockColumns.TIMES)
          .close();
      assertEquals(3, Forked.ended(Forked.survey(JVM, command(image, "held", "--blocks=0"))));
    }
    assertEquals(0, Forked.ended(Forked.survey(JVM, command(image, "held", "--blocks=0"))));
  }

  /** Twenty thousand rows, 12 MB as lines, in a JVM of 64 MiB. */
  @Test
  void rowsAreCollectedInTheHeapOfTheirLines() throws Exception {
    int jobs = 20_000;
    Path many = Files.createDirectory(folder.resolve("many"));
    Map<String, String> values = Map.of(SurveySettings.JOBS, Integer.toString(jobs));
    SurveyFiles.open(
            many,
            new Shard(1, 2),
            new SurveySettings(values),
            BlockColumns.FIGURES,
            BlockColumns.TIMES)
        .close();
    Map<String, String> figures = new LinkedHashMap<>();
    BlockColumns.FIGURES.forEach(column -> figures.put(column, "0.1234567890"));
    List<String> columns = SurveyRow.columns(BlockColumns.FIGURES);
    try (BufferedWriter rows = Files.newBufferedWriter(many.resolve("survey-1-of-2.csv"))) {
      rows.write(CsvLine.format(columns) + "\n");
      for (int job = 0; job < jobs; job++) {
        SurveyJob each = new SurveyJob(job, job, new VoxelBox(job, 0, 0, 1, 1, 1), Axis.Z);
        SurveyRow row = new SurveyRow(each, SurveyStatus.DONE, "", figures);
        rows.write(CsvLine.format(row.format(columns)) + "\n");
      }
    }
    List<String> small = List.of("-Xmx64m", "-XX:+UseSerialGC");
    assertEquals(0, Forked.ended(Forked.survey(small, "--collect=" + many, "--json")));
    try (Stream<String> lines = Files.lines(many.resolve("survey.json"))) {
      assertEquals(jobs, lines.filter(line -> line.contains("\"job\": ")).count());
    }
  }

  @Test
  void aShardThatIsRefusedLeavesTheFolderToOthers() throws IOException {
    Path shared = folder.resolve("a/b");
    try (OutputFolder failing = OutputFolder.openShared(shared)) {
      assertEquals(shared, failing.path());
    }
    assertTrue(Files.isDirectory(shared));
  }
}
