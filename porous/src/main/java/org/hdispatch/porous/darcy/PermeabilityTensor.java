package org.hdispatch.porous.darcy;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;

/**
 * A full permeability tensor K of Darcy's law q = -K/mu grad p, from one flow along each axis.
 * Units: voxel².
 *
 * <p>In periodic rock K is symmetric and has no negative principal value (Stokes flow is
 * reciprocal); what is computed is so up to the errors of its columns, and {@link #asymmetry} shows
 * them. Every bit is the same on every JVM.
 *
 * @param alongX the column of a pressure gradient along x
 * @param alongY the column of a pressure gradient along y
 * @param alongZ the column of a pressure gradient along z
 */
public record PermeabilityTensor(
    PermeabilityColumn alongX, PermeabilityColumn alongY, PermeabilityColumn alongZ) {
  /** Sweeps of Jacobi's method; they converge quadratically, so that a handful is enough. */
  private static final int MOST_SWEEPS = 32;

  /**
   * A principal value of the symmetric part.
   *
   * @param value the permeability along the direction, voxel²
   * @param x first component of the direction, a unit vector whose largest component is positive
   * @param y second component
   * @param z third component
   */
  public record Principal(double value, double x, double y, double z) {}

  private PermeabilityColumn column(int column) {
    return column == 0 ? alongX : column == 1 ? alongY : alongZ;
  }

  /**
   * An entry, voxel².
   *
   * @param row direction of the flux: 0, 1, 2 for x, y, z
   * @param column direction of the pressure gradient
   */
  public double entry(int row, int column) {
    return column(column).entry(row);
  }

  /** The symmetric part, (K + K^T)/2. */
  public PermeabilityTensor symmetricPart() {
    double xy = (entry(0, 1) + entry(1, 0)) / 2;
    double xz = (entry(0, 2) + entry(2, 0)) / 2;
    double yz = (entry(1, 2) + entry(2, 1)) / 2;
    return new PermeabilityTensor(
        new PermeabilityColumn(entry(0, 0), xy, xz),
        new PermeabilityColumn(xy, entry(1, 1), yz),
        new PermeabilityColumn(xz, yz, entry(2, 2)));
  }

  /**
   * How far the tensor is from symmetric: norm of the antisymmetric part over that of the symmetric
   * one (Frobenius); 0 where all is 0.
   */
  public double asymmetry() {
    double symmetric = 0;
    double antisymmetric = 0;
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        double sum = (entry(row, column) + entry(column, row)) / 2;
        double difference = (entry(row, column) - entry(column, row)) / 2;
        symmetric += sum * sum;
        antisymmetric += difference * difference;
      }
    }
    return antisymmetric == 0 ? 0 : Math.sqrt(antisymmetric / symmetric);
  }

  /**
   * Principal values and directions of the symmetric part, the greatest first, by Jacobi's method
   * (Golub, Van Loan, Matrix Computations, 4th ed., 8.5). Where values are equal, their directions
   * are any that are at right angles.
   */
  public List<Principal> principal() {
    double[][] a = new double[3][3];
    double[][] v = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    PermeabilityTensor symmetric = symmetricPart();
    double norm = 0;
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        a[row][column] = symmetric.entry(row, column);
        norm += a[row][column] * a[row][column];
      }
    }
    double rounding = Math.ulp(1.0) * Math.ulp(1.0) * norm;
    for (int sweep = 0; sweep < MOST_SWEEPS && outside(a) > rounding; sweep++) {
      rotate(a, v, 0, 1);
      rotate(a, v, 0, 2);
      rotate(a, v, 1, 2);
    }
    List<Principal> found = new ArrayList<>();
    for (int n = 0; n < 3; n++) {
      found.add(principal(a[n][n], v[0][n], v[1][n], v[2][n]));
    }
    found.sort(Comparator.comparingDouble(Principal::value).reversed());
    return List.copyOf(found);
  }

  private static Principal principal(double value, double x, double y, double z) {
    double most = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    boolean turned = x == -most || x != most && (y == -most || y != most && z == -most);
    double sign = turned ? -1 : 1;
    return new Principal(value, sign * x + 0.0, sign * y + 0.0, sign * z + 0.0); // no -0
  }

  private static double outside(double[][] a) {
    return a[0][1] * a[0][1] + a[0][2] * a[0][2] + a[1][2] * a[1][2];
  }

  /** Turns the axes p and q so that a[p][q] becomes 0. */
  private static void rotate(double[][] a, double[][] v, int p, int q) {
    if (a[p][q] == 0) {
      return;
    }
    double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    double t = 1 / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
    t = theta < 0 ? -t : t;
    double c = 1 / Math.sqrt(t * t + 1);
    double s = t * c;
    double step = t * a[p][q];
    a[p][p] -= step;
    a[q][q] += step;
    a[p][q] = 0;
    a[q][p] = 0;
    int r = 3 - p - q;
    double rp = a[r][p];
    double rq = a[r][q];
    a[r][p] = c * rp - s * rq;
    a[p][r] = a[r][p];
    a[r][q] = s * rp + c * rq;
    a[q][r] = a[r][q];
    for (double[] row : v) {
      double vp = row[p];
      row[p] = c * vp - s * row[q];
      row[q] = s * vp + c * row[q];
    }
  }

  /**
   * How many times the greatest principal value is the least; empty where the least is not
   * positive.
   */
  public OptionalDouble anisotropy() {
    List<Principal> found = principal();
    double least = found.get(2).value();
    return least > 0 ? OptionalDouble.of(found.get(0).value() / least) : OptionalDouble.empty();
  }
}
