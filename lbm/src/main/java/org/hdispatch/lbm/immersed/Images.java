package org.hdispatch.lbm.immersed;

import org.hdispatch.cell.Ends;
import org.hdispatch.lbm.Lattice;

/** Which periodic images of a body reach an interval of one axis. */
record Images(double length, boolean periodic) {
  static Images alongX(Lattice lattice) {
    return new Images(lattice.nx(), lattice.x() == Ends.PERIODIC);
  }

  static Images alongY(Lattice lattice) {
    return new Images(lattice.ny(), lattice.y() == Ends.PERIODIC);
  }

  static Images alongZ(Lattice lattice) {
    return new Images(lattice.nz(), lattice.z() == Ends.PERIODIC);
  }

  /**
   * First image, in box lengths from the body itself, that may reach the cells of the nodes
   * from..to; beyond {@link #last} if there is none.
   */
  int first(double from, double to, double centre, double reach) {
    if (Double.isInfinite(reach)) {
      return 0;
    }
    if (periodic) {
      return (int) Math.ceil((from - 0.5 - reach - centre) / length);
    }
    return centre + reach > from - 0.5 && centre - reach < to + 0.5 ? 0 : 1;
  }

  /** Last image that may reach the cells of the nodes from..to. */
  int last(double to, double centre, double reach) {
    return periodic && !Double.isInfinite(reach)
        ? (int) Math.floor((to + 0.5 + reach - centre) / length)
        : 0;
  }

  /** Distance along the axis to the nearest image. */
  double nearest(double distance) {
    return periodic ? distance - length * Math.rint(distance / length) : distance;
  }
}
