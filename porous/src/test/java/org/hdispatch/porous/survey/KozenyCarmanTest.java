package org.hdispatch.porous.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class KozenyCarmanTest {
  private static final double[] POROSITY = {0.1, 0.2, 0.3, 0.4};

  private static double[] onCurve(double constant) {
    double[] k = new double[POROSITY.length];
    for (int n = 0; n < k.length; n++) {
      k[n] = constant * Math.pow(POROSITY[n], 3) / Math.pow(1 - POROSITY[n], 2);
    }
    return k;
  }

  @Test
  void pointsOnTheCurveGiveItsConstantWithoutAnError() {
    KozenyCarman fit = KozenyCarman.fit(POROSITY, onCurve(5000)).orElseThrow();
    assertEquals(4, fit.points());
    assertEquals(5000, fit.constant(), 1e-9);
    assertEquals(0, fit.error(), 1e-14);
    assertEquals(5000 * 0.008 / 0.64, fit.permeability(0.2), 1e-9);
  }

  /** Twice up and twice down by a factor e: deviation sqrt(4/3), error sqrt(4/3)/2. */
  @Test
  void errorIsThatOfTheMeanLogarithm() {
    double[] k = onCurve(5000);
    for (int n = 0; n < k.length; n++) {
      k[n] *= n % 2 == 0 ? Math.E : 1 / Math.E;
    }
    KozenyCarman fit = KozenyCarman.fit(POROSITY, k).orElseThrow();
    assertEquals(5000, fit.constant(), 1e-9);
    assertEquals(Math.sqrt(4.0 / 3), fit.scatter(), 1e-14);
    assertEquals(Math.sqrt(4.0 / 3) / 2, fit.error(), 1e-14);
  }

  /** A packing of spheres of 100 um: C = d²/180 = 5.556e-11 m², 56 292 mD. */
  @Test
  void constantIsThatOfAPackingOfSpheres() {
    double milliDarcy = 1e-8 / 180 / 9.869233e-16;
    KozenyCarman fit = KozenyCarman.fit(POROSITY, onCurve(milliDarcy)).orElseThrow();
    assertEquals(1e-4, fit.sphereDiameter(), 1e-15);
  }

  @Test
  void zerosHaveNoLogarithmAndAreLeftOut() {
    KozenyCarman fit =
        KozenyCarman.fit(new double[] {0.2, 0.2, 0}, new double[] {10, 0, 10}).orElseThrow();
    assertEquals(1, fit.points());
    assertEquals(Double.NaN, fit.error());
    assertTrue(KozenyCarman.fit(new double[] {0.2}, new double[] {0}).isEmpty());
  }
}
