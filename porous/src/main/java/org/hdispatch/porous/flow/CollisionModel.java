package org.hdispatch.porous.flow;

import org.hdispatch.lbm.Relaxation;

/** How populations relax. */
public enum CollisionModel {
  /** Two relaxation times, magic number 3/16: k does not depend on tau. */
  TRT,
  /** One relaxation time: k drifts with tau, for comparison with other codes. */
  BGK;

  /**
   * The relaxation rates at this tau.
   *
   * @throws IllegalArgumentException if {@code relaxationTime} is not a finite number above 0.5
   */
  public Relaxation at(double relaxationTime) {
    return this == TRT ? Relaxation.trt(relaxationTime) : Relaxation.bgk(relaxationTime);
  }
}
