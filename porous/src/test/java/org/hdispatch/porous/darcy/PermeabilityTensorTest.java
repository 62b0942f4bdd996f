package org.hdispatch.porous.darcy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.hdispatch.porous.darcy.PermeabilityTensor.Principal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PermeabilityTensorTest {
  private static PermeabilityTensor tensor(double... rowByRow) {
    PermeabilityColumn[] columns = new PermeabilityColumn[3];
    for (int n = 0; n < 3; n++) {
      columns[n] = new PermeabilityColumn(rowByRow[n], rowByRow[3 + n], rowByRow[6 + n]);
    }
    return new PermeabilityTensor(columns[0], columns[1], columns[2]);
  }

  @Test
  void columnsAreWhatFlowsWhileTheGradientActsAlongOneAxis() {
    PermeabilityTensor k = tensor(1, 2, 3, 4, 5, 6, 7, 8, 9);
    assertEquals(new PermeabilityColumn(1, 4, 7), k.alongX());
    assertEquals(new PermeabilityColumn(3, 6, 9), k.alongZ());
    assertEquals(6, k.entry(1, 2));
    assertEquals(tensor(1, 3, 5, 3, 5, 7, 5, 7, 9), k.symmetricPart());
  }

  /** Antisymmetric part 1 off the diagonal six times, symmetric part 30 in squares. */
  @Test
  void asymmetryIsTheShareOfTheAntisymmetricPart() {
    PermeabilityTensor k = tensor(3, 1, 1, -1, 4, 1, -1, -1, Math.sqrt(5));
    assertEquals(Math.sqrt(6.0 / 30), k.asymmetry(), 1e-15);
    assertEquals(0, tensor(0, 0, 0, 0, 0, 0, 0, 0, 0).asymmetry());
    assertEquals(0, tensor(1, 2, 3, 2, 5, 6, 3, 6, 9).asymmetry());
  }

  @Test
  void slitsAt45DegreesHaveTheirPlaneForPrincipalDirections() {
    PermeabilityTensor k = tensor(0.5, 0, 0.5, 0, 0.75, 0, 0.5, 0, 0.5);
    double half = Math.sqrt(0.5);
    List<Principal> found = k.principal();
    double[][] expected = {{1, half, 0, half}, {0.75, 0, 1, 0}, {0, half, 0, -half}};
    for (int n = 0; n < 3; n++) {
      Principal each = found.get(n);
      double sign = n == 2 && each.x() < 0 ? -1 : 1; // both components are the largest
      assertEquals(expected[n][0], each.value(), 1e-15);
      assertEquals(expected[n][1], sign * each.x(), 1e-15);
      assertEquals(expected[n][2], sign * each.y(), 1e-15);
      assertEquals(expected[n][3], sign * each.z(), 1e-15);
    }
    PermeabilityTensor tight = tensor(2, 0, 0, 0, 8, 0, 0, 0, 4);
    assertEquals(4, tight.anisotropy().getAsDouble());
    assertEquals(List.of(8.0, 4.0, 2.0), tight.principal().stream().map(Principal::value).toList());
    assertEquals(new Principal(8, 0, 1, 0), tight.principal().get(0));
  }

  @Test
  void anisotropyIsUnknownWhereNothingFlowsOneWay() {
    assertTrue(tensor(1, 0, 0, 0, 1, 0, 0, 0, 0).anisotropy().isEmpty());
    assertTrue(tensor(0, 0, 0, 0, 0, 0, 0, 0, 0).anisotropy().isEmpty());
    assertTrue(tensor(1, 0, 0, 0, 1, 0, 0, 0, -1e-20).anisotropy().isEmpty());
  }

  /** K v = value v, of any size, from a fixed seed; directions are unit and at right angles. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 1e-13, 1e9})
  void principalValuesAndDirectionsAreThoseOfTheSymmetricPart(double size) {
    Random random = new Random(2011);
    for (int n = 0; n < 200; n++) {
      double[] entries = random.doubles(9).map(each -> size * (each - 0.5)).toArray();
      if (n % 4 == 0) {
        entries[1] = entries[3] = entries[2] = entries[6] = 0; // one axis is principal already
      }
      PermeabilityTensor k = tensor(entries).symmetricPart();
      List<Principal> found = k.principal();
      for (Principal each : found) {
        double[] v = {each.x(), each.y(), each.z()};
        for (int row = 0; row < 3; row++) {
          double product = 0;
          for (int column = 0; column < 3; column++) {
            product += k.entry(row, column) * v[column];
          }
          assertEquals(each.value() * v[row], product, 4e-15 * size); // some ulps of the norm
        }
        double most = Math.max(Math.abs(v[0]), Math.max(Math.abs(v[1]), Math.abs(v[2])));
        assertTrue(most == v[0] || most == v[1] || most == v[2], "largest component is positive");
        for (Principal other : found) {
          double product = v[0] * other.x() + v[1] * other.y() + v[2] * other.z();
          assertEquals(each == other ? 1 : 0, product, 4e-15);
        }
      }
      assertTrue(found.get(0).value() >= found.get(1).value());
      assertTrue(found.get(1).value() >= found.get(2).value());
    }
  }

  @Test
  void refusesWhatIsNoNumber() {
    String message =
        assertThrows(IllegalArgumentException.class, () -> new PermeabilityColumn(1, Double.NaN, 2))
            .getMessage();
    assertTrue(message.contains("y=NaN voxel²"), message);
  }
}
