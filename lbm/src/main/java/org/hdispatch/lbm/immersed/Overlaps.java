package org.hdispatch.lbm.immersed;

import java.util.Arrays;

/** Which bodies cover which nodes, and how far. Grows when it must and never shrinks. */
final class Overlaps {
  int count;

  /** Number of the node, in its bundle or chunk. */
  int[] node;

  /** Number of the body. */
  int[] body;

  /** Solid fraction. */
  double[] fraction;

  /** From the body's centre to the node. */
  double[] x;

  double[] y;
  double[] z;

  Overlaps(int capacity) {
    node = new int[capacity];
    body = new int[capacity];
    fraction = new double[capacity];
    x = new double[capacity];
    y = new double[capacity];
    z = new double[capacity];
  }

  void add(int ofNode, int ofBody, double share, double fromX, double fromY, double fromZ) {
    if (count == node.length) {
      resize(Math.max(16, 2 * count));
    }
    node[count] = ofNode;
    body[count] = ofBody;
    fraction[count] = share;
    x[count] = fromX;
    y[count] = fromY;
    z[count] = fromZ;
    count++;
  }

  void resize(int capacity) {
    node = Arrays.copyOf(node, capacity);
    body = Arrays.copyOf(body, capacity);
    fraction = Arrays.copyOf(fraction, capacity);
    x = Arrays.copyOf(x, capacity);
    y = Arrays.copyOf(y, capacity);
    z = Arrays.copyOf(z, capacity);
  }
}
