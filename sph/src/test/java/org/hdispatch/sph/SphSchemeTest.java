package org.hdispatch.sph;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.KernelException;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.sph.cases.PeriodicShear;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class SphSchemeTest {
  private static final double MU = 0.7;
  private static final double SOUND = 3;

  private static final EquationOfState STATE = EquationOfState.linear(1, SOUND, 0.3);

  /** A box of n^3 particles near a lattice of spacing 1, in motion. */
  private static Particles shaken(int n, double by) {
    Random random = new Random(7);
    Particles particles = new Particles();
    for (int k = 0; k < n; k++) {
      for (int j = 0; j < n; j++) {
        for (int i = 0; i < n; i++) {
          particles.add(
              0,
              i + 0.5 + by * (random.nextDouble() - 0.5),
              j + 0.5 + by * (random.nextDouble() - 0.5),
              k + 0.5 + by * (random.nextDouble() - 0.5),
              Math.sin(2 * Math.PI * (j + 0.5) / n),
              0.5 * Math.cos(2 * Math.PI * (k + 0.5) / n),
              random.nextDouble() - 0.5);
        }
      }
    }
    return particles;
  }

  private static SphSchemeBuilder periodic(int n) {
    ParticleBox box = ParticleBox.space(n, n, n, Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC);
    return SphScheme.builder(box, new QuinticSpline(1, 3))
        .phase(Phase.fluid("water", 1, MU, STATE))
        .timeStep(0.02);
  }

  /** State by particle: place, velocity, density, pressure. */
  private static double[][] state(SphScheme scheme, int count) {
    double[][] state = new double[count][];
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) -> state[id] = new double[] {x, y, z, u, v, w, n, p});
    return state;
  }

  private static double[][] run(SphScheme scheme, int workers, int steps, int count) {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(workers)) {
      dispatcher.loop(scheme).run(steps);
    }
    return state(scheme, count);
  }

  /** At the most that the Courant number may be, and at the limit of viscosity. */
  @Test
  void soundThatCrossesTwoSmoothingLengthsInAStepDiesDown() {
    int n = 8;
    Random random = new Random(2);
    Particles particles = new Particles();
    for (int i = 0; i < n * n * n; i++) {
      double[] v = random.doubles(3, -1e-6, 1e-6).toArray(); // particles stay where they are
      particles.add(0, i % n + 0.5, i / n % n + 0.5, i / (n * n) + 0.5, v[0], v[1], v[2]);
    }
    QuinticSpline kernel = new QuinticSpline(1, 3);
    double mass = 1 / LatticeSum.of(kernel, 1).numberDensity();
    SphScheme scheme =
        SphScheme.builder(
                ParticleBox.space(n, n, n, Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC), kernel)
            .phase(Phase.fluid("water", mass, 1, EquationOfState.linear(1, 16, 0)))
            .courantNumber(2)
            .timeStep(0.125)
            .build(particles);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(scheme);
      loop.run(1);
      double first = scheme.fastest();
      loop.run(200);
      assertTrue(scheme.fastest() < 0.5 * first, first + " " + scheme.fastest());
    }
  }

  /** One step against the sums over all pairs and images, as the formulas stand. */
  @ParameterizedTest
  @EnumSource(SearchMode.class)
  void firstStepIsThatOfTheFormulas(SearchMode mode) {
    int n = 7; // two cells along an axis: a cell and its image are both neighbours
    Particles particles = shaken(n, 0.4);
    double[][] found = run(periodic(n).search(mode).build(particles), 2, 1, particles.count());
    double[][] expected = oneStep(particles, n, 0.02);
    for (int i = 0; i < found.length; i++) {
      for (int q = 0; q < 3; q++) {
        double apart = Math.IEEEremainder(found[i][q] - expected[i][q], n);
        assertEquals(0, apart, 1e-12); // round-off
        assertEquals(expected[i][3 + q], found[i][3 + q], 1e-12);
      }
      assertEquals(expected[i][6], found[i][6], 1e-13);
      assertEquals(expected[i][7], found[i][7], 1e-12);
    }
  }

  private static double[][] oneStep(Particles particles, int n, double dt) {
    SmoothingKernel kernel = new QuinticSpline(1, 3);
    int count = particles.count();
    double[] density = new double[count];
    double[][] result = new double[count][8];
    for (int i = 0; i < count; i++) {
      for (int j = 0; j < count; j++) {
        density[i] += kernel.w(length(apart(particles, i, j, n)));
      }
    }
    for (int i = 0; i < count; i++) {
      double pi = STATE.pressure(density[i]);
      double[] a = new double[3];
      for (int j = 0; j < count; j++) {
        double[] d = apart(particles, i, j, n);
        double r = length(d);
        if (i == j || r >= kernel.supportRadius()) {
          continue;
        }
        double pj = STATE.pressure(density[j]);
        double slope = kernel.dwdr(r) / r;
        double push = -(pi / (density[i] * density[i]) + pj / (density[j] * density[j])) * slope;
        double drag = 2 * MU / (density[i] * density[j]) * slope;
        a[0] += push * d[0] + drag * (particles.u(i) - particles.u(j));
        a[1] += push * d[1] + drag * (particles.v(i) - particles.v(j));
        a[2] += push * d[2] + drag * (particles.w(i) - particles.w(j));
      }
      double[] place = {particles.x(i), particles.y(i), particles.z(i)};
      double[] velocity = {particles.u(i), particles.v(i), particles.w(i)};
      for (int q = 0; q < 3; q++) {
        double half = velocity[q] + a[q] * dt / 2; // the first kick is half a step
        result[i][q] = place[q] + half * dt;
        result[i][3 + q] = half + a[q] * dt / 2;
      }
      result[i][6] = density[i];
      result[i][7] = pi;
    }
    return result;
  }

  /** The nearest image: the support is less than half of the box. */
  private static double[] apart(Particles particles, int i, int j, int n) {
    return new double[] {
      Math.IEEEremainder(particles.x(i) - particles.x(j), n),
      Math.IEEEremainder(particles.y(i) - particles.y(j), n),
      Math.IEEEremainder(particles.z(i) - particles.z(j), n)
    };
  }

  private static double length(double[] d) {
    return Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  }

  @ParameterizedTest
  @EnumSource(SearchMode.class)
  void sameBitsForAnyWorkerCount(SearchMode mode) {
    Particles particles = shaken(12, 0.2);
    double[][] one = run(periodic(12).search(mode).build(particles), 1, 60, particles.count());
    for (int workers : new int[] {2, 3, 5}) {
      double[][] many =
          run(periodic(12).search(mode).build(particles), workers, 60, particles.count());
      for (int i = 0; i < one.length; i++) {
        assertArrayEquals(one[i], many[i]);
      }
    }
  }

  /** Particles cross cells and the ends of the box; lists are made anew several times. */
  @ParameterizedTest
  @CsvSource({"SINGLE, 0", "VERLET, 0", "VERLET, 6", "SINGLE, 4"})
  void modesAndCellsAgree(SearchMode mode, double edge) {
    int n = 12;
    Particles particles = shaken(n, 0.2);
    double[][] expected =
        run(periodic(n).search(SearchMode.DOUBLE).build(particles), 1, 60, particles.count());
    SphSchemeBuilder settings = periodic(n).search(mode);
    SphScheme scheme = (edge == 0 ? settings : settings.cellEdge(edge)).build(particles);
    double[][] found = run(scheme, 2, 60, particles.count());
    for (int i = 0; i < found.length; i++) {
      for (int q = 0; q < 3; q++) {
        // round-off, grown over 60 steps
        assertEquals(0, Math.IEEEremainder(expected[i][q] - found[i][q], n), 1e-9);
        assertEquals(expected[i][3 + q], found[i][3 + q], 1e-9);
      }
    }
    if (mode == SearchMode.VERLET) {
      assertTrue(scheme.rebuilds() > 3 && scheme.rebuilds() < 60, () -> "" + scheme.rebuilds());
    }
  }

  @Test
  void momentumIsConserved() {
    int n = 10;
    Particles particles = shaken(n, 0.3);
    double[][] after = run(periodic(n).build(particles), 2, 1000, particles.count());
    for (int q = 0; q < 3; q++) {
      double before = 0;
      double sum = 0;
      double size = 0;
      for (int i = 0; i < after.length; i++) {
        double u = q == 0 ? particles.u(i) : q == 1 ? particles.v(i) : particles.w(i);
        before += u;
        size += Math.abs(u);
        sum += after[i][3 + q];
      }
      assertEquals(before, sum, 1e-12 * size); // round-off
    }
  }

  @ParameterizedTest
  @EnumSource(SearchMode.class)
  void allocatesNothingOnceGrown(SearchMode mode) {
    PeriodicShear shear = new PeriodicShear(9, 3);
    SphScheme scheme = shear.settings().search(mode).build(shear.particles());
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(scheme);
      loop.run(4000); // no cell holds more than ever before
      assertTrue(loop.warmUp(300, 10), () -> loop.stats().toString());
    }
  }

  /** Against all pairs, at the places before the step. */
  @ParameterizedTest
  @EnumSource(SearchMode.class)
  void countsTheNeighboursOfTheLastStep(SearchMode mode) {
    int n = 7;
    Particles particles = shaken(n, 0.4);
    SphScheme scheme = periodic(n).search(mode).build(particles);
    assertTrue(Double.isNaN(scheme.neighboursMean()));
    run(scheme, 2, 1, particles.count());
    int pairs = 0;
    for (int i = 0; i < particles.count(); i++) {
      for (int j = 0; j < particles.count(); j++) {
        pairs += i != j && length(apart(particles, i, j, n)) < 3 ? 1 : 0;
      }
    }
    assertEquals((double) pairs / particles.count(), scheme.neighboursMean(), 1e-12);
    assertEquals(n * n * n, scheme.particles());
    assertEquals(n * n * n, scheme.fluidParticles());
  }

  /** Nor do cells, nor how near to a wall a particle counts as being. */
  @Test
  void emptyPartsOfTheBoxChangeNothing() {
    double[] low = aboveAWall(9);
    double[] high = aboveAWall(120);
    assertTrue(low[3] < 0.0095, () -> "the wall holds it back: " + low[3]);
    assertArrayEquals(low, high, 1e-15); // round-off
  }

  /** A particle 0.3 above a wall that slides along it, after a step. */
  private static double[] aboveAWall(double height) {
    Particles particles = new Particles().add(0, 6.2, 4.3, 0, 0.01, 0, 0);
    for (int n = 0; n < 4 * 12; n++) {
      particles.add(1, n % 12 + 0.5, n / 12 + 0.5, 0);
    }
    EquationOfState state = EquationOfState.withoutTension(STATE);
    Phase fluid = Phase.fluid("water", 1, MU, state);
    ParticleBox box = ParticleBox.plane(12, height, Ends.PERIODIC, Ends.OPEN);
    SphScheme scheme =
        SphScheme.builder(box, new QuinticSpline(1, 2))
            .phase(fluid)
            .phase(Phase.wallOf(fluid))
            .walls((x, y, z) -> y - 4)
            .timeStep(0.02)
            .build(particles);
    return run(scheme, 1, 1, particles.count())[0];
  }

  @Test
  void holdsAtLeastTheStateOfItsParticlesTwice() {
    Particles particles = shaken(12, 0.2);
    SphScheme scheme = periodic(12).search(SearchMode.DOUBLE).build(particles);
    run(scheme, 1, 1, particles.count());
    double each = (double) scheme.bytes() / particles.count();
    int state = 2 * (9 * Double.BYTES + Integer.BYTES + Byte.BYTES) + 2 * Double.BYTES;
    assertTrue(each > state && each < 2 * state, () -> "" + each); // room to grow, headers
  }

  @Test
  void saysWhichParticleShowsThatItBlowsUp() {
    Particles particles = shaken(7, 0.4);
    SphScheme scheme = periodic(7).build(particles);
    scheme.drive(1e9, 0, 0);
    KernelException thrown =
        assertThrows(KernelException.class, () -> run(scheme, 1, 9, particles.count()));
    assertInstanceOf(BlownUpException.class, thrown.getCause());
    assertTrue(thrown.getCause().getMessage().contains("particle="), thrown.getMessage());
  }
}
