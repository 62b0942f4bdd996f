package org.hdispatch.lbm.immersed;

/** A free body was thrown out of space, or its motion is not a number: the flow has blown up. */
public final class LostBodyException extends ArithmeticException {
  private static final long serialVersionUID = 1L;

  LostBodyException(int number, long step, Body body) {
    super(
        "motion of a free body must stay finite: body="
            + number
            + ", step="
            + step
            + ", z="
            + body.z()
            + ", uz="
            + body.uz()
            + ", wz="
            + body.wz());
  }
}
