package org.hdispatch.lbm;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class EquilibriumTest {
  private static final double RHO = 1.02;
  private static final double[] U = {0.03, -0.05, 0.01};

  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void quadraticFormHasDensityMomentumAndMomentumFlux(VelocitySet set) {
    assertEquals(RHO - 1, sum(set, Equilibrium.QUADRATIC, -1, -1), 1e-15);
    for (int a = 0; a < 3; a++) {
      assertEquals(RHO * U[a], sum(set, Equilibrium.QUADRATIC, a, -1), 1e-15);
      for (int b = 0; b < 3; b++) {
        double flux = RHO * U[a] * U[b] + (a == b ? (RHO - 1) / 3 : 0);
        assertEquals(flux, sum(set, Equilibrium.QUADRATIC, a, b), 1e-15);
      }
    }
  }

  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void linearFormTakesTheMomentumAndHasNoInertia(VelocitySet set) {
    assertEquals(RHO - 1, sum(set, Equilibrium.LINEAR, -1, -1), 1e-15);
    for (int a = 0; a < 3; a++) {
      assertEquals(U[a], sum(set, Equilibrium.LINEAR, a, -1), 1e-15);
      for (int b = 0; b < 3; b++) {
        assertEquals(a == b ? (RHO - 1) / 3 : 0, sum(set, Equilibrium.LINEAR, a, b), 1e-15);
      }
    }
  }

  @Test
  void restIsAllZeros() {
    for (VelocitySet set : VelocitySet.values()) {
      for (int i = 0; i < set.size(); i++) {
        assertEquals(0, Equilibrium.QUADRATIC.deviation(set, i, 1, 0, 0, 0));
        assertEquals(0, Equilibrium.LINEAR.deviation(set, i, 1, 0, 0, 0));
      }
    }
  }

  private static double sum(VelocitySet set, Equilibrium form, int a, int b) {
    double sum = 0;
    for (int i = 0; i < set.size(); i++) {
      double f = form.deviation(set, i, RHO, U[0], U[1], U[2]);
      sum += f * component(set, i, a) * component(set, i, b);
    }
    return sum;
  }

  private static double component(VelocitySet set, int i, int axis) {
    return switch (axis) {
      case 0 -> set.cx(i);
      case 1 -> set.cy(i);
      case 2 -> set.cz(i);
      default -> 1;
    };
  }
}
