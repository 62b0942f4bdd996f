package org.hdispatch.app.lattice;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Properties;
import java.util.function.Consumer;
import org.hdispatch.app.console.Choices;
import org.hdispatch.porous.io.WholeFiles;

/**
 * What has been found out about this machine, kept in a properties file of the user: the shape of a
 * bundle that was fastest in the duct. A key names the kind of machine, for homes are shared, and
 * the settings that the shape was found with.
 */
final class MachineFile {
  private final Optional<Path> file;
  private final Consumer<String> warn;

  /**
   * Makes a view of the file; nothing is read yet.
   *
   * @param file the file, if anything is kept at all
   * @param warn receives a line where the file cannot be used
   */
  MachineFile(Optional<Path> file, Consumer<String> warn) {
    this.file = file;
    this.warn = warn;
  }

  Optional<Path> path() {
    return file;
  }

  /**
   * The shape kept for these settings, if there is one; what is wrong is said and ignored.
   *
   * @param side of the duct that it is meant for
   */
  Optional<BundleShape> bundle(DuctSettings settings, int side) {
    String key = key(settings);
    String text = read().map(all -> all.getProperty(key)).orElse(null);
    if (text == null) {
      return Optional.empty();
    }
    try {
      BundleShape shape = BundleShape.parse(text);
      shape.in(side);
      return Optional.of(shape);
    } catch (IllegalArgumentException e) {
      warn.accept(
          "bundle in the machine file must be "
              + BundleShape.GRAMMAR
              + " (ignored): file="
              + file.get()
              + ", "
              + key
              + "="
              + text);
      return Optional.empty();
    }
  }

  /** Keeps a shape for these settings, if anything is kept; returns whether it is kept now. */
  boolean keepBundle(DuctSettings settings, BundleShape shape) {
    Optional<Properties> properties = read();
    if (properties.isEmpty()) {
      return false;
    }
    properties.get().setProperty(key(settings), shape.toString());
    try {
      write(properties.get());
      return true;
    } catch (IOException e) {
      warn.accept(
          "machine file must be writable (nothing is stored): file=" + file.get() + ", cause=" + e);
      return false;
    }
  }

  /** Keeps what a sweep recommends, if it can be kept, and says what became of it. */
  String keepRecommended(SweepResult result) {
    Optional<SweepResult.Point> best = result.storable();
    if (best.isEmpty()) {
      return "no (a duct below " + SweepResult.LEAST_STORABLE_SIDE + "^3 nodes says little)";
    }
    return keepBundle(result.settings(), BundleShape.parse(best.get().label()))
        ? "in " + file.orElseThrow() + ", the default of duct --bundle"
        : "no";
  }

  /** What the file says; nothing if there is no file yet; empty if it cannot be used. */
  private Optional<Properties> read() {
    if (file.isEmpty()) {
      return Optional.empty();
    }
    Properties properties = new Properties();
    if (!Files.exists(file.get())) {
      return Optional.of(properties);
    }
    try (InputStream in = Files.newInputStream(file.get())) {
      properties.load(in);
      return Optional.of(properties);
    } catch (IOException | IllegalArgumentException e) {
      warn.accept("machine file must be readable (ignored): file=" + file.get() + ", cause=" + e);
      return Optional.empty();
    }
  }

  private void write(Properties properties) throws IOException {
    ByteArrayOutputStream text = new ByteArrayOutputStream();
    properties.store(text, "Found by: hdispatch duct");
    ByteBuffer bytes = ByteBuffer.wrap(text.toByteArray());
    Files.createDirectories(file.get().toAbsolutePath().getParent());
    WholeFiles.write(
        file.get(),
        channel -> {
          while (bytes.hasRemaining()) {
            channel.write(bytes);
          }
        });
  }

  private static String key(DuctSettings settings) {
    return String.join(
        ".",
        System.getProperty("os.arch") + "-" + Runtime.getRuntime().availableProcessors(),
        settings.lattice().name(),
        Choices.word(settings.storage()),
        Choices.word(settings.streaming()),
        Choices.word(settings.kernel()),
        "bundle");
  }
}
