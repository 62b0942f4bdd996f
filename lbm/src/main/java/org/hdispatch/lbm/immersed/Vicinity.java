package org.hdispatch.lbm.immersed;

import java.util.Arrays;
import org.hdispatch.lbm.NodalBundle;

/** What is immersed in one bundle: where the fixed bodies are, and this step's forces. */
final class Vicinity {
  /** Force, torque, and weight of the covered nodes. */
  static final int LOAD = 7;

  private static final int[] NOBODY = {};

  final int x0;
  final int x1;
  final int y0;
  final int y1;
  final int z0;
  final int z1;

  /** Of the fixed bodies, by node, then body. */
  final Overlaps fixed = new Overlaps(0);

  /** First overlap of each node among those of the fixed bodies, and the end; if there are any. */
  int[] fixedFrom = NOBODY;

  /** Sum of the weights B of the covered nodes in this step. */
  double blocked;

  /** Bodies met in this step, in the order of their first overlap. */
  int met;

  int[] bodies = NOBODY;
  double[] loads = {};

  Vicinity(NodalBundle bundle) {
    int xl = Integer.MAX_VALUE;
    int yl = Integer.MAX_VALUE;
    int zl = Integer.MAX_VALUE;
    int xh = 0;
    int yh = 0;
    int zh = 0;
    for (int node = 0; node < bundle.nodes(); node++) {
      xl = Math.min(xl, bundle.x(node));
      yl = Math.min(yl, bundle.y(node));
      zl = Math.min(zl, bundle.z(node));
      xh = Math.max(xh, bundle.x(node));
      yh = Math.max(yh, bundle.y(node));
      zh = Math.max(zh, bundle.z(node));
    }
    x0 = xl;
    x1 = xh;
    y0 = yl;
    y1 = yh;
    z0 = zl;
    z1 = zh;
  }

  /** Makes room for so many bodies, so that meeting them allocates nothing. */
  void expect(int count) {
    if (count > bodies.length) {
      bodies = Arrays.copyOf(bodies, count);
      loads = Arrays.copyOf(loads, LOAD * count);
    }
  }

  /** Where the load of a body stands; zero if it was not met before. */
  int load(int body) {
    for (int n = 0; n < met; n++) {
      if (bodies[n] == body) {
        return LOAD * n;
      }
    }
    if (met == bodies.length) {
      expect(2 * met + 2);
    }
    bodies[met] = body;
    Arrays.fill(loads, LOAD * met, LOAD * (met + 1), 0);
    return LOAD * met++;
  }
}
