package org.hdispatch.lbm;

/**
 * Where the populations stand between two steps, and so which slots the next step reads and writes:
 * the nodes' own or those of their neighbours ({@link StreamPlan}).
 */
final class Phase {
  private final Streaming streaming;
  private int previous;
  private boolean streamed;

  /** That before the first step. */
  Phase(Streaming streaming) {
    this.streaming = streaming;
    streamed = streaming == Streaming.PUSH;
  }

  /** The copy that holds the populations. */
  int previous() {
    return previous;
  }

  /** The copy that the next step writes; in place, the previous one. */
  int current() {
    return (previous + 1) % streaming.copies();
  }

  /** Whether what left a node stands where it arrives next, in the slots of the neighbours. */
  boolean streamed() {
    return streamed;
  }

  /** Whether the next step reads the slots of the neighbours; else it reads the nodes' own. */
  boolean readsNeighbours() {
    return streaming == Streaming.PULL || exchanges();
  }

  /** Whether the next step writes the slots of the neighbours; else it writes the nodes' own. */
  boolean writesNeighbours() {
    return streaming == Streaming.PUSH || exchanges();
  }

  /** Whether the next step is in place and not local. */
  private boolean exchanges() {
    return streaming == Streaming.IN_PLACE && !streamed;
  }

  /** The next step has been made. */
  void advance() {
    streamed = writesNeighbours();
    previous = current();
  }
}
