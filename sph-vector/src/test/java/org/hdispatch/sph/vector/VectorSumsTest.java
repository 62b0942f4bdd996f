package org.hdispatch.sph.vector;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.hdispatch.gc.AllocationMeter;
import org.hdispatch.sph.CubicSpline;
import org.hdispatch.sph.NeighbourList;
import org.hdispatch.sph.Neighbourhood;
import org.hdispatch.sph.PairModel;
import org.hdispatch.sph.PairSums;
import org.hdispatch.sph.Phase;
import org.hdispatch.sph.QuinticSpline;
import org.hdispatch.sph.SmoothingKernel;
import org.hdispatch.sph.SumForm;
import org.hdispatch.sph.ViscosityMean;
import org.hdispatch.sph.WendlandC2;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class VectorSumsTest {
  private static final double REACH = 1.1; // supports are 1

  @Test
  void areFoundWhereTheModuleIs() {
    VectorSumsProvider provider = new VectorSumsProvider();
    assertTrue(provider.available());
    for (PairModel model : models()) {
      assertTrue(provider.serves(model.kernel()));
      assertEquals(SumForm.VECTOR, SumForm.fastest(model.kernel()));
    }
  }

  static List<PairModel> models() {
    List<PairModel> models = new ArrayList<>();
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
      for (SmoothingKernel kernel :
          new SmoothingKernel[] {
            new QuinticSpline(1 / 3.0, dimensions),
            new CubicSpline(0.5, dimensions),
            new WendlandC2(0.5, dimensions)
          }) {
        models.add(new PairModel(kernel, ViscosityMean.ARITHMETIC, 0.7, false, 1.5));
        for (ViscosityMean mean : ViscosityMean.values()) {
          models.add(new PairModel(kernel, mean, Double.NaN, true, 1.5));
        }
      }
    }
    return models;
  }

  /** Neighbourhoods of all sizes, their last quad full or not; the cell's own anywhere in them. */
  @ParameterizedTest
  @MethodSource("models")
  void sameBitsAsThePlainSums(PairModel model) {
    Random random = new Random(2005);
    PairSums plain = SumForm.SCALAR.of(model).get();
    PairSums vectors = SumForm.VECTOR.of(model).get();
    int listed = 0;
    for (int count : new int[] {1, 2, 3, 4, 5, 8, 31, 64, 150, 601}) {
      for (int ownCount : new int[] {0, 1, Math.min(count, 13), count}) {
        int own = random.nextInt(count - ownCount + 1);
        int fluids = random.nextInt(ownCount + 1);
        Neighbourhood near =
            near(random, model.kernel().dimensions(), count, own, ownCount, fluids);
        String text = "count=" + count + ", own=" + own + ", ownCount=" + ownCount;
        NeighbourList list = new NeighbourList();
        NeighbourList found = new NeighbourList();
        plain.search(near, REACH, list);
        vectors.search(near, REACH, found);
        int[] first = Arrays.copyOf(list.first(), ownCount + 1);
        assertArrayEquals(first, Arrays.copyOf(found.first(), ownCount + 1), text);
        listed += first[ownCount];
        assertArrayEquals(
            Arrays.copyOf(list.quads(), first[ownCount]),
            Arrays.copyOf(found.quads(), first[ownCount]),
            text);
        double[][] expected = new double[5][ownCount];
        plain.density(near, list, expected[0]);
        plain.force(near, list, expected[1], expected[2], expected[3], expected[4]);
        double[][] sums = new double[5][ownCount];
        vectors.density(near, list, sums[0]);
        vectors.force(near, list, sums[1], sums[2], sums[3], sums[4]);
        for (int n = 0; n < 5; n++) {
          assertArrayEquals(expected[n], sums[n], text); // bit by bit
        }
      }
    }
    assertTrue(listed > 10000, "listed=" + listed);
  }

  /** Particles in a box with some outside of each other's reach; two stand at the same place. */
  private static Neighbourhood near(
      Random random, int dimensions, int count, int own, int ownCount, int fluids) {
    double[][] planes = new double[Neighbourhood.PHASE][count];
    for (double[] plane : planes) {
      Arrays.setAll(plane, n -> 0.5 + random.nextDouble());
    }
    double edge = 3;
    for (int axis = 0; axis < 3; axis++) {
      boolean flat = axis >= dimensions;
      Arrays.setAll(planes[axis], n -> flat ? 0.25 : edge * random.nextDouble());
      planes[axis][count - 1] = planes[axis][0];
    }
    Arrays.setAll(planes[Neighbourhood.DEPTH], n -> n % 3 == 0 ? random.nextDouble() : 0);
    for (int n = 0; n < count; n += 3) {
      if (n < own || n >= own + fluids) {
        planes[Neighbourhood.VISCOSITY][n] = Phase.TOUCHED;
      }
    }
    double[] nearness = new double[fluids];
    Arrays.setAll(nearness, n -> 4 * random.nextDouble());
    return Neighbourhood.of(planes, own, ownCount, nearness);
  }

  /** Once C2 has compiled them no vector is boxed, though all kernels take turns in one JVM. */
  @ParameterizedTest
  @MethodSource("models")
  void allocateNothingOnceCompiled(PairModel model) {
    int own = 20;
    Neighbourhood near = near(new Random(2006), model.kernel().dimensions(), 400, 190, own, own);
    PairSums vectors = SumForm.VECTOR.of(model).get();
    NeighbourList list = new NeighbourList();
    double[][] sums = new double[5][own];
    comesToAllocateNothing(() -> vectors.search(near, REACH, list), model + " search");
    comesToAllocateNothing(() -> vectors.density(near, list, sums[0]), model + " density");
    comesToAllocateNothing(
        () -> vectors.force(near, list, sums[1], sums[2], sums[3], sums[4]), model + " force");
  }

  private static void comesToAllocateNothing(Runnable work, String text) {
    AllocationMeter meter = new AllocationMeter(Thread.currentThread().getId());
    long[] before = new long[1];
    long[] after = new long[1];
    long bytes = Long.MAX_VALUE;
    for (int batch = 0; batch < 2000 && bytes > 0; batch++) { // compiling takes tens of batches
      meter.read(before);
      for (int n = 0; n < 100; n++) {
        work.run();
      }
      meter.read(after);
      bytes = after[0] - before[0];
    }
    assertEquals(0, bytes, text);
  }
}
