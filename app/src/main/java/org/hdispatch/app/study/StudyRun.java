package org.hdispatch.app.study;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hdispatch.gc.AllocationMeter;
import org.hdispatch.gc.GcReport;
import org.hdispatch.gc.GcWatch;

/**
 * One run, as the program of a JVM of its own: {@code WORKLOAD POLICY SCRATCH-BYTES THREADS
 * WARM-UP-SECONDS SECONDS HEAP-BYTES FILE}. Warms up, lets the collector collect, then measures and
 * writes {@link GcFigures} to the file.
 */
public final class StudyRun {
  /** Share of the warm-up after the collection: for what is concurrent in it to end. */
  private static final double REST = 0.2;

  /** While compilers took more than this of the last rest, it goes on, but not for ever. */
  private static final long COMPILED_MILLIS = 10;

  private static final int MOST_RESTS = 3;

  private static final double NANO = 1e-9;
  private static final double MILLI = 1e-6; // of a nanosecond

  private final Work<?, ?> work;
  private final int workers;
  private final long heapBytes;
  private final OperatingSystemMXBean process =
      (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
  private final CompilationMXBean compilers = ManagementFactory.getCompilationMXBean();
  private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();

  private StudyRun(Work<?, ?> work, int workers, long heapBytes) {
    this.work = work;
    this.workers = workers;
    this.heapBytes = heapBytes;
  }

  /**
   * Runs.
   *
   * @param args what and how
   * @throws IOException if the file cannot be written
   */
  public static void main(String[] args) throws IOException {
    Work<?, ?> work = Work.of(Workload.valueOf(args[0]), Integer.parseInt(args[2]));
    StudyRun run = new StudyRun(work, Integer.parseInt(args[3]), Long.parseLong(args[6]));
    GcFigures figures =
        run.figures(
            ScratchPolicy.valueOf(args[1]),
            Double.parseDouble(args[4]),
            Double.parseDouble(args[5]));
    Files.writeString(Path.of(args[7]), RecordJson.write(figures));
  }

  private GcFigures figures(ScratchPolicy policy, double warmUpSeconds, double seconds) {
    // The recorder first: in JDK 17 its start drops all code compiled so far.
    try (GcWatch watch = GcWatch.start();
        Stepper stepper = Stepper.of(work, policy, workers)) {
      StepHistogram thrownAway = new StepHistogram();
      step(stepper, (1 - REST) * warmUpSeconds, thrownAway);
      System.gc();
      System.gc(); // what the first has found to be finished is gone now
      long compiled;
      int rests = 0;
      do {
        compiled = compilers.getTotalCompilationTime();
        step(stepper, REST * warmUpSeconds, thrownAway);
        compiled = compilers.getTotalCompilationTime() - compiled;
      } while (compiled > COMPILED_MILLIS && ++rests < MOST_RESTS);
      return window(watch, stepper, seconds);
    }
  }

  private GcFigures window(GcWatch watch, Stepper stepper, double seconds) {
    StepHistogram histogram = new StepHistogram();
    long[] ids = stepper.threads();
    AllocationMeter meter = new AllocationMeter(ids);
    long[] bytesBefore = new long[ids.length];
    long[] bytesAfter = new long[ids.length];
    Map<Long, Long> cpuBefore = cpu(ids);
    meter.read(bytesAfter); // loads what it needs
    CollectorCpu.nanos();
    watch.mark();
    long collectorBefore = CollectorCpu.nanos();
    cpuBefore = cpu(ids);
    long processBefore = process.getProcessCpuTime();
    meter.read(bytesBefore);
    long begin = System.nanoTime();
    long steps = step(stepper, seconds, histogram);
    long end = System.nanoTime();
    meter.read(bytesAfter);
    long processAfter = process.getProcessCpuTime();
    Map<Long, Long> cpuAfter = cpu(stepper.threads());
    long collectorAfter = CollectorCpu.nanos();
    watch.mark();
    long used = ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
    List<GcReport> windows = watch.stop();
    GcReport report = windows.get(windows.size() - 2); // between the two marks

    double workerCpu = 0;
    for (Map.Entry<Long, Long> each : cpuAfter.entrySet()) { // a carrier may have come meanwhile
      workerCpu += NANO * (each.getValue() - cpuBefore.getOrDefault(each.getKey(), 0L));
    }
    double otherCpu = NANO * (processAfter - processBefore) - workerCpu;
    long worst = 0;
    long all = 0;
    for (int n = 0; n < ids.length; n++) {
      long bytes = bytesAfter[n] < 0 ? 0 : bytesAfter[n] - bytesBefore[n]; // -1: has ended
      worst = Math.max(worst, bytes);
      all += bytes;
    }
    return new GcFigures(
        heapBytes,
        Math.max(used, report.peakHeapBytes()),
        workers,
        work.scheme().cells().size(),
        steps,
        NANO * (end - begin),
        workerCpu,
        Math.max(0, otherCpu), // the process is counted in ticks of 10 ms
        collectorAfter < 0 ? -1 : NANO * (collectorAfter - collectorBefore),
        report.collections(),
        stops(report.pauses()),
        stops(report.safepoints()),
        MILLI * report.reaching().toNanos(),
        stops(report.stalls()),
        histogram.times(),
        (double) worst / steps,
        (double) all / steps,
        report.timeline().stream().map(StudyRun::pause).toList());
  }

  /** Steps for a time, once at least. */
  private static long step(Stepper stepper, double seconds, StepHistogram histogram) {
    long begin = System.nanoTime();
    long last = begin;
    long steps = 0;
    do {
      stepper.step();
      long now = System.nanoTime();
      histogram.record(now - last);
      last = now;
      steps++;
    } while (last - begin < seconds / NANO);
    return steps;
  }

  private Map<Long, Long> cpu(long[] ids) {
    Map<Long, Long> nanos = new HashMap<>();
    for (long id : ids) {
      nanos.put(id, Math.max(0, threads.getThreadCpuTime(id)));
    }
    return nanos;
  }

  private static GcFigures.Stops stops(GcReport.Stops stops) {
    return new GcFigures.Stops(
        stops.count(),
        MILLI * stops.total().toNanos(),
        MILLI * stops.p99().toNanos(),
        MILLI * stops.longest().toNanos());
  }

  private static GcFigures.Pause pause(GcReport.Pause pause) {
    return new GcFigures.Pause(
        NANO * pause.at().toNanos(), MILLI * pause.length().toNanos(), pause.name());
  }
}
