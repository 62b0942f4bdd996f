package org.hdispatch.poisson;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Random;
import org.hdispatch.cell.Ends;

/** A random problem in plain arrays: rows of the matrix and clusters, found node by node. */
final class ReferenceProblem {
  final int[] n;
  final int nodes;
  private final double[][] mobility; // along each axis, by node
  final double[] source;
  final double[] force = new double[3];
  final PoissonProblem problem;
  private final Ends[] ends = new Ends[3];
  private final double[] fixed = new double[6]; // by side; NaN: not fixed

  /**
   * A problem.
   *
   * @param solid share of nodes without mobility, along each axis by itself if they differ
   * @param axes 1: one mobility for all axes, 3: one for each
   */
  ReferenceProblem(int nx, int ny, int nz, double solid, int axes, Random random) {
    n = new int[] {nx, ny, nz};
    PoissonProblem.Builder builder = PoissonProblem.box(nx, ny, nz);
    nodes = nx * ny * nz;
    mobility = new double[3][nodes];
    source = new double[nodes];
    for (int i = 0; i < nodes; i++) {
      for (int axis = 0; axis < 3; axis++) {
        mobility[axis][i] =
            axis >= axes
                ? mobility[0][i]
                : random.nextDouble() < solid ? 0 : Math.pow(1000, random.nextDouble());
      }
      source[i] = random.nextDouble();
    }
    if (axes == 1) {
      builder.mobility((x, y, z) -> mobility[0][index(x, y, z)]);
    } else {
      builder.mobility(
          (x, y, z) -> mobility[0][index(x, y, z)],
          (x, y, z) -> mobility[1][index(x, y, z)],
          (x, y, z) -> mobility[2][index(x, y, z)]);
    }
    for (int axis = 0; axis < 3; axis++) {
      ends[axis] = random.nextBoolean() ? Ends.PERIODIC : Ends.OPEN;
      force[axis] = random.nextDouble() - 0.5;
    }
    for (Side side : Side.values()) {
      fixed[side.ordinal()] = Double.NaN;
      if (ends[side.axis()] == Ends.OPEN && random.nextInt(3) == 0) {
        fixed[side.ordinal()] = random.nextDouble();
        builder.fixed(side, fixed[side.ordinal()]);
      }
    }
    problem = builder.ends(ends[0], ends[1], ends[2]).build();
  }

  int index(int x, int y, int z) {
    return x + n[0] * (y + n[1] * z);
  }

  private boolean isActive(int node) {
    return mobility[0][node] > 0 || mobility[1][node] > 0 || mobility[2][node] > 0;
  }

  /** Node beyond a face, -1 if there is none or nothing flows to it. */
  private int beyond(int node, Side side) {
    int[] at = {node % n[0], node / n[0] % n[1], node / n[0] / n[1]};
    int axis = side.ordinal() / 2;
    at[axis] += side.ordinal() % 2 == 0 ? -1 : 1;
    if (at[axis] < 0 || at[axis] >= n[axis]) {
      if (ends[axis] == Ends.OPEN) {
        return -1;
      }
      at[axis] = (at[axis] + n[axis]) % n[axis];
    }
    int other = index(at[0], at[1], at[2]);
    return mobility[axis][node] > 0 && mobility[axis][other] > 0 ? other : -1;
  }

  private boolean fixedBeyond(int node, Side side) {
    int[] at = {node % n[0], node / n[0] % n[1], node / n[0] / n[1]};
    int axis = side.ordinal() / 2;
    int last = side.ordinal() % 2 == 0 ? 0 : n[axis] - 1;
    return at[axis] == last && mobility[axis][node] > 0 && !Double.isNaN(fixed[side.ordinal()]);
  }

  /** What flows out of a node, driven by p, the force and the fixed sides. */
  double outflow(int node, double[] p) {
    double flux = 0;
    for (Side side : Side.values()) {
      double[] along = mobility[side.ordinal() / 2];
      double g = force[side.ordinal() / 2] * (side.ordinal() % 2 == 0 ? -1 : 1);
      int other = beyond(node, side);
      if (other >= 0) {
        double k = 2 / (1 / along[node] + 1 / along[other]);
        flux += k * (p[node] - p[other] + g);
      } else if (fixedBeyond(node, side)) {
        flux += 2 * along[node] * (p[node] - fixed[side.ordinal()] + g / 2);
      }
    }
    return flux;
  }

  /** Number of the cluster of each node, -1 if not active, -2 - number where a side is fixed. */
  int[] clusters() {
    int[] cluster = new int[nodes];
    Arrays.fill(cluster, -1);
    int next = 0;
    boolean[] seen = new boolean[nodes];
    for (int start = 0; start < nodes; start++) {
      if (isActive(start) && !seen[start]) {
        ArrayDeque<Integer> queue = new ArrayDeque<>();
        ArrayDeque<Integer> members = new ArrayDeque<>();
        queue.add(start);
        seen[start] = true;
        boolean anyFixed = false;
        while (!queue.isEmpty()) {
          int node = queue.remove();
          members.add(node);
          for (Side side : Side.values()) {
            anyFixed |= fixedBeyond(node, side);
            int other = beyond(node, side);
            if (other >= 0 && !seen[other]) {
              seen[other] = true;
              queue.add(other);
            }
          }
        }
        int number = anyFixed ? -2 - next : next;
        members.forEach(node -> cluster[node] = number);
        next++;
      }
    }
    return cluster;
  }
}
