package org.hdispatch.lbm;

/** The precision in which populations are stored and collided. */
public enum Storage {
  /** 8 bytes a population. */
  DOUBLE(Double.BYTES),
  /**
   * 4 bytes a population, half the memory and half the traffic. Stored as deviations from their
   * weights, populations lose little: each is rounded to 24 bits of a small number.
   */
  SINGLE(Float.BYTES);

  private final int bytes;

  Storage(int bytes) {
    this.bytes = bytes;
  }

  /** Bytes of a population. */
  public int bytes() {
    return bytes;
  }
}
