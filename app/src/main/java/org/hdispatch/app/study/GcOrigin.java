package org.hdispatch.app.study;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * What a row was made with, and where. Rows that differ in it are not to be compared.
 *
 * @param vendor of the JVM
 * @param runtime its full version, such as {@code 17.0.15+6-Debian-1deb12u1}
 * @param processor its name
 * @param cores processors that the JVM may use
 * @param memoryGib memory of the machine, rounded, GiB
 * @param system operating system, its version, and architecture
 * @param build hash of the code that ran, hexadecimal
 */
public record GcOrigin(
    String vendor,
    String runtime,
    String processor,
    int cores,
    long memoryGib,
    String system,
    String build) {
  private static final Path CPUINFO = Path.of("/proc/cpuinfo");

  /**
   * That of a row that is made now.
   *
   * @param jdk whose JVM
   * @param build hash of this program's code
   */
  static GcOrigin of(Jdk jdk, String build) {
    OperatingSystemMXBean system =
        (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
    return new GcOrigin(
        jdk.vendor(),
        jdk.runtime(),
        processor(CPUINFO),
        Runtime.getRuntime().availableProcessors(),
        Math.round((double) system.getTotalMemorySize() / (1 << 30)),
        system.getName() + " " + system.getVersion() + ", " + system.getArch(),
        build);
  }

  /** Name of the processor: Linux has it in a file, Windows in the environment. */
  static String processor(Path cpuinfo) {
    try (Stream<String> lines = Files.lines(cpuinfo, StandardCharsets.UTF_8)) {
      return lines
          .filter(line -> line.startsWith("model name"))
          .map(line -> line.substring(line.indexOf(':') + 1).strip())
          .findFirst()
          .orElse("unknown");
    } catch (IOException e) { // not Linux
      return System.getenv().getOrDefault("PROCESSOR_IDENTIFIER", "unknown");
    }
  }

  /** In what another differs, in words; nothing if it does not. */
  List<String> differences(GcOrigin other) {
    List<String> differences = new ArrayList<>();
    if (!jvm().equals(other.jvm())) {
      differences.add("JVM");
    }
    if (!machine().equals(other.machine())) {
      differences.add("machine");
    }
    if (!build.equals(other.build)) {
      differences.add("build");
    }
    return differences;
  }

  /** The machine, in words. */
  public String machine() {
    return processor + ", " + cores + " cores, " + memoryGib + " GiB, " + system;
  }

  /** The JVM, in words. */
  public String jvm() {
    return runtime + " of " + vendor;
  }
}
