package org.hdispatch.app.study;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
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
  private final int threads;
  private final double seconds;
  private final RowFiles files;
  private final Forks forks;

  /**
   * Says what to run.
   *
   * @param jdks of which at least one; the first finds the smallest heaps
   * @param scope which cases
   * @param threads that step
   * @param seconds of each measurement
   * @param folder where the rows are kept; exists
   */
  public GcStudy(List<Jdk> jdks, StudyScope scope, int threads, double seconds, Path folder) {
    this(jdks, scope.cases(jdks), threads, seconds, folder);
  }

  GcStudy(List<Jdk> jdks, List<GcCase> cases, int threads, double seconds, Path folder) {
    this.jdks = List.copyOf(jdks);
    this.cases = List.copyOf(cases);
    this.threads = threads;
    this.seconds = seconds;
    files = new RowFiles(folder);
    forks = new Forks(folder, threads);
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
   * Runs what has not been run yet.
   *
   * @throws IOException if a file cannot be read or written, a JVM not started, or a workload does
   *     not run in any heap
   * @throws CancellationException if this thread is interrupted
   */
  public void run(Listener listener) throws IOException {
    List<GcCase> left = new ArrayList<>();
    for (GcCase each : cases) {
      if (!isDone(each)) {
        left.add(each);
      }
    }
    for (int n = 0; n < left.size(); n++) {
      GcCase each = left.get(n);
      long smallest = smallestHeap(each, listener, n + 1, left.size());
      listener.runs(title(each), n + 1, left.size());
      files.write(run(each, heapBytes(smallest, each.heapFactor())));
    }
  }

  private boolean isDone(GcCase run) throws IOException {
    Optional<GcRow> row = files.row(run);
    return row.isPresent()
        && row.get()
            .figures()
            .map(
                figures ->
                    figures.seconds() >= LONG_ENOUGH * seconds && figures.workers() == threads)
            .orElse(!Forks.isAccident(row.get().why()));
  }

  private long smallestHeap(GcCase run, Listener listener, int number, int of) throws IOException {
    Optional<SmallestHeap> known = files.smallestHeap(run.workload(), run.scratchBytes());
    if (known.isPresent()) {
      return known.get().bytes();
    }
    listener.runs(
        "smallest heap of " + run.workload() + ", " + scratch(run.scratchBytes()), number, of);
    SmallestHeap found =
        new HeapSearch(forks, jdks.get(0), CLOSE).find(run.workload(), run.scratchBytes());
    files.write(found);
    return found.bytes();
  }

  /** In whole, even MiB, as some collectors round to them. */
  private static long heapBytes(long smallest, double factor) {
    return 2 * MIB * Math.round(factor * smallest / (2 * MIB));
  }

  private GcRow run(GcCase run, long heapBytes) throws IOException {
    Jdk jdk =
        jdks.stream().filter(each -> each.version().equals(run.java())).findFirst().orElseThrow();
    double warmUp = run.workload() == Workload.SPH ? WARM_UP_SPH : WARM_UP;
    double patience = PATIENCE + PATIENCE_FACTOR * (warmUp + seconds);
    return forks.run(run, jdk, heapBytes, warmUp, seconds, patience);
  }

  private static String title(GcCase run) {
    return "Java "
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
