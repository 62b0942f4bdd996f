package org.hdispatch.sph;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.KernelException;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.sph.cases.Poiseuille;
import org.junit.jupiter.api.Test;

/** Bad set-ups are refused, in one line that names the numbers. */
class SetupCheckTest {
  private static final Poiseuille FLOW = new Poiseuille(6, 0);
  private static final double DX = Poiseuille.GAP / 6;

  private static void refused(SphSchemeBuilder settings, Particles particles, String... texts) {
    String message =
        assertThrows(IllegalArgumentException.class, () -> settings.build(particles)).getMessage();
    assertFalse(message.contains("\n"), message);
    for (String text : texts) {
      assertTrue(message.contains(text), message);
    }
  }

  private static Phase water(double mass) {
    return Phase.fluid("water", mass, 1e-3, EquationOfState.linear(1000, 2.5e-4, 0));
  }

  private static SphSchemeBuilder fluidOnly(double h, double mass, double dt) {
    return SphScheme.builder(FLOW.lattice().box(), new QuinticSpline(h, 2))
        .phase(water(mass))
        .timeStep(dt);
  }

  private static Particles one() {
    return new Particles().add(0, DX, DX, 0);
  }

  /** On a square lattice viscosity is 9.3 % too small at h = 0.7 dx, 15 % at 0.667 dx. */
  @Test
  void smoothingLengthMustHoldNeighbours() {
    for (double h : new double[] {0.5, 0.667}) {
      refused(
          fluidOnly(h * DX, 1000 * DX * DX, 1e-6),
          one(),
          "smoothing length must be long enough",
          "h=" + h * DX,
          "dx=",
          "water",
          "quintic spline");
    }
    fluidOnly(0.7 * DX, 1000 * DX * DX, 1e-6).build(one());
  }

  private static SphSchemeBuilder cube(int edge) {
    ParticleBox box =
        ParticleBox.space(edge, edge, edge, Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC);
    return SphScheme.builder(box, new QuinticSpline(1, 3))
        .phase(Phase.fluid("water", 1, 1, EquationOfState.linear(1, 1, 0)))
        .timeStep(0.1);
  }

  /** Quads of four are numbered by two bytes. */
  @Test
  void cellsMustNotHoldMoreThanListsCanNumber() {
    Particles one = new Particles().add(0, 1, 1, 1);
    refused(
        cube(44).cellEdge(22),
        one,
        "at most 262144 particles",
        "edge=22.0",
        "particles=" + 66 * 66 * 66);
    cube(42).cellEdge(21).build(one); // 63^3
    assertEquals(21, cube(42).cellEdge(21).build(one).cellEdge());
    Neighbourhood near = new Neighbourhood();
    near.clear(Neighbourhood.MOST);
    String message =
        assertThrows(BlownUpException.class, () -> near.clear(Neighbourhood.MOST + 1)).getMessage();
    assertTrue(message.endsWith("particles=262145"), message);
  }

  @Test
  void bodyForceMustBeFinite() {
    String message =
        assertThrows(
                IllegalArgumentException.class, () -> FLOW.settings().bodyForce(0, Double.NaN, 0))
            .getMessage();
    assertEquals("body force must be finite: gy=NaN", message);
    SphScheme scheme = FLOW.scheme();
    assertThrows(
        IllegalArgumentException.class, () -> scheme.drive(Double.POSITIVE_INFINITY, 0, 0));
  }

  @Test
  void particlesMustLieInTheBoxAndBeOfAPhase() {
    Phase water = Phase.fluid("water", 1, 1, EquationOfState.linear(1, 1, 0));
    refused(cube(8), new Particles().add(0, 1, 8, 1), "in the box: particle=0, x=1.0, y=8.0");
    refused(cube(8), new Particles().add(0, 1, Double.NaN, 1), "in the box", "y=NaN");
    refused(
        cube(8),
        new Particles().add(0, 1, 1, 1).add(1, 2, 2, 2),
        "one of the scheme's: particle=1, phase=1");
    refused(
        cube(8),
        new Particles().add(0, 1, 1, 1, 0, Double.NaN, 0),
        "velocity of a particle must be finite: particle=0, u=0.0, v=NaN, w=0.0");
    refused(
        cube(8).phase(Phase.wallOf(water)),
        new Particles().add(0, 1, 1, 1).add(1, 2, 2, 2),
        "walls must be set where there is a solid: phase=wall of water");
    ParticleBox box = FLOW.lattice().box();
    refused(
        SphScheme.builder(box, new QuinticSpline(DX, 2)).timeStep(1),
        one(),
        "there must be a phase");
  }

  @Test
  void timeStepMustBeSet() {
    SphSchemeBuilder settings =
        SphScheme.builder(FLOW.lattice().box(), new QuinticSpline(DX, 2))
            .phase(water(1000 * DX * DX));
    assertThrows(IllegalStateException.class, () -> settings.build(one()));
  }

  @Test
  void periodicBoxMustHoldTheSupport() {
    refused(fluidOnly(4 * DX, 1000 * DX * DX, 1e-6), one(), "periodic box", "lx=", "reach=");
  }

  @Test
  void timeStepMustBeWithinItsLimits() {
    double allowed = 0.125 * DX * DX / Poiseuille.VISCOSITY;
    refused(FLOW.settings().timeStep(1.01 * allowed), FLOW.particles(), "dt=", "by viscosity");
    FLOW.settings().timeStep(allowed).build(FLOW.particles());
  }

  @Test
  void soundMayCrossMoreOfTheSmoothingLengthIfAskedTo() {
    Phase fast = Phase.fluid("fast", 1, 1e-3, EquationOfState.linear(1, 1, 0));
    QuinticSpline kernel = new QuinticSpline(1, 2);
    SphSchemeBuilder settings =
        SphScheme.builder(ParticleBox.plane(6, 6, Ends.PERIODIC, Ends.PERIODIC), kernel)
            .phase(fast)
            .search(SearchMode.SINGLE);
    assertEquals(0.25, TimeStep.of(kernel, List.of(fast), 0).sound());
    assertEquals(1.5, TimeStep.of(kernel, List.of(fast), 0, 1.5).sound());
    Particles one = new Particles().add(0, 3, 3, 0);
    refused(settings.timeStep(1.5), one, "dt=1.5", "allowed=0.25 by sound");
    settings.courantNumber(1.5).build(one);
    refused(settings.timeStep(1.51), one, "dt=1.51", "allowed=1.5 by sound");
    for (double bad : new double[] {0, 2.01, Double.NaN}) {
      IllegalArgumentException thrown =
          assertThrows(IllegalArgumentException.class, () -> settings.courantNumber(bad));
      assertTrue(thrown.getMessage().endsWith("C=" + bad), thrown.getMessage());
    }
  }

  @Test
  void bodyForceMustLeaveTheFlowSlowerThanSound() {
    refused(
        FLOW.settings().bodyForce(0.02, 0, 0).timeStep(1e-4),
        FLOW.particles(),
        "faster than 0.1 c",
        "c=2.5E-4",
        "phase=fluid");
  }

  @Test
  void wallFactorMustBeOneAtLeast() {
    refused(FLOW.settings().wallFactor(0.9), FLOW.particles(), "wall factor", "beta_max=0.9");
  }

  @Test
  void fluidMustHaveAViscosity() {
    EquationOfState state = EquationOfState.linear(1000, 2.5e-4, 0);
    IllegalArgumentException thrown =
        assertThrows(
            IllegalArgumentException.class, () -> Phase.fluid("oil", 1, Phase.TOUCHED, state));
    assertTrue(thrown.getMessage().contains("viscosity of oil"), thrown.getMessage());
    assertEquals(Phase.TOUCHED, Phase.wallOf(water(1)).viscosity());
  }

  @Test
  void fluidMustNotLieInWalls() {
    refused(FLOW.settings(), new Particles().add(0, DX, DX, 0), "in a wall", "particle=0");
  }

  @Test
  void everyPhaseMustHaveParticles() {
    Particles fluid = new Particles().add(0, DX, FLOW.lowerWall() + DX, 0);
    refused(FLOW.settings(), fluid, "phase must have particles", "wall of fluid");
  }

  @Test
  void cellsMustHoldTheSupport() {
    refused(FLOW.settings().cellEdge(DX), FLOW.particles(), "cell edge", "support=", "skin=");
  }

  /** A force that nobody foresaw: the step, the cell and the particle are named. */
  @Test
  void blowUpNamesStepCellAndParticle() {
    SphScheme scheme = FLOW.scheme();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(scheme);
      loop.run(3);
      scheme.drive(1e9, 0, 0);
      KernelException thrown = assertThrows(KernelException.class, () -> loop.run(1));
      assertEquals(3, loop.tick().step());
      assertTrue(thrown.getMessage().contains("pass 'force' failed at cell ("));
      assertTrue(thrown.getMessage().contains("step 3"), thrown.getMessage());
      String cause = thrown.getCause().getMessage();
      assertTrue(cause.contains("must not move farther than a cell in a step"), cause);
      assertTrue(cause.contains("particle="), cause);
    }
  }

  /** A fluid without a wall before the end of the box. */
  @Test
  void leavingTheBoxNamesTheParticle() {
    Particles fluid = new Particles().add(0, DX, DX / 1000, 0, 0, -1e-4, 0);
    SphScheme scheme = fluidOnly(DX, 1000 * DX * DX, 3e-3).build(fluid);
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      TimeLoop loop = dispatcher.loop(scheme);
      KernelException thrown = assertThrows(KernelException.class, () -> loop.run(5));
      String cause = thrown.getCause().getMessage();
      assertTrue(cause.contains("must stay in the box") && cause.contains("particle=0"), cause);
    }
  }
}
