package org.hdispatch.app.study;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A Java installation of version 17 or newer.
 *
 * @param home its folder
 * @param version such as {@code 17.0.15}
 */
public record Jdk(Path home, String version) {
  private static final int OLDEST = 17;
  private static final String UNKNOWN = "unknown";
  private static final String RELEASE = "release"; // a file of keys and values

  /** The one that this program runs on. */
  public static Jdk running() {
    return new Jdk(Path.of(System.getProperty("java.home")), System.getProperty("java.version"));
  }

  /**
   * The one in a folder.
   *
   * @return empty if there is none, or one older than 17
   */
  public static Optional<Jdk> at(Path home) {
    if (!Files.exists(home.resolve("bin/java")) && !Files.exists(home.resolve("bin/java.exe"))) {
      return Optional.empty();
    }
    try {
      return released(home, "JAVA_VERSION")
          .map(version -> new Jdk(home, version))
          .filter(jdk -> jdk.feature() >= OLDEST);
    } catch (IllegalArgumentException e) { // no version
      return Optional.empty();
    }
  }

  /** What the file of a release says of itself. */
  private static Optional<String> released(Path home, String key) {
    try {
      Matcher line =
          Pattern.compile("(?m)^" + key + "=\"([^\"]+)\"")
              .matcher(Files.readString(home.resolve(RELEASE)));
      return line.find() ? Optional.of(line.group(1)) : Optional.empty();
    } catch (IOException e) { // no file of that name
      return Optional.empty();
    }
  }

  /**
   * The running one and those in the usual places, each version once, the oldest first.
   *
   * @param environment where {@code JAVA_HOME} may stand
   * @param userHome folder of the user
   */
  public static List<Jdk> found(Map<String, String> environment, Path userHome) {
    List<Path> homes = new ArrayList<>();
    String told = environment.get("JAVA_HOME");
    if (told != null && !told.isBlank()) {
      homes.add(Path.of(told));
    }
    homes.addAll(foldersIn(Path.of("/usr/lib/jvm")));
    homes.addAll(foldersIn(userHome.resolve(".sdkman/candidates/java")));
    foldersIn(Path.of("/Library/Java/JavaVirtualMachines"))
        .forEach(folder -> homes.add(folder.resolve("Contents/Home")));
    return distinct(running(), homes);
  }

  /** One of each version, and the first of these always. */
  static List<Jdk> distinct(Jdk first, Collection<Path> homes) {
    Map<String, Jdk> byVersion = new LinkedHashMap<>();
    byVersion.put(first.version, first);
    for (Path home : homes) {
      at(home).ifPresent(jdk -> byVersion.putIfAbsent(jdk.version, jdk));
    }
    List<Jdk> all = new ArrayList<>(byVersion.values());
    all.sort(Comparator.comparing(jdk -> Runtime.Version.parse(jdk.version)));
    return all;
  }

  private static List<Path> foldersIn(Path place) {
    List<Path> folders = new ArrayList<>();
    if (Files.isDirectory(place)) {
      try (DirectoryStream<Path> entries = Files.newDirectoryStream(place, Files::isDirectory)) {
        entries.forEach(folders::add);
      } catch (IOException e) {
        return List.of(); // not ours to read: nothing is found there
      }
    }
    folders.sort(Comparator.naturalOrder());
    return folders;
  }

  /** Feature release, such as 17. */
  public int feature() {
    return Runtime.Version.parse(version).feature();
  }

  /** Who made it. */
  String vendor() {
    return released(home, "IMPLEMENTOR").orElse(UNKNOWN);
  }

  /** Its version in full, such as {@code 17.0.15+6-Debian-1deb12u1}. */
  String runtime() {
    return released(home, "JAVA_RUNTIME_VERSION").orElse(version);
  }

  /** Its launcher. */
  Path java() {
    return home.resolve("bin").resolve("java");
  }
}
