package org.hdispatch.app.study;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.hdispatch.app.study.SoakResult.Figures;
import org.hdispatch.app.study.SoakResult.Verdict;

/**
 * Runs a job under one collector after another, each in a JVM of its own, and looks whether
 * anything was left to the collector.
 *
 * <p>A first JVM, under Serial, measures what is in use after the set-up: with what the start of
 * the JVM and the set-up have left behind, and, after a full collection, without that: the live
 * set. Epsilon never reclaims what was left behind, so it gets the former and 16 MB for the steps,
 * warm-up included; the others get 128 MB more, so that they have no reason to collect either.
 *
 * <p>There is no Flight Recorder in these JVMs, for it allocates. Bytes come from the counters of
 * the threads, collections from the management beans, safepoints and stalls from the JVM's log.
 * Collections that ZGC and Shenandoah make by the clock, without any need, are switched off.
 */
public final class Soak {
  private static final long MEBIBYTE = 1L << 20;
  private static final long EPSILON_ROOM = 16 * MEBIBYTE;
  private static final long ROOM = 128 * MEBIBYTE;

  /** Parts of a run, of a hundred, in which not a byte may be allocated: the median is 0. */
  private static final int LEAST_PARTS = 51;

  private static final String LOG = "jvm.log";

  /** A heap in which no set-up is collected before it is measured. */
  private static final List<String> ROOMY = List.of("-Xms512m", "-Xmx512m", "-Xmn400m");

  /** Ends a JVM that is out of memory, wherever that happens. */
  private static final String ALL_OR_NOTHING = "-XX:+ExitOnOutOfMemoryError";

  private final ChildJvm jvm;
  private final SoakJob job;
  private final Map<String, String> set; // what the first JVM said

  private Soak(ChildJvm jvm, SoakJob job, Map<String, String> set) {
    this.jvm = jvm;
    this.job = job;
    this.set = set;
  }

  /**
   * Measures the live set of a job.
   *
   * @throws IOException if a JVM cannot be started, or ends before it has said
   */
  public static Soak of(ChildJvm jvm, SoakJob job) throws IOException {
    List<String> args = new ArrayList<>(job.toArgs());
    args.add(SoakChild.LIVE_SET);
    List<String> options = new ArrayList<>(Collector.SERIAL.options());
    options.addAll(ROOMY);
    ChildJvm.Ended first = jvm.run(options, SoakChild.class, args);
    if (first.code() != 0) {
      throw new IOException(
          "JVM must run the soak: jdk=" + jvm.jdk().home() + ", cause=" + first.lastWords());
    }
    return new Soak(jvm, job, pairs(first.out()));
  }

  private static Map<String, String> pairs(String out) {
    Map<String, String> pairs = new HashMap<>();
    out.lines()
        .map(line -> line.split("=", 2))
        .filter(pair -> pair.length == 2)
        .forEach(pair -> pairs.put(pair[0], pair[1]));
    return pairs;
  }

  private long said(String key) {
    return Long.parseLong(set.get(key));
  }

  /**
   * Runs the job under a collector.
   *
   * @throws IOException if a JVM cannot be started, or its log cannot be read
   */
  public SoakResult run(Collector collector) throws IOException {
    long room = collector == Collector.EPSILON ? EPSILON_ROOM : ROOM;
    long heap = (said("allocated") + room + MEBIBYTE - 1) / MEBIBYTE * MEBIBYTE;
    List<String> options = new ArrayList<>(collector.options());
    options.addAll(withoutClock(collector));
    options.addAll(List.of("-Xms" + heap, "-Xmx" + heap));
    if (!jvm.knows(collector.options())) {
      return result(collector, heap, Verdict.LEFT_OUT, "not in this JDK", Optional.empty());
    }
    Path log = jvm.folder().resolve(LOG);
    Files.deleteIfExists(log);
    options.addAll(List.of(ALL_OR_NOTHING, JvmLog.option(LOG)));
    ChildJvm.Ended ended = jvm.run(options, SoakChild.class, job.toArgs());
    if (ended.code() != 0) {
      String why = "exit code " + ended.code() + ": " + ended.lastWords();
      return result(collector, heap, Verdict.FAILED, why, Optional.empty());
    }
    Figures figures = figures(pairs(ended.out()), log);
    String why = objection(figures);
    Verdict verdict = why.isEmpty() ? Verdict.PASSED : Verdict.FAILED;
    return result(collector, heap, verdict, why, Optional.of(figures));
  }

  private static List<String> withoutClock(Collector collector) {
    return switch (collector) {
      case ZGC -> List.of("-XX:-ZProactive");
      case SHENANDOAH ->
          List.of("-XX:+UnlockExperimentalVMOptions", "-XX:ShenandoahGuaranteedGCInterval=0");
      case SHENANDOAH_GENERATIONAL ->
          List.of(
              "-XX:+UnlockExperimentalVMOptions",
              "-XX:ShenandoahGuaranteedGCInterval=0",
              "-XX:ShenandoahGuaranteedYoungGCInterval=0",
              "-XX:ShenandoahGuaranteedOldGCInterval=0");
      default -> List.of();
    };
  }

  private static Figures figures(Map<String, String> said, Path log) throws IOException {
    long from = Long.parseLong(said.get("from"));
    long to = Long.parseLong(said.get("to"));
    try (Stream<String> lines = Files.lines(log, Charset.defaultCharset())) {
      JvmLog window = JvmLog.of(lines, from, to);
      return new Figures(
          (to - from) * 1e-9,
          Long.parseLong(said.get("bytes")),
          Integer.parseInt(said.get("parts")),
          Long.parseLong(said.get("collections")),
          window.collectorSafepoints(),
          window.safepoints(),
          window.stalls(),
          said.get("result"));
    }
  }

  /** What speaks against these figures; nothing if they are as they should be. */
  private static String objection(Figures figures) {
    List<String> objections = new ArrayList<>();
    if (figures.collections() > 0) {
      objections.add(figures.collections() + " collections");
    }
    if (figures.collectorSafepoints() > 0) {
      objections.add(figures.collectorSafepoints() + " safepoints of the collector");
    }
    if (figures.stalls() > 0) {
      objections.add(figures.stalls() + " stalls");
    }
    if (figures.bytes() < 0) {
      objections.add("bytes not counted");
    } else if (figures.partsWithoutBytes() < LEAST_PARTS) {
      objections.add(
          "bytes in "
              + (SoakChild.PARTS - figures.partsWithoutBytes())
              + " parts of "
              + SoakChild.PARTS);
    }
    return String.join(", ", objections);
  }

  private SoakResult result(
      Collector collector, long heap, Verdict verdict, String why, Optional<Figures> figures) {
    return new SoakResult(
        set.get("java"), collector, job, heap, said("live"), verdict, why, figures);
  }
}
