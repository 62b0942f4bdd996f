package org.hdispatch.lbm.immersed;

import org.hdispatch.lbm.Relaxation;

/** What is said of immersed bodies, beside the way: see {@link Refusal}. */
final class Caution {
  private Caution() {}

  static String title(int bodies) {
    return bodies + " immersed bodies";
  }

  static String of(Relaxation relaxation) {
    double tau = relaxation.relaxationTime();
    if (tau > 0.7 || tau < 0.55) {
      return "immersed moving boundaries are right at tau near 0.6; permeability is 7 to 13 % high at"
          + " tau 1, 31 to 59 % at tau 2, 1 to 4 % low at tau 0.53: tau="
          + tau;
    }
    return relaxation.omegaPlus() == relaxation.omegaMinus()
        ? ""
        : "immersed moving boundaries are right with one relaxation time, 3 to 8 % high in"
            + " permeability with two at magic number 3/16 and tau 0.6: omega+="
            + relaxation.omegaPlus()
            + ", omega-="
            + relaxation.omegaMinus();
  }
}
