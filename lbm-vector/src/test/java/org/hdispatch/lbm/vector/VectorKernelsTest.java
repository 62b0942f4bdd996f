package org.hdispatch.lbm.vector;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.hdispatch.lbm.BodyForce;
import org.hdispatch.lbm.Collision;
import org.hdispatch.lbm.CollisionKernel;
import org.hdispatch.lbm.Equilibrium;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.Relaxation;
import org.hdispatch.lbm.VelocitySet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class VectorKernelsTest {
  private static final int ROWS = 3;
  private static final int PITCH = 41;
  private static final int LENGTH = 200;

  @Test
  void areFoundWhereTheModuleIs() {
    assertTrue(new VectorKernels().available());
    assertEquals(KernelForm.VECTOR, KernelForm.fastest());
  }

  /** Row lengths of no vector, of one with and without nodes left over, and of several. */
  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void sameBitsAsTheReference(VelocitySet set) {
    for (Equilibrium equilibrium : Equilibrium.values()) {
      for (double tau : new double[] {0.51, 1, 7}) {
        Collision collision =
            new Collision(set, Relaxation.trt(tau), equilibrium, new BodyForce(1e-3, -2e-3, 5e-4));
        CollisionKernel vectors = new VectorKernels().kernel(collision.coefficients());
        CollisionKernel reference = KernelForm.REFERENCE.kernels().kernel(collision.coefficients());
        for (int n : new int[] {1, 7, 8, 9, 16, 41}) {
          for (boolean inPlace : new boolean[] {true, false}) {
            String text = set + " " + equilibrium + " tau=" + tau + " n=" + n + " " + inPlace;
            double[][] expected = collideDouble(reference, set, n, inPlace);
            double[][] found = collideDouble(vectors, set, n, inPlace);
            for (int i = 0; i < set.size(); i++) {
              assertArrayEquals(expected[i], found[i], text);
            }
            float[][] expectedSingle = collideSingle(reference, set, n, inPlace);
            float[][] foundSingle = collideSingle(vectors, set, n, inPlace);
            for (int i = 0; i < set.size(); i++) {
              assertArrayEquals(expectedSingle[i], foundSingle[i], text);
            }
          }
        }
      }
    }
  }

  private static double[][] collideDouble(
      CollisionKernel kernel, VelocitySet set, int n, boolean inPlace) {
    Random random = new Random(2011);
    double[][] in = new double[set.size()][LENGTH];
    int[] at = new int[set.size()];
    for (int i = 0; i < set.size(); i++) {
      at[i] = i;
      for (int k = 0; k < LENGTH; k++) {
        in[i][k] = 0.02 * (random.nextDouble() - 0.3);
      }
    }
    double[][] out = inPlace ? in : new double[set.size()][LENGTH];
    kernel.collide(in, at, out, inPlace ? at : at.clone(), n, ROWS, PITCH);
    return out;
  }

  private static float[][] collideSingle(
      CollisionKernel kernel, VelocitySet set, int n, boolean inPlace) {
    Random random = new Random(2011);
    float[][] in = new float[set.size()][LENGTH];
    int[] at = new int[set.size()];
    for (int i = 0; i < set.size(); i++) {
      at[i] = i;
      for (int k = 0; k < LENGTH; k++) {
        in[i][k] = (float) (0.02 * (random.nextDouble() - 0.3));
      }
    }
    float[][] out = inPlace ? in : new float[set.size()][LENGTH];
    kernel.collide(in, at, out, inPlace ? at : at.clone(), n, ROWS, PITCH);
    return out;
  }
}
