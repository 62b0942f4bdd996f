package org.hdispatch.lbm.immersed;

import java.util.Arrays;
import org.hdispatch.lbm.Lattice;

/**
 * Moves the free bodies by one time step: leapfrog, cut into smaller steps while something touches,
 * the fluid's force being constant meanwhile.
 *
 * <pre>
 *   m a = F + m_f a' + m_h k' + (m - m_f) g + contacts
 * </pre>
 *
 * The fluid inside the body moves with it; what that takes is in F, the force of the lattice's
 * fluid, though no real fluid is there. F knows the velocity of the body one step late, so what the
 * body gained in the step before gives it back: m_f a', with m_f the mass of fluid inside (Feng,
 * Michaelides, Journal of Computational Physics 195, 2004, 602), for what fluid and gravity gave,
 * since the fluid in cut cells follows these changes within a few steps; m_h k', with m_h the sum
 * of the weights B, for the kicks of contacts, to which it does not: m_f would make them bounce
 * higher than they fell. Likewise m_f for the spin.
 */
final class Newton {
  /** Distance between surfaces below which steps are cut, in node spacings. */
  private static final double NEAR = 1;

  private final Body[] bodies;
  private final Point gravity;
  private final Contact contact;
  private final double[] walls; // low x, high x, low y, ...
  private final Images[] images;

  // By body: velocity gained in the last step but for contacts, by contacts, and spin gained;
  // accelerations by fluid and gravity, and by contacts.
  private final double[][] gained;
  private final double[][] kicked;
  private final double[][] spun;
  private final double[][] steady;
  private final double[][] pushed;

  Newton(Body[] bodies, Lattice lattice, Point gravity, Contact contact) {
    this.bodies = bodies;
    this.gravity = gravity;
    this.contact = contact;
    images = new Images[] {Images.alongX(lattice), Images.alongY(lattice), Images.alongZ(lattice)};
    walls = new double[6];
    for (int axis = 0; axis < 3; axis++) {
      boolean open = !images[axis].periodic();
      walls[2 * axis] = open ? -0.5 : Double.NEGATIVE_INFINITY;
      walls[2 * axis + 1] = open ? images[axis].length() - 0.5 : Double.POSITIVE_INFINITY;
    }
    gained = new double[bodies.length][3];
    kicked = new double[bodies.length][3];
    spun = new double[bodies.length][3];
    steady = new double[bodies.length][3];
    pushed = new double[bodies.length][3];
  }

  void step() {
    boolean near = false;
    for (int n = 0; n < bodies.length; n++) {
      if (free(n)) {
        load(n);
        near |= nearAnything(n);
      }
    }
    int parts = near ? contact.subSteps() : 1;
    for (int part = 0; part < parts; part++) {
      if (near) {
        touch();
      }
      for (int n = 0; n < bodies.length; n++) {
        if (free(n)) {
          move(n, 1.0 / parts);
        }
      }
    }
    for (int n = 0; n < bodies.length; n++) {
      if (free(n)) {
        Body body = bodies[n];
        gained[n][0] += body.ux() - kicked[n][0];
        gained[n][1] += body.uy() - kicked[n][1];
        gained[n][2] += body.uz() - kicked[n][2];
        spin(body, spun[n]);
      }
    }
  }

  private boolean free(int n) {
    return bodies[n].motion() == Body.Motion.FREE;
  }

  /** Acceleration by fluid and gravity; begins the gain of this step with minus the velocity. */
  private void load(int n) {
    Body body = bodies[n];
    double mass = body.mass();
    double inner = 1 / body.density();
    double buoyant = 1 - inner;
    double held = body.held() / mass;
    double[] a = steady[n];
    double[] gain = gained[n];
    double[] kick = kicked[n];
    a[0] = body.fx() / mass + inner * gain[0] + held * kick[0] + buoyant * gravity.x();
    a[1] = body.fy() / mass + inner * gain[1] + held * kick[1] + buoyant * gravity.y();
    a[2] = body.fz() / mass + inner * gain[2] + held * kick[2] + buoyant * gravity.z();
    gain[0] = -body.ux();
    gain[1] = -body.uy();
    gain[2] = -body.uz();
    Arrays.fill(pushed[n], 0);
    Arrays.fill(kick, 0);
  }

  private void move(int n, double time) {
    Body body = bodies[n];
    double[] a = steady[n];
    double[] push = pushed[n];
    double[] kick = kicked[n];
    kick[0] += time * push[0];
    kick[1] += time * push[1];
    kick[2] += time * push[2];
    body.accelerate(a[0] + push[0], a[1] + push[1], a[2] + push[2], time);
  }

  private static void spin(Body body, double[] gain) {
    double inertia = body.inertia();
    double inner = 1 / body.density();
    gain[0] = body.tx() / inertia + inner * gain[0];
    gain[1] = body.ty() / inertia + inner * gain[1];
    gain[2] = body.tz() / inertia + inner * gain[2];
    body.spinUp(gain[0], gain[1], gain[2]);
  }

  private boolean nearAnything(int n) {
    Body body = bodies[n];
    double radius = body.shape().reachX();
    if (overlap(body.x(), radius, 0) > -NEAR
        || overlap(body.y(), radius, 1) > -NEAR
        || overlap(body.z(), radius, 2) > -NEAR) {
      return true;
    }
    for (int m = 0; m < bodies.length; m++) {
      if (m != n
          && bodies[m].shape() instanceof Sphere
          && radius + bodies[m].shape().reachX() - distance(body, bodies[m]) > -NEAR) {
        return true;
      }
    }
    return false;
  }

  /** Overlap with the nearer of an axis' two walls. */
  private double overlap(double centre, double radius, int axis) {
    return radius - Math.min(centre - walls[2 * axis], walls[2 * axis + 1] - centre);
  }

  private double distance(Body a, Body b) {
    double x = images[0].nearest(a.x() - b.x());
    double y = images[1].nearest(a.y() - b.y());
    double z = images[2].nearest(a.z() - b.z());
    return Math.sqrt(x * x + y * y + z * z);
  }

  /** Accelerations by contacts, walls first, then pair by pair. */
  private void touch() {
    for (int n = 0; n < bodies.length; n++) {
      if (free(n)) {
        Body body = bodies[n];
        double radius = body.shape().reachX();
        pushed[n][0] = wall(body.x(), body.ux(), radius, 0);
        pushed[n][1] = wall(body.y(), body.uy(), radius, 1);
        pushed[n][2] = wall(body.z(), body.uz(), radius, 2);
      }
    }
    for (int n = 0; n < bodies.length; n++) {
      for (int m = n + 1; m < bodies.length; m++) {
        if ((free(n) || free(m))
            && bodies[n].shape() instanceof Sphere
            && bodies[m].shape() instanceof Sphere) {
          collide(n, m);
        }
      }
    }
  }

  private double wall(double centre, double velocity, double radius, int axis) {
    return contact.acceleration(walls[2 * axis] + radius - centre, -velocity)
        - contact.acceleration(centre + radius - walls[2 * axis + 1], velocity);
  }

  private void collide(int n, int m) {
    Body a = bodies[n];
    Body b = bodies[m];
    double x = images[0].nearest(a.x() - b.x());
    double y = images[1].nearest(a.y() - b.y());
    double z = images[2].nearest(a.z() - b.z());
    double distance = Math.sqrt(x * x + y * y + z * z);
    double overlap = a.shape().reachX() + b.shape().reachX() - distance;
    if (overlap <= 0 || distance == 0) {
      return;
    }
    double nx = x / distance;
    double ny = y / distance;
    double nz = z / distance;
    double approach = (b.ux() - a.ux()) * nx + (b.uy() - a.uy()) * ny + (b.uz() - a.uz()) * nz;
    double push = contact.acceleration(overlap, approach);
    double shareOfA = 1 / (1 + a.mass() / b.mass()); // m/m_a with the effective mass m
    double shareOfB = 1 / (1 + b.mass() / a.mass());
    if (free(n)) {
      add(pushed[n], push * shareOfA, nx, ny, nz);
    }
    if (free(m)) {
      add(pushed[m], -push * shareOfB, nx, ny, nz);
    }
  }

  private static void add(double[] sum, double size, double x, double y, double z) {
    sum[0] += size * x;
    sum[1] += size * y;
    sum[2] += size * z;
  }
}
