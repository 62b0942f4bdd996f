package org.hdispatch.lbm.vector;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.gc.AllocationMeter;
import org.hdispatch.lbm.BodyForce;
import org.hdispatch.lbm.Collision;
import org.hdispatch.lbm.CollisionCoefficients;
import org.hdispatch.lbm.CollisionKernel;
import org.hdispatch.lbm.Equilibrium;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.Relaxation;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.lbm.immersed.Body;
import org.hdispatch.lbm.immersed.ImmersedBodies;
import org.hdispatch.lbm.immersed.Path;
import org.hdispatch.lbm.immersed.Point;
import org.hdispatch.lbm.immersed.Sphere;
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
        CollisionCoefficients coefficients = collision.coefficients();
        CollisionKernel reference = KernelForm.REFERENCE.kernels().kernel(coefficients);
        requireSameBits(set, reference, vectors(coefficients).heat(), equilibrium + ", tau=" + tau);
        requireSameBits(set, reference, vectors(coefficients), "cold");
      }
    }
  }

  private static VectorKernel vectors(CollisionCoefficients coefficients) {
    return (VectorKernel) new VectorKernels().kernel(coefficients);
  }

  private static void requireSameBits(
      VelocitySet set, CollisionKernel reference, CollisionKernel vectors, String which) {
    for (int n : new int[] {1, 7, 8, 9, 16, 17, 41}) {
      for (boolean inPlace : new boolean[] {true, false}) {
        String text = set + ", " + which + ", n=" + n + " " + inPlace;
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

  /** Once C2 has compiled them no vector is boxed: neither where nodes stand nor on their way. */
  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void allocateNothingOnceCompiled(VelocitySet set) {
    for (Equilibrium equilibrium : Equilibrium.values()) {
      Collision collision =
          new Collision(set, Relaxation.trt(1), equilibrium, new BodyForce(1e-7, 0, 0));
      CollisionKernel kernel = vectors(collision.coefficients()).heat();
      for (boolean inPlace : new boolean[] {true, false}) {
        double[][] in = new double[set.size()][1000];
        double[][] out = inPlace ? in : new double[set.size()][1000];
        float[][] inSingle = new float[set.size()][1000];
        float[][] outSingle = inPlace ? inSingle : new float[set.size()][1000];
        int[] at = new int[set.size()];
        int[] outAt = inPlace ? at : new int[set.size()];
        String text = set + " " + equilibrium + " in place " + inPlace;
        comesToAllocateNothing(() -> kernel.collide(in, at, out, outAt, 16, 18, 20), text);
        comesToAllocateNothing(
            () -> kernel.collide(inSingle, at, outSingle, outAt, 16, 18, 20), text + " single");
      }
    }
  }

  private static void comesToAllocateNothing(Runnable work, String text) {
    AllocationMeter meter = new AllocationMeter(Thread.currentThread().getId());
    long[] before = new long[1];
    long[] after = new long[1];
    long bytes = Long.MAX_VALUE;
    for (int batch = 0; batch < 2000 && bytes > 0; batch++) { // compiling takes tens of batches
      meter.read(before);
      for (int n = 0; n < 500; n++) {
        work.run();
      }
      meter.read(after);
      bytes = after[0] - before[0];
    }
    assertEquals(0, bytes, text);
  }

  /** A sphere that moves, under a force that changes in every step. */
  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void sameBitsWithABodyUnderAChangingForce(VelocitySet set) {
    for (Equilibrium equilibrium : Equilibrium.values()) {
      assertArrayEquals(
          driven(set, equilibrium, KernelForm.REFERENCE),
          driven(set, equilibrium, KernelForm.VECTOR));
    }
  }

  private static double[] driven(VelocitySet set, Equilibrium equilibrium, KernelForm form) {
    Point start = new Point(5.2, 5.5, 4.9);
    Point velocity = new Point(0.02, 0.01, 0);
    Body body = Body.prescribed(new Sphere(3), Path.straight(start, velocity, Point.ZERO));
    LbmScheme scheme =
        LbmScheme.on(Lattice.empty(40, 11, 10, Ends.PERIODIC, Ends.OPEN, Ends.PERIODIC))
            .velocitySet(set)
            .equilibrium(equilibrium)
            .relaxation(Relaxation.bgk(0.6))
            .immersion(ImmersedBodies.of(body))
            .kernel(form)
            .build();
    double[] state = new double[4 * 40 * 11 * 10];
    int[] at = new int[1];
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(scheme);
      for (int step = 0; step < 50; step++) {
        scheme.drive(new BodyForce(1e-4 * (step % 3), 1e-5 * (step % 5), -1e-5));
        loop.run(1);
      }
    }
    scheme.forEachNode(
        (x, y, z, density, ux, uy, uz) -> {
          state[at[0]++] = density;
          state[at[0]++] = ux;
          state[at[0]++] = uy;
          state[at[0]++] = uz;
        });
    return state;
  }
}
