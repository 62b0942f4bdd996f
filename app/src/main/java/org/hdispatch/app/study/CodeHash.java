package org.hdispatch.app.study;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import java.util.stream.Stream;

/**
 * A hash of the code on a class path: the files of its folders and jars, and of the jars that those
 * name in their manifests. Where the files lie does not count.
 */
final class CodeHash {
  private static final int DIGITS = 12; // 48 bits: enough to tell builds apart

  private CodeHash() {}

  /**
   * The hash.
   *
   * @param classPath folders and jars in the form of {@code -cp}; what does not exist is passed
   *     over
   * @return twelve hexadecimal digits
   * @throws IOException if a file cannot be read
   */
  static String of(String classPath) throws IOException {
    Set<Path> entries = new LinkedHashSet<>();
    for (String each : classPath.split(File.pathSeparator)) {
      add(Path.of(each).toAbsolutePath().normalize(), entries);
    }
    MessageDigest hash = sha256();
    for (Path each : entries) {
      if (Files.isDirectory(each)) {
        for (Path file : files(each)) {
          hash.update(
              each.relativize(file).toString().replace(File.separatorChar, '/').getBytes(UTF_8));
          hash.update(Files.readAllBytes(file));
        }
      } else {
        hash.update(Files.readAllBytes(each));
      }
    }
    return HexFormat.of().formatHex(hash.digest()).substring(0, DIGITS);
  }

  private static void add(Path entry, Set<Path> entries) throws IOException {
    if (!Files.exists(entry) || !entries.add(entry) || Files.isDirectory(entry)) {
      return;
    }
    try (JarFile jar = new JarFile(entry.toFile())) {
      Manifest manifest = jar.getManifest();
      String more =
          manifest == null
              ? null
              : manifest.getMainAttributes().getValue(Attributes.Name.CLASS_PATH);
      if (more != null) {
        for (String each : more.strip().split(" +")) {
          add(Path.of(entry.toUri().resolve(each)), entries); // a manifest has URLs
        }
      }
    }
  }

  private static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      return all.filter(Files::isRegularFile).sorted().toList();
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java must have SHA-256", e);
    }
  }
}
