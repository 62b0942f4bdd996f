package org.hdispatch.porous.flow;

/** A computation blew up: a number that must be finite is not. */
public final class DivergedException extends ArithmeticException {
  private static final long serialVersionUID = 1L;

  DivergedException(long step, double relaxationTime) {
    super(
        "permeability must stay finite: step="
            + step
            + ", tau="
            + relaxationTime
            + " (another --tau may help)");
  }
}
