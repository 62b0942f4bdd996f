package org.hdispatch.bench.lbm;

import java.util.BitSet;
import java.util.Random;
import org.hdispatch.lbm.NodeMap;

/**
 * A rock of overlapping solid spheres of one radius, their centres random and even, in a periodic
 * cube. Spheres are added until the porosity is down to what was asked for; a node is solid where
 * its distance to a centre is less than the radius.
 *
 * <p>Same size, radius, porosity and seed: same rock, on every JDK.
 */
final class RandomSpheres implements NodeMap {
  private final int side;
  private final BitSet solid;

  /**
   * Makes a rock.
   *
   * @param side edge of the cube, in nodes
   * @param radius of the spheres, in nodes, less than half the edge
   * @param porosity at most this share of the nodes stays fluid
   * @param seed of the centres
   * @throws IllegalArgumentException if the radius is not between 1 and {@code side / 2}, or the
   *     porosity not between 0 and 1
   */
  RandomSpheres(int side, double radius, double porosity, long seed) {
    if (!(radius >= 1 && 2 * radius < side)) {
      throw new IllegalArgumentException(
          "radius must lie between 1 and side / 2: radius=" + radius + ", side=" + side);
    }
    if (!(porosity > 0 && porosity < 1)) {
      throw new IllegalArgumentException("porosity must lie between 0 and 1: porosity=" + porosity);
    }
    this.side = side;
    int nodes = Math.multiplyExact(Math.multiplyExact(side, side), side);
    solid = new BitSet(nodes);
    Random random = new Random(seed);
    int count = 0;
    while (nodes - count > porosity * nodes) {
      count +=
          addSphere(
              side * random.nextDouble(),
              side * random.nextDouble(),
              side * random.nextDouble(),
              radius);
    }
  }

  /** Makes the nodes of a sphere solid and returns how many of them were not. */
  private int addSphere(double x, double y, double z, double radius) {
    int added = 0;
    for (int k = (int) Math.floor(z - radius); k <= z + radius; k++) {
      for (int j = (int) Math.floor(y - radius); j <= y + radius; j++) {
        for (int i = (int) Math.floor(x - radius); i <= x + radius; i++) {
          double squared = (i - x) * (i - x) + (j - y) * (j - y) + (k - z) * (k - z);
          int n = index(Math.floorMod(i, side), Math.floorMod(j, side), Math.floorMod(k, side));
          if (squared < radius * radius && !solid.get(n)) {
            solid.set(n);
            added++;
          }
        }
      }
    }
    return added;
  }

  private int index(int x, int y, int z) {
    return x + side * (y + side * z);
  }

  @Override
  public boolean fluid(int x, int y, int z) {
    return !solid.get(index(x, y, z));
  }

  /** Share of the nodes that are fluid. */
  double porosity() {
    return 1 - (double) solid.cardinality() / ((double) side * side * side);
  }
}
