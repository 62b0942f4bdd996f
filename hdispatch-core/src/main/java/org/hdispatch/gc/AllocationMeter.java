package org.hdispatch.gc;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;

/**
 * Bytes of heap that given threads have allocated since each of them started, exact to the byte.
 *
 * <p>Reading allocates nothing, neither on the threads that are measured nor on the one that reads
 * (once warmed up), so the reader may be one of the measured threads. The reading of a thread that
 * is running at the time is a momentary value; that of one that waits is exact.
 *
 * <p>Immutable; may be shared by threads.
 */
public final class AllocationMeter {

  private static final ThreadMXBean THREADS = bean();

  private final long[] threadIds;

  /**
   * A meter of the given threads.
   *
   * @param threadIds identifiers of platform threads ({@link Thread#getId()}); copied
   * @throws UnsupportedOperationException if this JVM does not count allocated bytes, or was told
   *     not to
   */
  public AllocationMeter(long... threadIds) {
    if (THREADS == null || !THREADS.isThreadAllocatedMemoryEnabled()) {
      throw new UnsupportedOperationException(
          "JVM must count the bytes that threads allocate: vm="
              + System.getProperty("java.vm.name"));
    }
    this.threadIds = threadIds.clone();
  }

  /**
   * Number of threads measured.
   *
   * @return length that an array given to {@link #read} must at least have
   */
  public int threads() {
    return threadIds.length;
  }

  /**
   * Reads all counters, in the order in which the threads were given.
   *
   * @param into receives the bytes allocated by each thread so far, or -1 for one that has ended
   * @throws ArrayIndexOutOfBoundsException if the array is shorter than {@link #threads()}
   */
  public void read(long[] into) {
    for (int i = 0; i < threadIds.length; i++) {
      into[i] = THREADS.getThreadAllocatedBytes(threadIds[i]);
    }
  }

  private static ThreadMXBean bean() {
    return ManagementFactory.getThreadMXBean() instanceof ThreadMXBean threads
            && threads.isThreadAllocatedMemorySupported()
        ? threads
        : null;
  }
}
