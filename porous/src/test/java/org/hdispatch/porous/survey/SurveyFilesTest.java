package org.hdispatch.porous.survey;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.io.ImageFileException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SurveyFilesTest {
  private static final int JOBS = 5;
  private static final List<String> FIGURES = List.of("porosity", "note");
  private static final List<String> TIMES = List.of("job", "seconds");

  @TempDir Path folder;

  private static SurveySettings settings(String tolerance) {
    Map<String, String> values = new LinkedHashMap<>();
    values.put("tolerance", tolerance);
    values.put(SurveySettings.JOBS, Integer.toString(JOBS));
    return new SurveySettings(values);
  }

  private static SurveyRow row(int job, SurveyStatus status) {
    return new SurveyRow(
        new SurveyJob(job, job, new VoxelBox(job, 0, 2, 3, 4, 5), Axis.Y),
        status,
        status == SurveyStatus.FAILED ? "it must \"work\",\n or not" : "",
        Map.of("porosity", Double.toString(1.0 / (3 + job)), "note", "a, b"));
  }

  private SurveyFiles open(Shard shard) throws ImageFileException {
    return SurveyFiles.open(folder, shard, settings("0.1"), FIGURES, TIMES);
  }

  /** Does the jobs that are not done, in an order of no sense. */
  private void goOn(Shard shard) throws ImageFileException {
    try (SurveyFiles files = open(shard)) {
      for (int job : new int[] {3, 0, 4, 1, 2}) {
        if (shard.has(job) && !files.isDone(job)) {
          files.append(row(job, SurveyStatus.DONE), List.of(Integer.toString(job), "0.25"));
        }
      }
      files.sort();
      assertEquals(shard == Shard.WHOLE, files.missing().isEmpty());
    }
  }

  private static List<SurveyRow> rows(SurveyFiles files) throws ImageFileException {
    List<SurveyRow> rows = new ArrayList<>();
    files.forEachRow(rows::add);
    return rows;
  }

  private byte[] table(String name) throws IOException {
    return Files.readAllBytes(folder.resolve(name));
  }

  @Test
  void rowsComeBackAsTheyWere() throws ImageFileException {
    try (SurveyFiles files = open(Shard.WHOLE)) {
      files.append(row(1, SurveyStatus.FAILED), List.of("1", "2"));
      files.append(row(0, SurveyStatus.OUTSIDE), List.of("0", "2"));
    }
    try (SurveyFiles files = open(Shard.WHOLE)) {
      List<SurveyRow> rows = rows(files);
      assertEquals(List.of(row(0, SurveyStatus.OUTSIDE), row(1, SurveyStatus.FAILED)), rows);
      assertEquals("it must \"work\", or not", rows.get(1).cause());
      assertEquals(1.0 / 3, rows.get(0).number("porosity").getAsDouble());
      assertEquals(List.of(2, 3, 4), files.missing());
      assertTrue(files.isDone(0));
      assertFalse(files.isDone(1));
    }
  }

  /** Wherever a killed process left off in writing, the next one ends with the same table. */
  @Test
  void tableEndsTheSameWhereverItWasCutOff() throws IOException {
    goOn(Shard.WHOLE);
    byte[] whole = table("survey.csv");
    byte[] times = table("survey-times.csv");
    List<String> allTimes = new String(times).lines().toList();
    assertEquals(1 + JOBS, allTimes.size());
    assertEquals(1 + JOBS, new String(whole).lines().count());
    for (int length = 0; length <= whole.length; length++) {
      Files.write(folder.resolve("survey.csv"), Arrays.copyOf(whole, length));
      Files.write(folder.resolve("survey-times.csv"), Arrays.copyOf(times, length % times.length));
      goOn(Shard.WHOLE);
      assertArrayEquals(whole, table("survey.csv"));
      // Of a job whose row was kept, the time may be lost; no line is torn or there twice.
      List<String> left = Files.readAllLines(folder.resolve("survey-times.csv"));
      assertEquals(allTimes.stream().filter(left::contains).toList(), left);
    }
  }

  @Test
  void settingsThatWereNotWrittenToTheirEndAreWrittenAnew() throws IOException {
    open(Shard.WHOLE).close();
    byte[] whole = table("survey.properties");
    for (int length = 0; length < whole.length; length++) {
      Files.write(folder.resolve("survey.properties"), Arrays.copyOf(whole, length));
      open(Shard.WHOLE).close();
      assertArrayEquals(whole, table("survey.properties"));
    }
  }

  @Test
  void rowsWithoutTheirSettingsAreRefused() throws IOException {
    goOn(Shard.WHOLE);
    byte[] whole = table("survey.properties");
    Files.delete(folder.resolve("survey.properties"));
    for (int time = 0; time < 2; time++) { // the first refusal must not make them known
      Throwable refused = assertThrows(ImageFileException.class, () -> open(Shard.WHOLE));
      assertEquals(
          "rows must have their settings beside them: file=" + folder.resolve("survey.csv"),
          refused.getMessage());
    }
    open(Shard.parse("1/2")).close();
    Files.write(folder.resolve("survey.properties"), whole);
    goOn(Shard.WHOLE);
  }

  @Test
  void otherSettingsAreRefusedByName() throws IOException {
    open(Shard.parse("1/2")).close();
    for (Shard shard : List.of(Shard.parse("1/2"), Shard.parse("2/2"), Shard.WHOLE)) {
      Throwable refused =
          assertThrows(
              IllegalArgumentException.class,
              () -> SurveyFiles.open(folder, shard, settings("0.2"), FIGURES, TIMES));
      assertTrue(refused.getMessage().contains(" tolerance=0.2, there=0.1, file="));
    }
    open(Shard.parse("1/2")).close();
  }

  @Test
  void checksumOfBlocksIsComparedIfBothKnowIt() throws IOException {
    open(Shard.parse("1/3")).close();
    Map<String, String> values = new LinkedHashMap<>(settings("0.1").values());
    values.put(SurveySettings.BLOCKS_CRC, "a1");
    SurveyFiles.open(folder, Shard.parse("2/3"), new SurveySettings(values), FIGURES, TIMES)
        .close();
    open(Shard.parse("2/3")).close();
    values.put(SurveySettings.BLOCKS_CRC, "a2");
    Throwable refused =
        assertThrows(
            IllegalArgumentException.class,
            () ->
                SurveyFiles.open(
                    folder, Shard.parse("3/3"), new SurveySettings(values), FIGURES, TIMES));
    assertTrue(refused.getMessage().contains("blocks_crc=a2, there=a1"), refused.getMessage());
  }

  @Test
  void secondWriterIsRefusedUntilTheFirstIsDone() throws IOException {
    try (SurveyFiles first = open(Shard.WHOLE)) {
      assertEquals(JOBS, first.missing().size());
      Throwable refused = assertThrows(ImageFileException.class, () -> open(Shard.WHOLE));
      assertTrue(refused.getMessage().startsWith("rows must be written by one process at a time"));
      open(Shard.parse("1/2")).close();
    }
    open(Shard.WHOLE).close();
  }

  @Test
  void shardsJoinToTheTableOfASingleProcess() throws IOException {
    goOn(Shard.WHOLE);
    byte[] whole = table("survey.csv");
    byte[] times = table("survey-times.csv");
    Files.delete(folder.resolve("survey.csv"));
    Files.delete(folder.resolve("survey-times.csv"));
    goOn(Shard.parse("3/3"));
    goOn(Shard.parse("1/3"));
    try (SurveyFiles joined = SurveyFiles.collect(folder, FIGURES, TIMES)) {
      assertEquals(List.of(1, 4), joined.missing());
    }
    goOn(Shard.parse("2/3"));
    SurveyFiles.collect(folder, FIGURES, TIMES).close();
    assertArrayEquals(whole, table("survey.csv"));
    assertArrayEquals(times, table("survey-times.csv"));
  }

  @Test
  void aJobThatFailedIsDoneAgainAndThenCounts() throws IOException {
    try (SurveyFiles files = open(Shard.parse("1/2"))) {
      files.append(row(0, SurveyStatus.FAILED), List.of("0", "1"));
    }
    SurveyFiles.collect(folder, FIGURES, TIMES).close();
    goOn(Shard.parse("1/2"));
    try (SurveyFiles joined = SurveyFiles.collect(folder, FIGURES, TIMES)) {
      assertEquals(SurveyStatus.DONE, rows(joined).get(0).status());
      assertEquals(List.of(1, 3), joined.missing());
    }
  }

  @Test
  void shardsMustAgree() throws IOException {
    assertThrows(ImageFileException.class, () -> SurveyFiles.collect(folder, FIGURES, TIMES));
    goOn(Shard.parse("1/2"));
    goOn(Shard.parse("1/3"));
    SurveyFiles.collect(folder, FIGURES, TIMES).close();
    Path table = folder.resolve("survey-1-of-3.csv");
    String rows = Files.readString(table);
    Files.writeString(table, rows.replace("0.3333", "0.3334"));
    Throwable refused =
        assertThrows(ImageFileException.class, () -> SurveyFiles.collect(folder, FIGURES, TIMES));
    assertTrue(refused.getMessage().startsWith("rows of one job must be the same: job=0"));
    Files.writeString(table, rows);
    Path settings = folder.resolve("survey-1-of-3.properties");
    Files.writeString(settings, Files.readString(settings).replace("0.1", "0.2"));
    refused =
        assertThrows(ImageFileException.class, () -> SurveyFiles.collect(folder, FIGURES, TIMES));
    assertTrue(refused.getMessage().contains("tolerance=0.1, there=0.2"), refused.getMessage());
  }

  @Test
  void linesThatAreNoRowsAreRefused() throws IOException {
    goOn(Shard.WHOLE);
    Path table = folder.resolve("survey.csv");
    String rows = Files.readString(table);
    for (String wrong :
        List.of(
            rows.replaceFirst("\n1,", "\nx,"),
            rows.replaceFirst("\n2,2", "\n2"),
            rows.replaceFirst("done", "undone"),
            rows.replaceFirst("note", "other"),
            rows.replaceFirst("\"", ""))) {
      Files.writeString(table, wrong);
      Throwable refused = assertThrows(ImageFileException.class, () -> open(Shard.WHOLE));
      assertTrue(refused.getMessage().contains("file=" + table), refused.getMessage());
    }
    Files.writeString(table, rows);
    open(Shard.WHOLE).close(); // none of them left the folder held
  }
}
