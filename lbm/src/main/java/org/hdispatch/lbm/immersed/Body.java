package org.hdispatch.lbm.immersed;

import java.util.Objects;

/**
 * A solid body in the flow: its shape, where it is and how it moves, and the force and torque that
 * the fluid exerts on it.
 *
 * <p>Units: lattice units throughout, the fluid's density being 1: node spacings, time steps, mass
 * of the fluid in one cell.
 *
 * <p>A shape is never turned: spin gives its surface a velocity, and no more. So a body that spins
 * should be a sphere, or a cylinder that spins round its axis.
 */
public final class Body {
  /** What decides how a body moves. */
  enum Motion {
    /** Its place never changes, though it may spin. */
    FIXED,
    /** A path. */
    PRESCRIBED,
    /** Newton's equations. */
    FREE
  }

  /** Farthest from the origin that a centre may be: images are numbered by ints. */
  private static final double FARTHEST = 1 << 30;

  private final Shape shape;
  private final Motion motion;
  private final Path path; // of a prescribed motion, else null
  private final double density; // of a free body, else infinite

  private double x;
  private double y;
  private double z;
  private double ux;
  private double uy;
  private double uz;
  private double wx;
  private double wy;
  private double wz;
  private double fx;
  private double fy;
  private double fz;
  private double tx;
  private double ty;
  private double tz;
  private double held;
  private boolean immersed;

  private Body(Shape shape, Motion motion, Path path, double density, Point place) {
    this.shape = Objects.requireNonNull(shape, "shape");
    this.motion = motion;
    this.path = path;
    this.density = density;
    moveTo(place.x(), place.y(), place.z());
  }

  /** A body that stays where it is. */
  public static Body fixed(Shape shape, Point place) {
    return new Body(shape, Motion.FIXED, null, Double.POSITIVE_INFINITY, place);
  }

  /** A body that stays where it is and spins. */
  public static Body spinning(Shape shape, Point place, Point spin) {
    Body body = fixed(shape, place);
    body.spinAt(spin.x(), spin.y(), spin.z());
    return body;
  }

  /** A body that follows a path, whatever the fluid does. */
  public static Body prescribed(Shape shape, Path path) {
    Objects.requireNonNull(path, "path");
    Body body = new Body(shape, Motion.PRESCRIBED, path, Double.POSITIVE_INFINITY, Point.ZERO);
    path.at(0, body);
    return body;
  }

  /**
   * A sphere that moves by Newton's equations.
   *
   * @param density its density over that of the fluid, above 1/2
   * @throws IllegalArgumentException if {@code density} is not finite or not above 1/2: then the
   *     fluid that the sphere drags along weighs as much as the sphere, and stepping one after the
   *     other does not hold
   */
  public static Body free(Sphere shape, double density, Point place) {
    if (!(density > 0.5 && density < Double.POSITIVE_INFINITY)) {
      throw Refusal.density(density);
    }
    return new Body(shape, Motion.FREE, null, density, place);
  }

  /** The shape. */
  public Shape shape() {
    return shape;
  }

  Motion motion() {
    return motion;
  }

  Path path() {
    return path;
  }

  /** Density over that of the fluid; infinite for a body that does not move freely. */
  public double density() {
    return density;
  }

  /** Mass; infinite for a body that does not move freely. */
  public double mass() {
    return density * shape.volume();
  }

  /** Moment of inertia of a free sphere, 2/5 m R². */
  double inertia() {
    return 0.4 * mass() * shape.reachX() * shape.reachX();
  }

  /** Marks the body as one of a scheme's: whether it was none before. */
  boolean immerse() {
    boolean first = !immersed;
    immersed = true;
    return first;
  }

  /**
   * Puts the centre at a place; for paths, and between two steps.
   *
   * @throws IllegalArgumentException if it is not within 2^30 node spacings of the origin
   */
  public void moveTo(double toX, double toY, double toZ) {
    if (!(isPlace(toX) && isPlace(toY) && isPlace(toZ))) {
      throw Refusal.place(toX, toY, toZ);
    }
    x = toX;
    y = toY;
    z = toZ;
  }

  private static boolean isPlace(double coordinate) {
    return Math.abs(coordinate) <= FARTHEST; // never for a NaN
  }

  /**
   * Sets the velocity of the centre; for paths, and between two steps.
   *
   * @throws IllegalArgumentException if it is not finite
   */
  public void moveAt(double velocityX, double velocityY, double velocityZ) {
    if (!isFinite(velocityX, velocityY, velocityZ)) {
      throw Refusal.velocity(velocityX, velocityY, velocityZ);
    }
    ux = velocityX;
    uy = velocityY;
    uz = velocityZ;
  }

  /**
   * Sets the angular velocity; for paths, and between two steps.
   *
   * @throws IllegalArgumentException if it is not finite
   */
  public void spinAt(double spinX, double spinY, double spinZ) {
    if (!isFinite(spinX, spinY, spinZ)) {
      throw Refusal.spin(spinX, spinY, spinZ);
    }
    wx = spinX;
    wy = spinY;
    wz = spinZ;
  }

  private static boolean isFinite(double a, double b, double c) {
    return Double.isFinite(a) && Double.isFinite(b) && Double.isFinite(c);
  }

  /** Accelerates for a time, then moves on for it; {@link #isLost} tells what came of that. */
  void accelerate(double ax, double ay, double az, double time) {
    ux += time * ax;
    uy += time * ay;
    uz += time * az;
    x += time * ux;
    y += time * uy;
    z += time * uz;
  }

  /** Adds to the angular velocity; {@link #isLost} tells what came of that. */
  void spinUp(double byX, double byY, double byZ) {
    wx += byX;
    wy += byY;
    wz += byZ;
  }

  /** Whether place, velocity or spin are no longer what they may be. */
  boolean isLost() {
    return !(isPlace(x)
        && isPlace(y)
        && isPlace(z)
        && isFinite(ux, uy, uz)
        && isFinite(wx, wy, wz));
  }

  /** Mass of fluid that moved with the body in the last step: the sum of the weights B. */
  double held() {
    return held;
  }

  void clearLoad() {
    fx = 0;
    fy = 0;
    fz = 0;
    tx = 0;
    ty = 0;
    tz = 0;
    held = 0;
  }

  /** Adds force, torque and weight that stand one after the other in an array. */
  void addLoad(double[] load, int at) {
    fx += load[at];
    fy += load[at + 1];
    fz += load[at + 2];
    tx += load[at + 3];
    ty += load[at + 4];
    tz += load[at + 5];
    held += load[at + 6];
  }

  /** Place of the centre, first coordinate; not brought back into a periodic box. */
  public double x() {
    return x;
  }

  /** Place of the centre, second coordinate. */
  public double y() {
    return y;
  }

  /** Place of the centre, third coordinate. */
  public double z() {
    return z;
  }

  /** Velocity of the centre, first component. */
  public double ux() {
    return ux;
  }

  /** Velocity of the centre, second component. */
  public double uy() {
    return uy;
  }

  /** Velocity of the centre, third component. */
  public double uz() {
    return uz;
  }

  /** Angular velocity, first component. */
  public double wx() {
    return wx;
  }

  /** Angular velocity, second component. */
  public double wy() {
    return wy;
  }

  /** Angular velocity, third component. */
  public double wz() {
    return wz;
  }

  /**
   * Force of the lattice's fluid on the body in the last step, first component. It includes what it
   * takes to move the fluid inside the body with it, but not the buoyancy in a fluid that itself
   * has weight.
   */
  public double fx() {
    return fx;
  }

  /** Force on the body, second component. */
  public double fy() {
    return fy;
  }

  /** Force on the body, third component. */
  public double fz() {
    return fz;
  }

  /** Torque on the body about its centre in the last step, first component. */
  public double tx() {
    return tx;
  }

  /** Torque on the body, second component. */
  public double ty() {
    return ty;
  }

  /** Torque on the body, third component. */
  public double tz() {
    return tz;
  }
}
