package org.hdispatch.porous.block;

/**
 * The most heap that this JVM will take.
 *
 * @param bytes of heap
 */
public record HeapLimit(long bytes) {
  /** What the JVM and the program take before any image, bytes. */
  public static final long BASE = 32L << 20;

  /** That of this process, its {@code -Xmx}. */
  public static HeapLimit ofThisProcess() {
    return new HeapLimit(Runtime.getRuntime().maxMemory());
  }

  /**
   * Checks that something will fit.
   *
   * @param what what it is, as the error calls it
   * @param needed heap that it takes, bytes
   * @throws HeapException if it will not
   */
  public void require(String what, double needed) {
    if (needed + BASE > bytes) {
      throw new HeapException(what, needed + BASE, bytes);
    }
  }
}
