package org.hdispatch.bench.dispatch;

import java.util.concurrent.atomic.AtomicLongArray;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/**
 * What it costs two threads to hand a cache line back and forth, measured before each iteration and
 * kept beside its reading. On a virtual machine it may change from one minute to the next, with the
 * cores that the host gives it, and the cost of every shared word with it.
 */
@State(Scope.Thread)
@AuxCounters(AuxCounters.Type.EVENTS)
public class RoundTrip {
  private static final int TRIPS = 40_000;
  private static final int LINE = 16; // longs: 128 bytes
  private static final int THERE = LINE;
  private static final int BACK = 2 * LINE;

  /** Nanoseconds per round trip. */
  public long roundTripNs;

  private long measured;

  /** Measures. */
  @Setup(Level.Iteration)
  public void measure() throws InterruptedException {
    AtomicLongArray words = new AtomicLongArray(3 * LINE);
    Thread other = new Thread(() -> answer(words));
    other.start();
    long begin = 0;
    for (int trip = 1; trip <= TRIPS; trip++) {
      words.set(THERE, trip);
      while (words.get(BACK) != trip) {
        Thread.onSpinWait();
      }
      if (trip == TRIPS / 2) { // both threads run, and the loop is compiled
        begin = System.nanoTime();
      }
    }
    measured = (System.nanoTime() - begin) / (TRIPS / 2);
    other.join();
  }

  private static void answer(AtomicLongArray words) {
    for (int trip = 1; trip <= TRIPS; trip++) {
      while (words.get(THERE) != trip) {
        Thread.onSpinWait();
      }
      words.set(BACK, trip);
    }
  }

  /** Puts the figure where JMH reads it, for it clears the counters after the set-up. */
  void report() {
    roundTripNs = measured;
  }
}
