package org.hdispatch.lbm;

/**
 * How populations move from node to node. The three give the same bits; they differ in memory and
 * in the bytes that a step moves.
 */
public enum Streaming {
  /**
   * One copy of the populations, in place (the AA pattern: Bailey, Myre, Walsh, Lilja, Saar,
   * International Conference on Parallel Processing 2009, 550): every second step is local to the
   * nodes; in the steps between each node reads from and writes to its neighbours' slots, those
   * that it alone uses. 2 Q numbers moved a node and step.
   */
  IN_PLACE(1),
  /** Two copies; a step reads the neighbours' previous populations: stream, then collide. */
  PULL(2),
  /** Two copies; a step writes the neighbours' current populations: collide, then stream. */
  PUSH(2);

  private final int copies;

  Streaming(int copies) {
    this.copies = copies;
  }

  /** Copies of the populations held. */
  public int copies() {
    return copies;
  }
}
