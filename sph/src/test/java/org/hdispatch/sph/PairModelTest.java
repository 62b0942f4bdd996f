package org.hdispatch.sph;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class PairModelTest {
  private static final double MU = 0.7;
  private static final int REACH = 3; // particles of the lattice on each side of the one asked for
  private static final double DISTANCE = 0.5; // of that one from the walls

  /** How deep a place lies in the walls. */
  private interface Depth {
    double at(int x, int y);
  }

  /**
   * With w_m = -2 sum (dW/dr)/r over the m-th layer away, 1 - s = w_1/4 + 3/2 w_2; w_1 = 0.867263
   * and w_2 = 0.033435 come of sums apart from this code.
   */
  @ParameterizedTest
  @EnumSource(ViscosityMean.class)
  void shareIsWhatPlaneWallsLeave(ViscosityMean mean) {
    double oneWall = 0.867263 / 4 + 0.033435 * 3 / 2;
    assertEquals(1, share(mean, (x, y) -> 0));
    assertEquals(1 - oneWall, share(mean, (x, y) -> y < 0 ? -y - 0.5 : 0), 1e-5);
    assertEquals(1 - 2 * oneWall, share(mean, (x, y) -> y == 0 ? 0 : Math.abs(y) - 0.5), 1e-5);
  }

  /** A duct one particle wide would ask for less than nothing. */
  @ParameterizedTest
  @EnumSource(ViscosityMean.class)
  void someShareIsLeftInTheNarrowestDuct(ViscosityMean mean) {
    assertEquals(PairModel.LEAST_SHARE, share(mean, (x, y) -> Math.max(0, Math.hypot(x, y) - 0.5)));
  }

  /** Share of the particle in the middle of a lattice. */
  private static double share(ViscosityMean mean, Depth depth) {
    PairModel model = new PairModel(new QuinticSpline(1, 3), mean, Double.NaN, true, 4);
    int edge = 2 * REACH + 1;
    int count = edge * edge * edge;
    double[][] planes = new double[Neighbourhood.PHASE][count];
    for (int n = 0; n < count; n++) {
      int x = n % edge - REACH;
      int y = n / edge % edge - REACH;
      planes[Neighbourhood.X][n] = x;
      planes[Neighbourhood.Y][n] = y;
      planes[Neighbourhood.Z][n] = n / (edge * edge) - REACH;
      planes[Neighbourhood.DEPTH][n] = depth.at(x, y);
    }
    Arrays.fill(planes[Neighbourhood.VOLUME], 1);
    Arrays.setAll(
        planes[Neighbourhood.VISCOSITY],
        n -> model.plane(planes[Neighbourhood.DEPTH][n] > 0 ? Phase.TOUCHED : MU));
    Neighbourhood near = Neighbourhood.of(planes, count / 2, 1, new double[] {1 / DISTANCE});
    NeighbourList list = new NeighbourList();
    PairSums sums = SumForm.SCALAR.of(model).get();
    sums.search(near, REACH, list);
    double[] share = new double[1];
    sums.force(near, list, new double[1], new double[1], new double[1], share);
    return share[0];
  }
}
