package org.hdispatch.sph.vector;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.sph.CubicSpline;
import org.hdispatch.sph.EquationOfState;
import org.hdispatch.sph.ParticleBox;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.Phase;
import org.hdispatch.sph.QuinticSpline;
import org.hdispatch.sph.SearchMode;
import org.hdispatch.sph.SmoothingKernel;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.SumForm;
import org.hdispatch.sph.ViscosityMean;
import org.hdispatch.sph.WendlandC2;
import org.hdispatch.sph.cases.PeriodicShear;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** The sums as a scheme calls them: all kernels, searches and models in turn, in one JVM. */
class VectorSchemeTest {
  private static final int EDGE = 12; // of the box, in spacings
  private static final int LAYER = 3; // of solid on either side
  private static final int HIGH = EDGE - LAYER;

  /** What a scheme may be: walls, or two fluids, or neither. */
  private record Case(
      SmoothingKernel kernel, SearchMode search, ViscosityMean mean, boolean walled, int fluids) {
    SphScheme scheme(SumForm form, double cellEdge) {
      ParticleBox box =
          ParticleBox.space(EDGE, EDGE, EDGE, Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC);
      EquationOfState state = EquationOfState.linear(1, 0.15, 0);
      Phase water = Phase.fluid("water", 1, 0.01, state);
      SphSchemeBuilder builder =
          SphScheme.builder(box, kernel)
              .phase(water)
              .search(search)
              .skin(0.3)
              .cellEdge(cellEdge)
              .viscosityMean(mean)
              .timeStep(1)
              .form(form);
      if (walled) {
        builder.phase(Phase.wallOf(water)).walls((x, y, z) -> Math.min(y - LAYER, HIGH - y));
      } else if (fluids == 2) {
        builder.phase(Phase.fluid("oil", 1, 0.02, state));
      }
      return builder.build(particles());
    }

    private int phase(int y) {
      boolean other = walled ? y < LAYER || y >= HIGH : y < EDGE / 2;
      return other && (walled || fluids == 2) ? 1 : 0;
    }

    private Particles particles() {
      Random random = new Random(2007);
      Particles particles = new Particles();
      for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
        int y = n / EDGE % EDGE;
        int phase = phase(y);
        boolean solid = walled && phase == 1;
        particles.add(
            phase,
            place(n % EDGE, random, solid),
            place(y, random, solid),
            place(n / EDGE / EDGE, random, solid),
            solid ? 0 : 0.015 * Math.sin(2 * Math.PI * (y + 0.5) / EDGE),
            0,
            0);
      }
      return particles;
    }

    private static double place(int n, Random random, boolean solid) {
      return n + 0.5 + (solid ? 0 : 0.05 * (2 * random.nextDouble() - 1));
    }
  }

  static List<Case> cases() {
    List<Case> cases = new ArrayList<>();
    for (SearchMode search : SearchMode.values()) {
      for (SmoothingKernel kernel :
          new SmoothingKernel[] {
            new QuinticSpline(1, 3), new CubicSpline(1.5, 3), new WendlandC2(1.5, 3)
          }) {
        cases.add(new Case(kernel, search, ViscosityMean.ARITHMETIC, false, 1));
        for (ViscosityMean mean : ViscosityMean.values()) {
          cases.add(new Case(kernel, search, mean, false, 2));
          cases.add(new Case(kernel, search, mean, true, 1));
        }
      }
    }
    return cases;
  }

  @ParameterizedTest
  @MethodSource("cases")
  void comesToAllocateNothing(Case of) {
    comesToAllocateNothing(of.scheme(SumForm.VECTOR, 3.4), 1);
  }

  @ParameterizedTest
  @EnumSource(SearchMode.class)
  void comesToAllocateNothingInAShearFlow(SearchMode search) {
    for (int workers = 1; workers <= 2; workers++) {
      PeriodicShear shear = new PeriodicShear(EDGE, 3);
      comesToAllocateNothing(
          shear.settings().search(search).form(SumForm.VECTOR).build(shear.particles()), workers);
    }
  }

  /** Arrays grow now and then, less and less; what is boxed is boxed in every step. */
  private static void comesToAllocateNothing(SphScheme scheme, int workers) {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(workers)) {
      TimeLoop loop = dispatcher.loop(scheme);
      assertTrue(loop.warmUp(20, 40), () -> scheme + ": " + loop.stats());
    }
  }

  /** All that lists neighbours for several steps, and walls where they are listed in each. */
  static List<Case> casesToCompare() {
    return cases().stream()
        .filter(
            of ->
                of.search() == SearchMode.VERLET
                    || (of.walled() && of.kernel() instanceof QuinticSpline))
        .toList();
  }

  @ParameterizedTest
  @MethodSource("casesToCompare")
  void sameBitsAsThePlainSums(Case of) {
    double cellEdge = of.walled() ? 3.4 : 6;
    double[] plain = after(50, of.scheme(SumForm.SCALAR, cellEdge));
    assertEquals(8 * EDGE * EDGE * EDGE, plain.length);
    assertTrue(Arrays.stream(plain).allMatch(Double::isFinite));
    assertArrayEquals(plain, after(50, of.scheme(SumForm.VECTOR, cellEdge))); // bit by bit
  }

  private static double[] after(int steps, SphScheme scheme) {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      dispatcher.loop(scheme).run(steps);
    }
    double[] all = new double[8 * scheme.particles()];
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) -> {
          double[] values = {x, y, z, u, v, w, n, p};
          System.arraycopy(values, 0, all, 8 * id, 8);
        });
    return all;
  }
}
