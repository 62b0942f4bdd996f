package org.hdispatch.app;

import java.util.function.IntFunction;
import org.hdispatch.sph.cases.Couette;
import org.hdispatch.sph.cases.Poiseuille;

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
