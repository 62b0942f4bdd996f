package org.hdispatch.bench.lbm;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryMXBean;
import java.util.function.Supplier;

/**
 * Something made, and the heap that it holds as the collector counts it: objects, their headers and
 * padding, hash maps, what an array leaves over of a region.
 *
 * @param made what was made
 * @param bytes of heap that it holds
 * @param <T> its type
 */
public record Held<T>(T made, long bytes) {
  /** Makes something and measures it. Epsilon, which cannot tell garbage, counts that too. */
  public static <T> Held<T> measure(Supplier<? extends T> maker) {
    long before = used();
    T made = maker.get();
    return new Held<>(made, used() - before);
  }

  /** Bytes in use after full collections: the second finds what the first has freed late. */
  private static long used() {
    MemoryMXBean memory = ManagementFactory.getMemoryMXBean();
    memory.gc();
    memory.gc();
    return memory.getHeapMemoryUsage().getUsed();
  }
}
