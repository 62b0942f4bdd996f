package org.hdispatch.sph;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class PairForcesTest {
  private static final SmoothingKernel PLANE = new QuinticSpline(1, 2);
  private static final SmoothingKernel SPACE = new QuinticSpline(1, 3);
  private static final EquationOfState STATE = EquationOfState.linear(1, 4, 0);

  @Test
  void profileIsTheFunctionGiven() {
    PairProfile cosine = PairProfile.cosine();
    for (double q = 0; q <= 1; q += 0.01) {
      assertEquals(Math.cos(1.5 * Math.PI * q), cosine.at(q), 1e-8);
    }
    assertEquals(0, Math.abs(cosine.at(1)));
    assertEquals(0, Math.abs(cosine.at(7)));
  }

  @Test
  void profilesThatCannotBeFollowedAreRefused() {
    String end =
        assertThrows(IllegalArgumentException.class, () -> PairProfile.of("step", q -> 1))
            .getMessage();
    assertEquals("profile must vanish at the end of the support: profile=step, f(1)=1.0", end);
    String kink =
        assertThrows(
                IllegalArgumentException.class,
                () -> PairProfile.of("tent", q -> 0.5 - Math.abs(q - 0.5)))
            .getMessage();
    assertTrue(kink.startsWith("profile must be as smooth as a polynomial: profile=tent"), kink);
  }

  /** The factors of the cosine, by integration by parts. */
  @Test
  void meanFieldOfTheCosineIsKnown() {
    double a = 1.5 * Math.PI;
    MeanField plane = MeanField.onLattice(PLANE, 1, PairProfile.cosine());
    MeanField space = MeanField.onLattice(SPACE, 1, PairProfile.cosine());
    assertEquals(
        81 / 3.0 * (1 / a - 6 / Math.pow(a, 3) - 6 / Math.pow(a, 4)) * 4,
        plane.surfaceTension(3, 2, 0.5),
        1e-7);
    assertEquals(
        243 * Math.PI / 8 * (1 / a - 12 / Math.pow(a, 3) + 24 / Math.pow(a, 5)) * 4,
        space.surfaceTension(3, 2, 0.5),
        1e-7);
    assertEquals(27 * Math.PI / 2 * (2 / Math.pow(a, 3) - 1 / a), plane.virialPressure(1), 1e-7);
    assertEquals(-0.2989 * 81, space.virialPressure(1), 1e-4 * 81);
  }

  @ParameterizedTest
  @CsvSource({"0, 1", "60, 0.75", "90, 0.5", "120, 0.25", "180, 0"})
  void strengthsAreThoseOfTensionAndAngle(double angle, double ratio) {
    MeanField field = MeanField.onLattice(SPACE, 0.5, PairProfile.cosine());
    PairForces drop = field.drop(0.07, angle);
    assertEquals(0.07, field.surfaceTension(drop.strength(0, 0), 0, 0), 1e-15);
    assertEquals(ratio * drop.strength(0, 0), drop.strength(0, 1), 1e-15);
    PairForces two = field.twoFluids(0.07, angle);
    double saa = two.strength(0, 0);
    double sbb = two.strength(1, 1);
    assertEquals(0.07, field.surfaceTension(saa, sbb, two.strength(0, 1)), 1e-15);
    double young =
        (sbb - saa + 2 * (two.strength(0, 2) - two.strength(1, 2)))
            / (saa + sbb - 2 * two.strength(0, 1));
    assertEquals(Math.cos(Math.toRadians(angle)), young, 1e-14);
  }

  private static SphSchemeBuilder plane(double edge, PairForces forces) {
    return SphScheme.builder(ParticleBox.plane(edge, edge, Ends.PERIODIC, Ends.PERIODIC), PLANE)
        .phase(Phase.fluid("drop", 1, 0.1, STATE))
        .pairForces(forces)
        .timeStep(0.01);
  }

  @ParameterizedTest
  @CsvSource({"2.4, 1", "0.6, -1"})
  void likeParticlesAttractEachOtherAtADistanceAndRepelNearBy(double distance, double sign) {
    MeanField field = MeanField.onLattice(PLANE, 1, PairProfile.cosine());
    Particles two = new Particles().add(0, 5, 5, 0).add(0, 5 + distance, 5, 0);
    EquationOfState none = EquationOfState.withoutTension(STATE);
    SphScheme scheme =
        SphScheme.builder(ParticleBox.plane(12, 12, Ends.PERIODIC, Ends.PERIODIC), PLANE)
            .phase(Phase.fluid("drop", 1, 0.1, none))
            .pairForces(field.drop(1))
            .timeStep(0.01)
            .build(two);
    double[][] after = run(scheme, 1, 1, 2);
    double s = field.drop(1).strength(0, 0);
    double expected = -0.01 * s * Math.cos(1.5 * Math.PI * distance / 3); // dt F/m
    assertEquals(expected, after[0][3], 1e-8 * s);
    assertEquals(-expected, after[1][3], 1e-8 * s);
    assertEquals(sign, Math.signum(after[0][3]));
  }

  private static double[][] run(SphScheme scheme, int workers, int steps, int count) {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(workers)) {
      dispatcher.loop(scheme).run(steps);
    }
    double[][] state = new double[count][];
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) -> state[id] = new double[] {x, y, z, u, v, w, n, p});
    return state;
  }

  private static Particles shaken(int n) {
    Random random = new Random(3);
    Particles particles = new Particles();
    for (int k = 0; k < n; k++) {
      for (int j = 0; j < n; j++) {
        for (int i = 0; i < n; i++) {
          particles.add(
              (i + j) % 3 == 0 ? 1 : 0,
              i + 0.3 + 0.4 * random.nextDouble(),
              j + 0.3 + 0.4 * random.nextDouble(),
              k + 0.3 + 0.4 * random.nextDouble());
        }
      }
    }
    return particles;
  }

  private static SphSchemeBuilder twoPhases(int n, double viscosity) {
    double[][] strengths = {{0.3, 0.1}, {0.1, 0.2}};
    return twoPhasesWithoutForces(n, viscosity)
        .pairForces(new PairForces(PairProfile.cosine(), strengths));
  }

  private static SphSchemeBuilder twoPhasesWithoutForces(int n, double viscosity) {
    return SphScheme.builder(
            ParticleBox.space(n, n, n, Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC), SPACE)
        .phase(Phase.fluid("oil", 1, 0.2, STATE))
        .phase(Phase.fluid("water", 2, viscosity, EquationOfState.beside(STATE, 2)))
        .timeStep(0.01);
  }

  /** What pair forces add to a step, against the sums over all pairs as the formulas stand. */
  @ParameterizedTest
  @CsvSource({"DOUBLE, 0.2", "SINGLE, 0.2", "VERLET, 0.2", "DOUBLE, 0.5", "VERLET, 0.5"})
  void forcesAndVirialAreThoseOfTheFormulas(SearchMode mode, double viscosity) {
    int n = 7;
    Particles particles = shaken(n);
    int count = particles.count();
    double[][] with = run(twoPhases(n, viscosity).search(mode).build(particles), 2, 1, count);
    PairForces none = new PairForces(PairProfile.cosine(), new double[2][2]);
    double[][] without =
        run(twoPhases(n, viscosity).search(mode).pairForces(none).build(particles), 2, 1, count);
    double[][] strengths = {{0.3, 0.1}, {0.1, 0.2}};
    for (int i = 0; i < count; i++) {
      double[] force = new double[3];
      double virial = 0;
      for (int j = 0; j < count; j++) {
        double dx = Math.IEEEremainder(particles.x(i) - particles.x(j), n);
        double dy = Math.IEEEremainder(particles.y(i) - particles.y(j), n);
        double dz = Math.IEEEremainder(particles.z(i) - particles.z(j), n);
        double r = Math.sqrt(dx * dx + dy * dy + dz * dz);
        if (i == j || r >= 3) {
          continue;
        }
        double f =
            strengths[particles.phase(i)][particles.phase(j)] * Math.cos(1.5 * Math.PI * r / 3);
        force[0] += f * dx / r;
        force[1] += f * dy / r;
        force[2] += f * dz / r;
        virial += f * r;
      }
      double mass = particles.phase(i) + 1;
      for (int q = 0; q < 3; q++) {
        // the profile is a polynomial, to 1e-8
        assertEquals(force[q] / mass * 0.01, with[i][3 + q] - without[i][3 + q], 1e-8);
      }
      assertEquals(with[i][6] * virial / 6, with[i][7] - without[i][7], 1e-7);
    }
  }

  @ParameterizedTest
  @EnumSource(SearchMode.class)
  void sameBitsForAnyWorkerCount(SearchMode mode) {
    Particles particles = shaken(10);
    double[][] one =
        run(twoPhases(10, 0.5).search(mode).build(particles), 1, 40, particles.count());
    for (int workers : new int[] {2, 3}) {
      double[][] many =
          run(twoPhases(10, 0.5).search(mode).build(particles), workers, 40, particles.count());
      for (int i = 0; i < one.length; i++) {
        assertArrayEquals(one[i], many[i]);
      }
    }
  }

  @Test
  void momentumIsConserved() {
    Particles particles = shaken(8);
    double[][] after = run(twoPhases(8, 0.5).build(particles), 2, 300, particles.count());
    for (int q = 3; q < 6; q++) {
      double sum = 0;
      double size = 0;
      for (int i = 0; i < after.length; i++) {
        double momentum = (particles.phase(i) + 1) * after[i][q];
        sum += momentum;
        size += Math.abs(momentum);
      }
      assertTrue(size > 1, "particles move");
      assertEquals(0, sum, 1e-11 * size); // round-off
    }
  }

  @Test
  void whatIsWrongIsRefusedInOneLine() {
    MeanField field = MeanField.onLattice(PLANE, 1, PairProfile.cosine());
    refused("surface tension must be positive and finite: sigma=0.0", () -> field.drop(0));
    refused(
        "contact angle must lie between 0 and 180 degrees: angle=190.0", () -> field.drop(1, 190));
    refused(
        "pair strengths must be finite and symmetric: s(0, 1)=1.0",
        () -> new PairForces(PairProfile.cosine(), new double[][] {{1, 1}, {2, 1}}));
    Particles particles = new Particles().add(0, 5, 5, 0);
    refused(
        "pair strengths must be given for the scheme's phases: strengths=2, phases=1",
        () -> plane(12, field.twoFluids(1)).build(particles));
    PairForces strong = field.drop(5000);
    String message =
        assertThrows(IllegalArgumentException.class, () -> plane(12, strong).build(particles))
            .getMessage();
    assertTrue(
        message.matches(
            "time step must resolve pairwise forces and capillary waves: dt=0.01,"
                + " allowed=0.001\\d*, sigma=(5000.0|4999.9)\\d*"),
        message);
  }

  private static void refused(String message, Runnable action) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, action::run).getMessage());
  }

  @Test
  void limitsOfTheTimeStepAreThoseOfTensionAndForce() {
    MeanField field = MeanField.onLattice(PLANE, 1, PairProfile.cosine());
    Phase phase = Phase.fluid("drop", 1, 0.1, STATE);
    TimeStep limits = TimeStep.of(PLANE, List.of(phase), 0, field.drop(20));
    assertEquals(0.25 * Math.sqrt(1 / (40 * Math.PI)), limits.capillary(), 1e-12);
    double s = field.drop(20).strength(0, 0);
    // mean of the force of a half-plane: 2 n s H^2 times the integral of q cos(3 pi q/2)
    double force = 2 * s * 9 * (1 / (1.5 * Math.PI) + 1 / Math.pow(1.5 * Math.PI, 2));
    assertEquals(0.25 / Math.sqrt(force), limits.pair(), 1e-7);
    assertEquals("capillary waves", limits.rules());
    // two fluids, the second of twice as many particles: what pulls is the other one
    Phase fine = Phase.fluid("fine", 0.5, 0.1, STATE);
    PairForces across = new PairForces(PairProfile.cosine(), new double[][] {{0, s}, {s, 0}});
    TimeStep two = TimeStep.of(PLANE, List.of(phase, fine), 0, across);
    assertEquals(0.25 / Math.sqrt(2 * force), two.pair(), 1e-7);
  }

  /** Eight bytes a fluid particle, once the virial is there. */
  @Test
  void virialIsHeldToo() {
    Particles particles = shaken(8);
    SphScheme scheme = twoPhases(8, 0.5).build(particles);
    long before = scheme.bytes();
    run(scheme, 1, 1, particles.count());
    SphScheme without = twoPhasesWithoutForces(8, 0.5).build(particles);
    run(without, 1, 1, particles.count());
    assertTrue(before < scheme.bytes());
    assertTrue(scheme.bytes() - without.bytes() >= (long) Double.BYTES * particles.count());
  }
}
