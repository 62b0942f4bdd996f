package org.hdispatch.bench.paper;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.hdispatch.bench.lbm.Ducts;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.lbm.BundleSize;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.VelocitySet;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** All forms that are compared compute the same. */
class PaperFormTest {
  private static final int STEPS = 20;

  @ParameterizedTest
  @EnumSource
  void allHaveTheSameFlow(PaperForm form) {
    double tolerance = form == PaperForm.FLAT_SINGLE ? 1e-6 : 0; // 24 bits, and some rounding
    double expected = flow(PaperForm.FLAT_REFERENCE);
    assertEquals(expected, flow(form), tolerance * expected);
  }

  /** Velocity in the middle of a duct. */
  private static double flow(PaperForm form) {
    Scheme<?, ?> scheme =
        form.scheme(Ducts.square(8), VelocitySet.D3Q15, BundleSize.cube(3), KernelForm.SCALAR);
    try (Stepper stepper = form.start(scheme, 2)) {
      stepper.run(STEPS);
    }
    double[] velocity = new double[1];
    LbmScheme.NodeVisitor visitor =
        (x, y, z, density, ux, uy, uz) -> velocity[0] += x == 4 && y == 4 && z == 4 ? ux : 0;
    if (scheme instanceof LbmScheme flat) {
      flat.forEachNode(visitor);
    } else {
      ((NodeScheme) scheme).forEachNode(visitor);
    }
    return velocity[0];
  }
}
