package org.hdispatch.poisson;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Random;
import org.hdispatch.cell.Ends;

/** A random problem in plain arrays: rows of the matrix and clusters, found node by node. */
final class ReferenceProblem {
  final int[] n;
  final double[] mobility;
  final double[] source;
  final double[] force = new double[3];
  final PoissonProblem problem;
  private final Ends[] ends = new Ends[3];
  private final double[] fixed = new double[6]; // by side; NaN: not fixed

  ReferenceProblem(int nx, int ny, int nz, double solid, Random random) {
    n = new int[] {nx, ny, nz};
    PoissonProblem.Builder builder = PoissonProblem.box(nx, ny, nz);
    mobility = new double[nx * ny * nz];
    source = new double[mobility.length];
    for (int i = 0; i < mobility.length; i++) {
      mobility[i] = random.nextDouble() < solid ? 0 : Math.pow(1000, random.nextDouble());
      source[i] = random.nextDouble();
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
    problem =
        builder
            .ends(ends[0], ends[1], ends[2])
            .mobility((x, y, z) -> mobility[index(x, y, z)])
            .build();
  }

  int index(int x, int y, int z) {
    return x + n[0] * (y + n[1] * z);
  }

  /** Node beyond a face, -1 if there is none or it is not active. */
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
    return mobility[other] > 0 ? other : -1;
  }

  private boolean fixedBeyond(int node, Side side) {
    int[] at = {node % n[0], node / n[0] % n[1], node / n[0] / n[1]};
    int axis = side.ordinal() / 2;
    int last = side.ordinal() % 2 == 0 ? 0 : n[axis] - 1;
    return at[axis] == last && !Double.isNaN(fixed[side.ordinal()]);
  }

  /** What flows out of a node, driven by p, the force and the fixed sides. */
  double outflow(int node, double[] p) {
    double flux = 0;
    for (Side side : Side.values()) {
      double g = force[side.ordinal() / 2] * (side.ordinal() % 2 == 0 ? -1 : 1);
      int other = beyond(node, side);
      if (other >= 0) {
        double k = 2 / (1 / mobility[node] + 1 / mobility[other]);
        flux += k * (p[node] - p[other] + g);
      } else if (fixedBeyond(node, side)) {
        flux += 2 * mobility[node] * (p[node] - fixed[side.ordinal()] + g / 2);
      }
    }
    return flux;
  }

  /** Number of the cluster of each node, -1 if not active, -2 - number where a side is fixed. */
  int[] clusters() {
    int[] cluster = new int[mobility.length];
    Arrays.fill(cluster, -1);
    int next = 0;
    boolean[] seen = new boolean[mobility.length];
    for (int start = 0; start < mobility.length; start++) {
      if (mobility[start] > 0 && !seen[start]) {
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
