package org.hdispatch.lbm.immersed;

import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.NodalBundle;

/** Finds which bodies cover the nodes of a chunk: those that move, anew in every step. */
final class Covering {
  /** Most nodes of a chunk. */
  static final int CHUNK = 128;

  private final Body[] bodies;
  private final Images alongX;
  private final Images alongY;
  private final Images alongZ;
  private final boolean fixed; // whether it looks for the fixed bodies or for the moving ones

  private NodalBundle bundle;
  private final int[] near; // numbers of the bodies that may reach the bundle
  private int nearCount;
  private final double[] xs = new double[CHUNK];
  private final double[] ys = new double[CHUNK];
  private final double[] zs = new double[CHUNK];

  Covering(Body[] bodies, Lattice lattice, boolean fixed) {
    this.bodies = bodies;
    this.fixed = fixed;
    alongX = Images.alongX(lattice);
    alongY = Images.alongY(lattice);
    alongZ = Images.alongZ(lattice);
    near = new int[bodies.length];
  }

  /** Looks which bodies may reach a bundle: whether any does. */
  boolean enter(NodalBundle next, Vicinity vicinity) {
    bundle = next;
    nearCount = 0;
    for (int n = 0; n < bodies.length; n++) {
      Body body = bodies[n];
      if (body.motion() == Body.Motion.FIXED == fixed && reaches(body, vicinity)) {
        near[nearCount++] = n;
      }
    }
    return nearCount > 0;
  }

  /** How many bodies may reach the bundle entered last. */
  int nearby() {
    return nearCount;
  }

  private boolean reaches(Body body, Vicinity v) {
    Shape shape = body.shape();
    return alongX.first(v.x0, v.x1, body.x(), shape.reachX())
            <= alongX.last(v.x1, body.x(), shape.reachX())
        && alongY.first(v.y0, v.y1, body.y(), shape.reachY())
            <= alongY.last(v.y1, body.y(), shape.reachY())
        && alongZ.first(v.z0, v.z1, body.z(), shape.reachZ())
            <= alongZ.last(v.z1, body.z(), shape.reachZ());
  }

  /** Adds the overlaps of some nodes of the bundle, given by their numbers. */
  void find(int[] numbers, int nodes, Overlaps into) {
    if (nearCount == 0) {
      return;
    }
    for (int k = 0; k < nodes; k++) {
      xs[k] = bundle.x(numbers[k]);
      ys[k] = bundle.y(numbers[k]);
      zs[k] = bundle.z(numbers[k]);
    }
    for (int n = 0; n < nearCount; n++) {
      images(near[n], nodes, into);
    }
  }

  private void images(int number, int nodes, Overlaps into) {
    Body body = bodies[number];
    Shape shape = body.shape();
    double xl = least(xs, nodes);
    double xh = most(xs, nodes);
    double yl = least(ys, nodes);
    double yh = most(ys, nodes);
    double zl = least(zs, nodes);
    double zh = most(zs, nodes);
    int iLast = alongX.last(xh, body.x(), shape.reachX());
    int jLast = alongY.last(yh, body.y(), shape.reachY());
    int kLast = alongZ.last(zh, body.z(), shape.reachZ());
    for (int k = alongZ.first(zl, zh, body.z(), shape.reachZ()); k <= kLast; k++) {
      double z = body.z() + k * alongZ.length();
      for (int j = alongY.first(yl, yh, body.y(), shape.reachY()); j <= jLast; j++) {
        double y = body.y() + j * alongY.length();
        for (int i = alongX.first(xl, xh, body.x(), shape.reachX()); i <= iLast; i++) {
          double x = body.x() + i * alongX.length();
          cover(shape, number, x, y, z, nodes, into);
        }
      }
    }
  }

  private void cover(
      Shape shape, int number, double x, double y, double z, int nodes, Overlaps into) {
    double reachX = shape.reachX() + 0.5;
    double reachY = shape.reachY() + 0.5;
    double reachZ = shape.reachZ() + 0.5;
    for (int k = 0; k < nodes; k++) {
      double dx = xs[k] - x;
      double dy = ys[k] - y;
      double dz = zs[k] - z;
      if (Math.abs(dx) < reachX && Math.abs(dy) < reachY && Math.abs(dz) < reachZ) {
        double fraction = shape.fraction(dx, dy, dz);
        if (fraction > 0) {
          into.add(k, number, fraction, dx, dy, dz);
        }
      }
    }
  }

  private static double least(double[] row, int n) {
    double least = row[0];
    for (int k = 1; k < n; k++) {
      least = Math.min(least, row[k]);
    }
    return least;
  }

  private static double most(double[] row, int n) {
    double most = row[0];
    for (int k = 1; k < n; k++) {
      most = Math.max(most, row[k]);
    }
    return most;
  }
}
