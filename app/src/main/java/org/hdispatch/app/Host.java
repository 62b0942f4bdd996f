package org.hdispatch.app;

/**
 * What the process runs in, as far as the commands must know.
 *
 * @param heapBytes the most heap that this JVM will take
 * @param terminal whether somebody watches
 */
record Host(long heapBytes, boolean terminal) {
  /** What the JVM and the program take before any image, bytes. */
  private static final long BASE = 32L << 20;

  static Host ofThisProcess() {
    return new Host(Runtime.getRuntime().maxMemory(), System.console() != null);
  }

  /**
   * Checks that something will fit.
   *
   * @param what what it is, as the error calls it
   * @param bytes heap that it takes
   * @throws HeapException if it will not
   */
  void requireHeap(String what, double bytes) {
    if (bytes + BASE > heapBytes) {
      throw new HeapException(what, bytes + BASE, heapBytes);
    }
  }
}
