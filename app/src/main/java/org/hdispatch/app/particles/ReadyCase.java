package org.hdispatch.app.particles;

import java.util.List;
import java.util.function.IntFunction;
import org.hdispatch.app.particles.ReadyFlow.Finding;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.cases.Couette;
import org.hdispatch.sph.cases.CylinderArray;
import org.hdispatch.sph.cases.DamBreak;
import org.hdispatch.sph.cases.Drop;
import org.hdispatch.sph.cases.DropOnWall;
import org.hdispatch.sph.cases.LayeredPoiseuille;
import org.hdispatch.sph.cases.Poiseuille;
import org.hdispatch.sph.cases.RayleighTaylor;
import org.hdispatch.sph.cases.SimpleCubicSpheres;
import org.hdispatch.sph.cases.SquareDuct;
import org.hdispatch.sph.cases.TwoPhaseDrop;

/** The flows of {@code hdispatch sph} that are compared with what is known of them. */
enum ReadyCase {
  POISEUILLE(
      20,
      "Water between two plane walls, set in motion by a body force, 2-D (Morris, Fox, Zhu 1997,"
          + " 4.2). Known: the series.",
      "s",
      size -> {
        Poiseuille flow = new Poiseuille(size, 0);
        return new ProfileFlow(
            flow,
            1,
            Poiseuille.GREATEST,
            (y, time) -> Poiseuille.velocity(y - flow.lowerWall(), time));
      }),
  COUETTE(
      20,
      "Water between two plane walls, one of which is set in motion, 2-D (Morris, Fox, Zhu 1997,"
          + " 4.1). Known: the series.",
      "s",
      size -> {
        Couette flow = new Couette(size, 0);
        return new ProfileFlow(
            flow,
            1,
            Couette.WALL_VELOCITY,
            (y, time) -> Couette.velocity(y - flow.lowerWall(), time));
      }),
  DUCT(
      16,
      "Creeping flow through a square duct, 3-D. Known: the mean velocity.",
      "side^2/nu",
      size -> {
        SquareDuct flow = new SquareDuct(size, 0);
        return new MeanFlow(
            flow, 0.5, () -> SquareDuct.MEAN * flow.lattice().porosity(flow.walls()));
      }),
  CYLINDERS(
      32,
      "Creeping flow through a square array of cylinders, solid fraction 0.3, 2-D. Known: the"
          + " superficial velocity (Sangani, Acrivos 1982).",
      "edge^2/nu",
      size -> {
        CylinderArray flow = CylinderArray.ofSolidFraction(0.3, size, 0);
        return new MeanFlow(flow, 0.25, flow::superficialVelocity);
      }),
  SPHERES(
      24,
      "Creeping flow through a simple-cubic array of spheres, solid fraction 0.216, 3-D. Known:"
          + " the superficial velocity (Zick, Homsy 1982).",
      "edge^2/nu",
      size -> {
        SimpleCubicSpheres flow = new SimpleCubicSpheres(0.216, size, 0);
        return new MeanFlow(flow, 0.25, flow::superficialVelocity);
      }),
  LAYERS(
      10,
      "Two layers of fluid between plane walls, the upper one twice as dense and four times as"
          + " viscous, 2-D; the size is that of a layer. Known: the parabolas.",
      "",
      size -> {
        LayeredPoiseuille flow = new LayeredPoiseuille(size, 2, 4);
        return new LatticeFlow(
            flow::settings,
            flow::particles,
            flow.settlingTime(),
            (scheme, time) ->
                ProfileFlow.of(scheme, time, greatest(scheme, flow), (y, at) -> flow.velocity(y)));
      }),
  RAYLEIGH_TAYLOR(
      40,
      "A fluid over one a third as dense, 2-D; the size is that of the wave that grows between"
          + " them. Known: the rate at which it grows by linear theory.",
      "",
      size -> {
        RayleighTaylor flow = new RayleighTaylor(size, 3);
        return new LatticeFlow(
            flow::settings,
            flow::particles,
            1.3 / flow.growthRate(),
            (scheme, time) ->
                List.of(
                    Finding.of(
                        "growth_rate",
                        "growth rate",
                        Math.log(flow.amplitude(scheme) / flow.firstAmplitude()) / time,
                        flow.growthRate())));
      }),
  DAM_BREAK(
      32,
      "A square column of fluid that collapses in a tank, 2-D; the size is its height H. Known: its"
          + " front is not faster than 2 sqrt(g H), a wave over a dry bed (Ritter 1892).",
      "",
      size -> {
        DamBreak flow = new DamBreak(size);
        return new LatticeFlow(
            flow::settings,
            flow::particles,
            1.5 * flow.time(),
            (scheme, time) ->
                List.of(
                    Finding.notAbove(
                        "front_speed",
                        "mean speed of front, at most",
                        (flow.front(scheme) - 1) / time * flow.time(),
                        2)));
      }),
  CONTACT_ANGLE(
      30,
      "A drop on a wall that wets it to 120 degrees, begun at 90, held together by pairwise forces,"
          + " 2-D; the size is the diameter of a disc of its area. Known: the angle, about which it swings"
          + " by a few degrees.",
      "",
      size -> {
        DropOnWall flow = new DropOnWall(size / 2.0, 120, 90);
        return new LatticeFlow(
            flow::settings,
            flow::particles,
            600,
            (scheme, time) ->
                List.of(Finding.of("contact_angle", "contact angle", flow.angle(scheme), 120)));
      }),
  DROP(
      24,
      "A drop in a void, held together by pairwise forces that the mean field gives a surface"
          + " tension of 1, 2-D; the size is its diameter. Known: the pressure inside, by Laplace's"
          + " law, below which frozen stress keeps it, by a tenth to four tenths at sizes above 16.",
      "",
      size -> {
        Drop flow = Drop.firm(2, size / 2.0);
        return new LatticeFlow(
            flow::settings,
            flow::particles,
            300,
            (scheme, time) ->
                List.of(
                    Finding.of(
                        "pressure",
                        "pressure inside",
                        flow.pressure(scheme),
                        flow.laplacePressure(scheme.particles()))));
      }),
  TWO_PHASE_DROP(
      20,
      "A drop twice as dense as the fluid around it, without surface tension, begun in disorder,"
          + " 2-D; the size is its diameter. Known: it comes to rest.",
      "",
      size -> {
        TwoPhaseDrop flow = new TwoPhaseDrop(size / 2.0, 2, 0, 0.1);
        return new LatticeFlow(
            flow::settings,
            flow::particles,
            42,
            (scheme, time) ->
                List.of(
                    new Finding(
                        "fastest",
                        "fastest, of sound",
                        scheme.fastest(),
                        0,
                        scheme.fastest() / flow.soundSpeed())));
      });

  /** Greatest velocity that is right at a place where there is fluid. */
  private static double greatest(SphScheme scheme, LayeredPoiseuille flow) {
    double[] most = new double[1];
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) ->
            most[0] = phase < 2 ? Math.max(most[0], flow.velocity(y)) : most[0]);
    return most[0];
  }

  private final int usualSize;
  private final String what;
  private final String unitOfTime;
  private final IntFunction<ReadyFlow> flow;

  ReadyCase(int usualSize, String what, String unitOfTime, IntFunction<ReadyFlow> flow) {
    this.usualSize = usualSize;
    this.what = what;
    this.unitOfTime = unitOfTime;
    this.flow = flow;
  }

  /** Particles across, if nothing else is said. */
  int usualSize() {
    return usualSize;
  }

  /** What it is and what is known, in a sentence or two. */
  String what() {
    return what;
  }

  /** Unit of the time, as texts call it. */
  String unitOfTime() {
    return unitOfTime;
  }

  /**
   * The flow.
   *
   * @param size particles across
   * @throws IllegalArgumentException if they are too few
   */
  ReadyFlow flow(int size) {
    return flow.apply(size);
  }
}
