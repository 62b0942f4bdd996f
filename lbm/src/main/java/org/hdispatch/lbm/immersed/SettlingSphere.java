package org.hdispatch.lbm.immersed;

import org.hdispatch.cell.Ends;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.Relaxation;
import org.hdispatch.lbm.VelocitySet;

/**
 * A sphere of 15 mm that settles in a box of oil, 100 x 100 x 160 mm: the experiment of ten Cate,
 * Nieuwstad, Derksen, Van den Akker, Physics of Fluids 14, 2002, 4012.
 *
 * <p>The time step is the largest with tau at most 0.6 and a Mach number at most 0.05 at the
 * measured peak velocity.
 */
public final class SettlingSphere {
  /** The four fluids, with the peak velocity measured in each. */
  public enum Fluid {
    /** Reynolds number 1.5. */
    E1(970, 0.373, 0.0360),
    /** Reynolds number 4.1. */
    E2(965, 0.212, 0.0572),
    /** Reynolds number 11.6. */
    E3(962, 0.113, 0.0873),
    /** Reynolds number 31.9. */
    E4(960, 0.058, 0.1222);

    private final double density;
    private final double viscosity;
    private final double peak;

    Fluid(double density, double viscosity, double peak) {
      this.density = density;
      this.viscosity = viscosity;
      this.peak = peak;
    }

    /** Density, in kg/m³. */
    public double density() {
      return density;
    }

    /** Dynamic viscosity, in Pa s. */
    public double viscosity() {
      return viscosity;
    }

    /** Measured peak velocity, in m/s. */
    public double peak() {
      return peak;
    }
  }

  private static final double WIDTH = 0.1; // m
  private static final double HEIGHT = 0.16; // m
  private static final double RADIUS = 0.0075; // m
  private static final double DENSITY = 1120; // kg/m³
  private static final double START = 0.1275; // m, of the centre above the bottom
  private static final double GRAVITY = 9.81; // m/s²
  private static final double MOST_TAU = 0.6;
  private static final double MOST_MACH = 0.05;

  private final double spacing; // m
  private final double timeStep; // s
  private final Body sphere;
  private final LbmScheme scheme;

  /**
   * Sets the experiment up, at rest.
   *
   * @param nodes across the width of the box, at least 20
   * @throws IllegalArgumentException if {@code nodes} is less than 20
   */
  public SettlingSphere(Fluid fluid, int nodes) {
    if (nodes < 20) {
      throw new IllegalArgumentException(
          "nodes across the box must number at least 20: nodes=" + nodes);
    }
    spacing = WIDTH / nodes;
    double kinematic = fluid.viscosity / fluid.density;
    double soundSpeed = Math.sqrt(VelocitySet.SOUND_SPEED_SQUARED);
    double slow = MOST_MACH * soundSpeed * kinematic / (fluid.peak * spacing);
    double tau = Math.min(MOST_TAU, Relaxation.relaxationTime(slow));
    Relaxation relaxation = Relaxation.bgk(tau);
    timeStep = relaxation.viscosity() * spacing * spacing / kinematic;
    double middle = (nodes - 1) / 2.0;
    Point start = new Point(middle, middle, START / spacing - 0.5);
    sphere = Body.free(new Sphere(RADIUS / spacing), DENSITY / fluid.density, start);
    double gravity = GRAVITY * timeStep * timeStep / spacing;
    int height = (int) Math.round(HEIGHT / spacing);
    scheme =
        LbmScheme.on(Lattice.empty(nodes, nodes, height, Ends.OPEN, Ends.OPEN, Ends.OPEN))
            .relaxation(relaxation)
            .immersion(ImmersedBodies.of(sphere).withGravity(new Point(0, 0, -gravity)))
            .build();
  }

  /**
   * Sets the experiment up, at rest.
   *
   * @param nodes across the sphere, at least 3
   * @throws IllegalArgumentException if {@code nodes} is less than 3
   */
  public static SettlingSphere across(Fluid fluid, int nodes) {
    if (nodes < 3) {
      throw new IllegalArgumentException(
          "nodes across the sphere must number at least 3: nodes=" + nodes);
    }
    return new SettlingSphere(fluid, boxWidth(nodes));
  }

  private static int boxWidth(int nodesAcrossSphere) {
    return (int) Math.round(nodesAcrossSphere * WIDTH / (2 * RADIUS));
  }

  /** Nodes of the box with so many across the sphere. */
  public static double boxNodes(int nodesAcrossSphere) {
    return Math.pow(nodesAcrossSphere * WIDTH / (2 * RADIUS), 3) * HEIGHT / WIDTH;
  }

  /** The scheme, to be run by a loop. */
  public LbmScheme scheme() {
    return scheme;
  }

  /** The sphere, in lattice units. */
  public Body sphere() {
    return sphere;
  }

  /** Length of a time step, in s. */
  public double timeStep() {
    return timeStep;
  }

  /** Velocity of the sphere downwards, in m/s. */
  public double velocity() {
    return -sphere.uz() * spacing / timeStep;
  }

  /** Gap between sphere and bottom, in m. */
  public double gap() {
    return (sphere.z() + 0.5) * spacing - RADIUS;
  }
}
