package org.hdispatch.app;

import java.util.function.IntFunction;
import org.hdispatch.sph.cases.Couette;
import org.hdispatch.sph.cases.CylinderArray;
import org.hdispatch.sph.cases.Poiseuille;
import org.hdispatch.sph.cases.SimpleCubicSpheres;
import org.hdispatch.sph.cases.SquareDuct;

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
        double porosity = flow.lattice().porosity(flow.walls());
        return new MeanFlow(flow, 0.5, SquareDuct.MEAN * porosity);
      }),
  CYLINDERS(
      32,
      "Creeping flow through a square array of cylinders, solid fraction 0.3, 2-D. Known: the"
          + " superficial velocity (Sangani, Acrivos 1982).",
      "edge^2/nu",
      size -> {
        CylinderArray flow = CylinderArray.ofSolidFraction(0.3, size, 0);
        return new MeanFlow(flow, 0.25, flow.superficialVelocity());
      }),
  SPHERES(
      24,
      "Creeping flow through a simple-cubic array of spheres, solid fraction 0.216, 3-D. Known:"
          + " the superficial velocity (Zick, Homsy 1982).",
      "edge^2/nu",
      size -> {
        SimpleCubicSpheres flow = new SimpleCubicSpheres(0.216, size, 0);
        return new MeanFlow(flow, 0.25, flow.superficialVelocity());
      });

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
