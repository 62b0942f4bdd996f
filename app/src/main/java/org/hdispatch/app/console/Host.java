package org.hdispatch.app.console;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.porous.block.HeapException;
import org.hdispatch.porous.block.HeapLimit;

/**
 * What the process runs in, as far as the commands must know.
 *
 * @param heapBytes the most heap that this JVM will take
 * @param terminal whether somebody watches
 * @param machineFile where findings about this machine are kept, if anywhere
 */
public record Host(long heapBytes, boolean terminal, Optional<Path> machineFile) {
  /** A host that keeps nothing. */
  public Host(long heapBytes, boolean terminal) {
    this(heapBytes, terminal, Optional.empty());
  }

  /** What this process runs in. */
  public static Host ofThisProcess() {
    return new Host(
        Runtime.getRuntime().maxMemory(),
        System.console() != null,
        machineFile(System.getenv(), System.getProperty("user.home")));
  }

  /**
   * Where users expect findings about this machine to be kept: {@code XDG_CONFIG_HOME}, or {@code
   * .config} in their home; {@code APPDATA} on Windows.
   *
   * @param environment variables of the process
   * @param home the user's home, or null
   */
  static Optional<Path> machineFile(Map<String, String> environment, String home) {
    for (String variable : new String[] {"XDG_CONFIG_HOME", "APPDATA"}) {
      String folder = environment.getOrDefault(variable, "");
      if (!folder.isEmpty() && Path.of(folder).isAbsolute()) {
        return Optional.of(inFolder(Path.of(folder)));
      }
    }
    return home == null || home.isEmpty()
        ? Optional.empty()
        : Optional.of(inFolder(Path.of(home, ".config")));
  }

  private static Path inFolder(Path folder) {
    return folder.resolve("hdispatch").resolve("machine.properties");
  }

  /** Adds what a program runs on. */
  public static FlatRow describe(FlatRow row) {
    return row.put("processors", Runtime.getRuntime().availableProcessors())
        .put("architecture", System.getProperty("os.arch"))
        .put("version", Version.ofProject())
        .put("java", Version.ofJava());
  }

  /** The heap as what computations must fit into. */
  public HeapLimit heap() {
    return new HeapLimit(heapBytes);
  }

  /**
   * Checks that something will fit.
   *
   * @param what what it is, as the error calls it
   * @param bytes heap that it takes
   * @throws HeapException if it will not
   */
  public void requireHeap(String what, double bytes) {
    heap().require(what, bytes);
  }

  /**
   * Heap that is left beside something that takes this much, bytes; negative if it does not fit.
   */
  public double heapBeside(double bytes) {
    return heapBytes - HeapLimit.BASE - bytes;
  }
}
