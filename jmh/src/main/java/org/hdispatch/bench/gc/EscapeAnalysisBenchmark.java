package org.hdispatch.bench.gc;

import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Threads;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Does escape analysis remove small objects from an inner loop, so that nobody need care? The
 * counter-example: it does, but not the one that is carried round the loop.
 *
 * <p>Distances to 2730 points are added up, weighted, as vectors. Score: ns per point; with {@code
 * -prof gc}, {@code gc.alloc.rate.norm} is bytes per point.
 *
 * <p>Expected: {@code doubles} and {@code temporaries} alike, 0 bytes; {@code carried}, where the
 * sum is a vector too and made anew for each point, 40 bytes of its three vectors' 120; without
 * escape analysis ({@code -XX:-DoEscapeAnalysis}) all of them, 80 and 120 bytes, and twice the time
 * or more. So write the sum as three numbers. Seen, in a short run: 0, 0, 40, 80 and 120 bytes,
 * exactly; carried 3.8 times doubles; without escape analysis carried 2.0 and temporaries 6.1 times
 * what they take with it.
 *
 * <pre>{@code
 * java -jar jmh/target/benchmarks.jar EscapeAnalysisBenchmark -prof gc
 * }</pre>
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Threads(1)
@Fork(
    value = 3,
    jvmArgs = {"-Xms256m", "-Xmx256m"})
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
public class EscapeAnalysisBenchmark {
  /** Points per call. */
  static final int POINTS = 2730;

  private static final int SEED = 27;

  /** A vector that is never changed: each sum is a new one. */
  record Vector(double x, double y, double z) {
    Vector minus(Vector other) {
      return new Vector(x - other.x, y - other.y, z - other.z);
    }

    Vector plus(Vector other) {
      return new Vector(x + other.x, y + other.y, z + other.z);
    }

    Vector times(double factor) {
      return new Vector(factor * x, factor * y, factor * z);
    }

    double square() {
      return x * x + y * y + z * z;
    }
  }

  /** Some points. */
  @State(Scope.Benchmark)
  public static class Points {
    private final Vector[] at = new Vector[POINTS];
    private final Vector here = new Vector(0.5, 0.5, 0.5);

    /** Makes them. */
    @Setup(Level.Trial)
    public void begin() {
      Random random = new Random(SEED);
      for (int n = 0; n < POINTS; n++) {
        at[n] = new Vector(random.nextDouble(), random.nextDouble(), random.nextDouble());
      }
    }

    /** Two vectors a point, the sum as three numbers. */
    double temporaries() {
      double x = 0;
      double y = 0;
      double z = 0;
      for (Vector point : at) {
        Vector distance = point.minus(here);
        Vector weighted = distance.times(1 - distance.square());
        x += weighted.x;
        y += weighted.y;
        z += weighted.z;
      }
      return x + y + z;
    }

    /** Three vectors a point: the sum is one, too. */
    double carried() {
      Vector sum = new Vector(0, 0, 0);
      for (Vector point : at) {
        Vector distance = point.minus(here);
        sum = sum.plus(distance.times(1 - distance.square()));
      }
      return sum.x + sum.y + sum.z;
    }
  }

  /** Numbers alone. */
  @Benchmark
  @OperationsPerInvocation(POINTS)
  public double doubles(Points points) {
    double x = 0;
    double y = 0;
    double z = 0;
    for (Vector point : points.at) {
      double dx = point.x - points.here.x;
      double dy = point.y - points.here.y;
      double dz = point.z - points.here.z;
      double weight = 1 - (dx * dx + dy * dy + dz * dz);
      x += weight * dx;
      y += weight * dy;
      z += weight * dz;
    }
    return x + y + z;
  }

  /** Two vectors a point, the sum as three numbers. */
  @Benchmark
  @OperationsPerInvocation(POINTS)
  public double temporaries(Points points) {
    return points.temporaries();
  }

  /** Three vectors a point: the sum is one, too. */
  @Benchmark
  @OperationsPerInvocation(POINTS)
  public double carried(Points points) {
    return points.carried();
  }

  /** As {@link #temporaries}, without escape analysis. */
  @Benchmark
  @Fork(
      value = 3,
      jvmArgs = {"-Xms256m", "-Xmx256m"},
      jvmArgsAppend = "-XX:-DoEscapeAnalysis")
  @OperationsPerInvocation(POINTS)
  public double temporariesWithout(Points points) {
    return points.temporaries();
  }

  /** As {@link #carried}, without escape analysis. */
  @Benchmark
  @Fork(
      value = 3,
      jvmArgs = {"-Xms256m", "-Xmx256m"},
      jvmArgsAppend = "-XX:-DoEscapeAnalysis")
  @OperationsPerInvocation(POINTS)
  public double carriedWithout(Points points) {
    return points.carried();
  }
}
