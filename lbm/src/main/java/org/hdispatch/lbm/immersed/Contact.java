package org.hdispatch.lbm.immersed;

/**
 * How spheres touch each other and the walls at the open ends of the lattice: a linear spring and
 * dashpot along the line of centres, without friction (Cundall, Strack, Géotechnique 29, 1979, 47).
 * Lubrication below a node spacing is not added.
 *
 * <p>Nothing holds a sphere at bodies of other shapes and at the lattice's own solid nodes: there
 * it feels the fluid alone, and passes through. Of two spheres in a periodic box only the nearest
 * images touch each other, and none touches its own. All pairs are looked at in each part of a
 * step: that is for hundreds of spheres rather than for ten thousand.
 *
 * <p>With the effective mass m of the pair, spring k = m (pi² + ln² e)/T², dashpot -2 m ln(e)/T: a
 * collision without fluid lasts T and returns e of its speed; at speed v spheres overlap by at most
 * v T/pi.
 *
 * @param duration of a collision T, in time steps
 * @param restitution e, above 0, at most 1
 */
public record Contact(double duration, double restitution) {
  /** Two time steps, half the speed lost, so that spheres come to rest on each other. */
  public static final Contact DEFAULT = new Contact(2, 0.5);

  private static final int STEPS_PER_COLLISION = 40;

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if the duration is not positive or the restitution not within
   *     0 to 1
   */
  public Contact {
    if (!(duration > 0 && duration < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(
          "duration of a collision must be positive: duration=" + duration + " steps");
    }
    if (!(restitution > 0 && restitution <= 1)) {
      throw new IllegalArgumentException(
          "restitution must be above 0 and at most 1: restitution=" + restitution);
    }
  }

  /** Parts into which a time step is cut while something touches. */
  int subSteps() {
    return Math.max(1, (int) Math.ceil(STEPS_PER_COLLISION / duration));
  }

  /**
   * Repulsion over effective mass. Just before they part the dashpot pulls: without that the
   * restitution would be larger than asked for.
   *
   * @param overlap positive where they touch
   * @param approach rate of growth of the overlap
   */
  double acceleration(double overlap, double approach) {
    if (overlap <= 0) {
      return 0;
    }
    double log = StrictMath.log(restitution);
    double spring = (Math.PI * Math.PI + log * log) / (duration * duration);
    double dashpot = -2 * log / duration;
    return spring * overlap + dashpot * approach;
  }
}
