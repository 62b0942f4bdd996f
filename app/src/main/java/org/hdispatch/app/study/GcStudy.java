package org.hdispatch.app.study;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/**
 * Runs the cases of a study one after the other. Each row is kept as soon as it is there, and a
 * case whose row is there is not run again.
 */
public final class GcStudy {
  private static final long MIB = 1 << 20;
  private static final double WARM_UP = 1; // s

  /** Of particles, whose lists of neighbours grow for some rebuilds. */
  private static final double WARM_UP_SPH = 3;

  /** Of the smallest heap to one that is too small. */
  private static final double CLOSE = 1.03;

  private static final double PATIENCE = 30; // s, besides what is asked for
  private static final double PATIENCE_FACTOR = 5;

  /** A row measured for less than this share of the seconds asked for is made anew. */
  private static final double LONG_ENOUGH = 0.99;

  private final List<Jdk> jdks;
  private final List<GcCase> cases;
  private final int repeats;
  private final int threads;
  private final double seconds;
  private final RowFiles files;
  private final Forks forks;
  private final String build;
  private final Map<String, GcOrigin> origins = new HashMap<>(); // by version of Java

  /**
   * Says what to run.
   *
   * @param jdks of which at least one; the first finds the smallest heaps
   * @param scope which cases
   * @param repeats how often each is run
   * @param threads that step
   * @param seconds of each measurement
   * @param folder where the rows are kept; exists
   * @throws IOException if the code of this program cannot be read
   */
  public GcStudy(
      List<Jdk> jdks, StudyScope scope, int repeats, int threads, double seconds, Path folder)
      throws IOException {
    this.jdks = List.copyOf(jdks);
    cases = scope.cases(jdks);
    this.repeats = repeats;
    this.threads = threads;
    this.seconds = seconds;
    files = new RowFiles(folder);
    forks = new Forks(folder, threads);
    build = CodeHash.of(ChildJvm.classPath());
    jdks.forEach(jdk -> origins.put(jdk.version(), GcOrigin.of(jdk, build)));
  }

  /** Hears of each run before it starts. */
  @FunctionalInterface
  public interface Listener {
    /**
     * A run starts.
     *
     * @param what it is
     * @param number its number, from 1, among those to be run now
     * @param of how many those are
     */
    void runs(String what, int number, int of);
  }

  /**
   * A run of a case.
   *
   * @param of the case
   * @param fork which run of it, from 1
   */
  private record Fork(GcCase of, int fork) {}

  /** Rounds over all cases: what is compared lies next to each other in time, again and again. */
  private List<Fork> all() {
    List<Fork> all = new ArrayList<>();
    for (int fork = 1; fork <= repeats; fork++) {
      for (GcCase each : cases) {
        all.add(new Fork(each, fork));
      }
    }
    return all;
  }

  /**
   * Rows that are there but were made by another build, or on another machine or JVM: they will be
   * made anew.
   *
   * @return for each, in what it differs, such as {@code build}
   * @throws IOException if a file cannot be read
   */
  public List<List<String>> foreign() throws IOException {
    List<List<String>> foreign = new ArrayList<>();
    for (Fork each : all()) {
      files
          .row(each.of(), each.fork())
          .map(row -> row.origin().differences(origin(each.of())))
          .filter(differences -> !differences.isEmpty())
          .ifPresent(foreign::add);
    }
    return foreign;
  }

  private GcOrigin origin(GcCase of) {
    return origins.get(of.java());
  }

  private Jdk jdk(GcCase of) {
    return jdks.stream().filter(each -> each.version().equals(of.java())).findFirst().orElseThrow();
  }

  /**
   * Runs what has not been run yet.
   *
   * @throws IOException if a file cannot be read or written, a JVM not started, or a workload does
   *     not run in any heap
   * @throws CancellationException if this thread is interrupted
   */
  public void run(Listener listener) throws IOException {
    List<Fork> left = new ArrayList<>();
    for (Fork each : all()) {
      if (!isDone(each)) {
        left.add(each);
      }
    }
    for (int n = 0; n < left.size(); n++) {
      GcCase each = left.get(n).of();
      long smallest = smallestHeap(each, listener, n + 1, left.size());
      listener.runs(title(left.get(n)), n + 1, left.size());
      Forks.Outcome ended = run(each, heapBytes(smallest, each.heapFactor()));
      files.write(new GcRow(each, ended.why(), ended.figures(), left.get(n).fork(), origin(each)));
    }
  }

  private boolean isDone(Fork run) throws IOException {
    Optional<GcRow> row = files.row(run.of(), run.fork());
    return row.isPresent()
        && row.get().origin().equals(origin(run.of()))
        && row.get()
            .figures()
            .map(
                figures ->
                    figures.seconds() >= LONG_ENOUGH * seconds && figures.workers() == threads)
            .orElse(!Forks.isAccident(row.get().why()));
  }

  private long smallestHeap(GcCase run, Listener listener, int number, int of) throws IOException {
    Optional<SmallestHeap> known = files.smallestHeap(run.workload(), run.scratchBytes());
    if (known.isPresent() && known.get().build().equals(build)) {
      return known.get().bytes();
    }
    listener.runs(
        "smallest heap of " + run.workload() + ", " + scratch(run.scratchBytes()), number, of);
    SmallestHeap found =
        new HeapSearch(forks, jdks.get(0), CLOSE, build).find(run.workload(), run.scratchBytes());
    files.write(found);
    return found.bytes();
  }

  /** In whole, even MiB, as some collectors round to them. */
  private static long heapBytes(long smallest, double factor) {
    return 2 * MIB * Math.round(factor * smallest / (2 * MIB));
  }

  private Forks.Outcome run(GcCase run, long heapBytes) throws IOException {
    double warmUp = run.workload() == Workload.SPH ? WARM_UP_SPH : WARM_UP;
    double patience = PATIENCE + PATIENCE_FACTOR * (warmUp + seconds);
    return forks.run(run, jdk(run), heapBytes, warmUp, seconds, patience);
  }

  private String title(Fork fork) {
    GcCase run = fork.of();
    return (repeats > 1 ? "round " + fork.fork() + ", Java " : "Java ")
        + run.java()
        + ", "
        + run.collector().title()
        + ", "
        + run.heapFactor()
        + "x, "
        + run.policy()
        + ", "
        + run.workload()
        + ", "
        + scratch(run.scratchBytes());
  }

  private static String scratch(int bytes) {
    return (bytes >> 10) + " KiB";
  }
}
