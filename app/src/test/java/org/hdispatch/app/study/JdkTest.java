package org.hdispatch.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class JdkTest {
  @TempDir private Path folder;

  @Test
  void findsEachVersionOnceOldestFirstAndTheRunningOneAlways() throws IOException {
    Jdk running = new Jdk(folder.resolve("running"), "21.0.2");
    Path newer = jdk("newer", "25.0.3");
    Path same = jdk("same", "21.0.2");
    Path again = jdk("again", "25.0.3");
    Path first = jdk("first", "17");
    assertEquals(
        List.of(new Jdk(first, "17"), running, new Jdk(newer, "25.0.3")),
        Jdk.distinct(running, List.of(newer, same, again, first)));
  }

  @Test
  void passesOverWhatIsNoJavaOrTooOld() throws IOException {
    assertEquals(Optional.empty(), Jdk.at(jdk("old", "11.0.20")));
    assertEquals(Optional.empty(), Jdk.at(jdk("odd", "seventeen")));
    assertEquals(Optional.empty(), Jdk.at(Files.createDirectory(folder.resolve("empty"))));
    Path withoutRelease = jdk("bare", "17");
    Files.delete(withoutRelease.resolve("release"));
    assertEquals(Optional.empty(), Jdk.at(withoutRelease));
  }

  @Test
  void looksWhereSdkmanPutsThem() throws IOException {
    Path home = jdk(".sdkman/candidates/java/99-open", "99.0.1");
    List<Jdk> found = Jdk.found(Map.of(), folder);
    assertTrue(found.contains(new Jdk(home, "99.0.1")), found::toString);
    assertTrue(
        found.stream().anyMatch(jdk -> jdk.version().equals(System.getProperty("java.version"))),
        found::toString);
    Path told = jdk("told", "98");
    assertTrue(
        Jdk.found(Map.of("JAVA_HOME", told.toString()), folder).contains(new Jdk(told, "98")));
  }

  @Test
  void knowsItsFeatureRelease() {
    assertEquals(17, new Jdk(folder, "17.0.15").feature());
    assertEquals(25, new Jdk(folder, "25").feature());
  }

  private Path jdk(String name, String version) throws IOException {
    Path home = folder.resolve(name);
    Files.createDirectories(home.resolve("bin"));
    Files.createFile(home.resolve("bin/java"));
    Files.writeString(
        home.resolve("release"), "IMAGE_TYPE=\"JDK\"\nJAVA_VERSION=\"" + version + "\"\n");
    return home;
  }
}
