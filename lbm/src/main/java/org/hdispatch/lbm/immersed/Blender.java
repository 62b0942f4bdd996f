package org.hdispatch.lbm.immersed;

import java.util.Arrays;
import org.hdispatch.cell.CellMap;
import org.hdispatch.lbm.Equilibrium;
import org.hdispatch.lbm.Immersion;
import org.hdispatch.lbm.NodalBundle;
import org.hdispatch.lbm.VelocitySet;

/**
 * The immersed collision of one worker's chunks.
 *
 * <pre>
 *   f' = f + (1 - B) (f* - f) + sum_s B_s Omega_s
 *   Omega_s,i = f_-i - f_i + f_eq,i(rho, u_s) - f_eq,-i(rho, u)
 * </pre>
 *
 * with f* the populations collided as fluid, body force included (so that the force too counts by 1
 * - B), and Omega_s the bounce-back of the non-equilibrium part (Noble, Torczynski 1998). u is the
 * momentum before collision over rho, u_s the body's velocity at the node. B is the weight of the
 * node's whole solid fraction; where several bodies share a node, each has its share of it.
 *
 * <p>Mass is conserved node by node. The momentum that the body takes is B_s (j - rho u_s): summed,
 * its force, and with the arm its torque.
 */
final class Blender implements Immersion.Worker {
  private final VelocitySet set;
  private final boolean quadratic;
  private final double relaxationTime;
  private final Covering covering;
  private final CellMap<Vicinity> vicinities;
  private final Body[] bodies;

  private Vicinity vicinity;
  private final Overlaps overlaps;
  private final double[] solid; // by node of the chunk
  private final int[] slot; // by node of the chunk: number among the covered ones

  // By number of the covered node:
  private int covered;
  private final int[] node;
  private final double[] weight;
  private final double[] density; // rho - 1
  private final double[] jx;
  private final double[] jy;
  private final double[] jz;
  private final double[][] kept;

  // By overlap: B_s, and the moments of the solid's equilibrium.
  private double[] share = {};
  private double[] sumX = {};
  private double[] sumY = {};
  private double[] sumZ = {};
  private double[] vx = {};
  private double[] vy = {};
  private double[] vz = {};

  Blender(
      VelocitySet set,
      Equilibrium equilibrium,
      double relaxationTime,
      Covering covering,
      CellMap<Vicinity> vicinities,
      Body[] bodies) {
    this.set = set;
    quadratic = equilibrium == Equilibrium.QUADRATIC;
    this.relaxationTime = relaxationTime;
    this.covering = covering;
    this.vicinities = vicinities;
    this.bodies = bodies;
    int chunk = Covering.CHUNK;
    overlaps = new Overlaps(2 * chunk);
    solid = new double[chunk];
    slot = new int[chunk];
    node = new int[chunk];
    weight = new double[chunk];
    density = new double[chunk];
    jx = new double[chunk];
    jy = new double[chunk];
    jz = new double[chunk];
    kept = new double[set.size()][chunk];
    makeRoom(overlaps.node.length);
  }

  @Override
  public boolean enter(NodalBundle bundle) {
    vicinity = vicinities.get(bundle.key());
    vicinity.met = 0;
    vicinity.blocked = 0;
    return covering.enter(bundle, vicinity) | vicinity.fixed.count > 0;
  }

  @Override
  public int keep(double[][] rows, int[] numbers, int nodes) {
    overlaps.count = 0;
    Overlaps fixed = vicinity.fixed;
    for (int k = 0; k < nodes && fixed.count > 0; k++) {
      int end = vicinity.fixedFrom[numbers[k] + 1];
      for (int n = vicinity.fixedFrom[numbers[k]]; n < end; n++) {
        overlaps.add(k, fixed.body[n], fixed.fraction[n], fixed.x[n], fixed.y[n], fixed.z[n]);
      }
    }
    covering.find(numbers, nodes, overlaps);
    if (overlaps.count > 0) {
      number(nodes);
      copy(rows);
    }
    return overlaps.count;
  }

  /** Numbers the covered nodes in the order of their first overlap. */
  private void number(int nodes) {
    Arrays.fill(solid, 0, nodes, 0);
    covered = 0;
    for (int n = 0; n < overlaps.count; n++) {
      int k = overlaps.node[n];
      if (solid[k] == 0) {
        slot[k] = covered;
        node[covered++] = k;
      }
      solid[k] += overlaps.fraction[n];
    }
    for (int c = 0; c < covered; c++) {
      weight[c] = Weighting.of(Math.min(1, solid[node[c]]), relaxationTime);
      vicinity.blocked += weight[c];
    }
  }

  private void copy(double[][] rows) {
    Arrays.fill(jx, 0, covered, 0);
    Arrays.fill(jy, 0, covered, 0);
    Arrays.fill(jz, 0, covered, 0);
    Arrays.fill(density, 0, covered, 0);
    for (int i = 0; i < rows.length; i++) {
      double[] row = rows[i];
      double[] copy = kept[i];
      for (int c = 0; c < covered; c++) {
        copy[c] = row[node[c]];
      }
      add(density, copy, 1);
      add(jx, copy, set.cx(i));
      add(jy, copy, set.cy(i));
      add(jz, copy, set.cz(i));
    }
  }

  private void add(double[] sum, double[] row, int c) {
    if (c == 1) {
      for (int k = 0; k < covered; k++) {
        sum[k] += row[k];
      }
    } else if (c == -1) {
      for (int k = 0; k < covered; k++) {
        sum[k] -= row[k];
      }
    }
  }

  @Override
  public void blend(double[][] rows) {
    weigh();
    fade(rows[0], kept[0]);
    if (quadratic) {
      rest(rows[0]);
    }
    for (int i = 1; i < rows.length; i += 2) {
      fade(rows[i + 1], kept[i]);
      fade(rows[i], kept[i + 1]);
      bounce(rows, i);
    }
  }

  /** Velocities and shares of all overlaps, and the loads on the bodies. */
  private void weigh() {
    makeRoom(overlaps.count);
    for (int n = 0; n < overlaps.count; n++) {
      int k = overlaps.node[n];
      int c = slot[k];
      Body body = bodies[overlaps.body[n]];
      double x = overlaps.x[n];
      double y = overlaps.y[n];
      double z = overlaps.z[n];
      double sx = body.ux() + body.wy() * z - body.wz() * y;
      double sy = body.uy() + body.wz() * x - body.wx() * z;
      double sz = body.uz() + body.wx() * y - body.wy() * x;
      double b = weight[c] * (overlaps.fraction[n] / solid[k]);
      double rho = quadratic ? 1 + density[c] : 1;
      double px = b * (jx[c] - rho * sx);
      double py = b * (jy[c] - rho * sy);
      double pz = b * (jz[c] - rho * sz);
      share[n] = b;
      vx[n] = sx;
      vy[n] = sy;
      vz[n] = sz;
      sumX[n] = rho * sx + jx[c];
      sumY[n] = rho * sy + jy[c];
      sumZ[n] = rho * sz + jz[c];
      int at = vicinity.load(overlaps.body[n]);
      double[] loads = vicinity.loads;
      loads[at] += px;
      loads[at + 1] += py;
      loads[at + 2] += pz;
      loads[at + 3] += y * pz - z * py;
      loads[at + 4] += z * px - x * pz;
      loads[at + 5] += x * py - y * px;
      loads[at + 6] += b;
    }
  }

  private void makeRoom(int count) {
    if (count > share.length) {
      int capacity = overlaps.node.length;
      share = new double[capacity];
      sumX = new double[capacity];
      sumY = new double[capacity];
      sumZ = new double[capacity];
      vx = new double[capacity];
      vy = new double[capacity];
      vz = new double[capacity];
    }
  }

  /** f + (1 - B)(f* - f); f* stands in the row of the opposite velocity. */
  private void fade(double[] row, double[] before) {
    for (int c = 0; c < covered; c++) {
      int k = node[c];
      row[k] = before[c] + (1 - weight[c]) * (row[k] - before[c]);
    }
  }

  /** The rest population: the even part alone. */
  private void rest(double[] row) {
    double w = set.weight(0);
    for (int n = 0; n < overlaps.count; n++) {
      int c = slot[overlaps.node[n]];
      row[node[c]] += share[n] * w * squares(n, c, 0, 0, 0);
    }
  }

  /**
   * A pair of velocities: the odd part is f_-i - f_i + 3 w c.(rho u_s + j), the even part w rho
   * (9/2 (c.u_s)² - 3/2 u_s² - 9/2 (c.u)² + 3/2 u²), with the quadratic equilibrium only.
   */
  private void bounce(double[][] rows, int i) {
    double[] row = rows[i + 1]; // what leaves along velocity i
    double[] opposite = rows[i];
    double[] before = kept[i];
    double[] beforeOpposite = kept[i + 1];
    int cx = set.cx(i);
    int cy = set.cy(i);
    int cz = set.cz(i);
    double w = set.weight(i);
    for (int n = 0; n < overlaps.count; n++) {
      int c = slot[overlaps.node[n]];
      int k = node[c];
      double along = cx * sumX[n] + cy * sumY[n] + cz * sumZ[n];
      double odd = beforeOpposite[c] - before[c] + 3 * w * along;
      double even = quadratic ? w * squares(n, c, cx, cy, cz) : 0;
      row[k] += share[n] * (even + odd);
      opposite[k] += share[n] * (even - odd);
    }
  }

  private double squares(int n, int c, int cx, int cy, int cz) {
    double rho = 1 + density[c];
    double solidAlong = cx * vx[n] + cy * vy[n] + cz * vz[n];
    double fluidAlong = cx * jx[c] + cy * jy[c] + cz * jz[c];
    double ofSolid = vx[n] * vx[n] + vy[n] * vy[n] + vz[n] * vz[n];
    double ofFluid = jx[c] * jx[c] + jy[c] * jy[c] + jz[c] * jz[c];
    return rho * (4.5 * solidAlong * solidAlong - 1.5 * ofSolid)
        - (4.5 * fluidAlong * fluidAlong - 1.5 * ofFluid) / rho;
  }
}
