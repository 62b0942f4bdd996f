package org.hdispatch.porous.block;

import java.util.Locale;

/** The heap is too small; the message says what is needed and which -Xmx gives it. */
public final class HeapException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** What -Xmx gives beyond the need, as collectors leave parts of regions empty. */
  private static final double SLACK = 1.1;

  private static final long ROUNDING_MIB = 64;
  private static final double MIB = 1 << 20;

  private final String need;

  /**
   * Something that does not fit.
   *
   * @param what what it is, as the error calls it
   * @param neededBytes heap that it takes
   * @param heapBytes the most heap there is
   */
  public HeapException(String what, double neededBytes, long heapBytes) {
    super(
        String.format(
            Locale.ROOT,
            "heap must hold %s: needed=%.0f MiB, heap=%.0f MiB"
                + " (give java -Xmx%.0fm, or HDISPATCH_JAVA_OPTS=-Xmx%<.0fm)",
            what,
            neededBytes / MIB,
            heapBytes / MIB,
            megabytesToGive(neededBytes)));
    need =
        String.format(
            Locale.ROOT,
            "heap must hold %s: needed=%.0f MiB (give java -Xmx%.0fm)",
            what,
            neededBytes / MIB,
            megabytesToGive(neededBytes));
  }

  /** The message without the heap of this machine. */
  public String need() {
    return need;
  }

  private static double megabytesToGive(double neededBytes) {
    return Math.ceil(neededBytes / MIB * SLACK / ROUNDING_MIB) * ROUNDING_MIB;
  }
}
