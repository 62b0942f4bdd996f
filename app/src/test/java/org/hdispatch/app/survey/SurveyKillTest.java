package org.hdispatch.app.survey;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.hdispatch.app.Forked;
import org.hdispatch.app.RawFile;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A survey that is killed again and again ends with the table of one that never was. */
class SurveyKillTest {
  private static final List<String> JVM =
      List.of("-Xmx128m", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC");

  @TempDir Path folder;

  private String[] command(Path image, String to) {
    return new String[] {
      image.toString(),
      "--dims=32,32,16",
      "--voxel-edge=1e-6",
      "--block=8",
      "--axis=all",
      "--threads=1",
      "--quiet",
      "--output=" + folder.resolve(to)
    };
  }

  /** Kills so many times, each when a random number of bytes more has been written. */
  private void kill(int times, long seed) throws IOException, InterruptedException {
    Random solid = new Random(seed);
    Path image = RawFile.write(folder, 32, 32, 16, (x, y, z) -> solid.nextInt(100) < 70);
    Random random = new Random(seed);
    assertEquals(0, Forked.ended(Forked.survey(JVM, command(image, "whole"))));
    Path table = folder.resolve("whole/survey.csv");
    byte[] whole = Files.readAllBytes(table);
    byte[] json = Files.readAllBytes(folder.resolve("whole/survey.json"));
    Path rows = folder.resolve("killed/survey.csv");
    int killed = 0;
    while (killed < times) {
      long from = Files.exists(rows) ? Files.size(rows) : 0;
      long left = whole.length - from;
      long to = from + (long) (random.nextDouble() * 2 * left / (times - killed + 1));
      Process survey = Forked.survey(JVM, command(image, "killed"));
      while (survey.isAlive() && (!Files.exists(rows) || Files.size(rows) < to)) {
        survey.waitFor(1, TimeUnit.MILLISECONDS);
      }
      survey.waitFor(random.nextInt(30), TimeUnit.MILLISECONDS); // anywhere within a job
      survey.destroyForcibly();
      if (Forked.ended(survey) == 0) {
        Files.delete(rows); // it was done before it could be killed: once more from the start
      } else {
        killed++;
      }
    }
    assertTrue(Files.size(rows) > 0);
    assertEquals(0, Forked.ended(Forked.survey(JVM, command(image, "killed"))));
    assertArrayEquals(whole, Files.readAllBytes(rows));
    assertArrayEquals(json, Files.readAllBytes(folder.resolve("killed/survey.json")));
  }

  @Test
  void killedThreeTimesItEndsWithTheSameTable() throws Exception {
    kill(3, 8);
  }

  @Test
  @Tag("validation")
  void killedTwentyTimesItEndsWithTheSameTable() throws Exception {
    kill(20, 20110607);
  }
}
