package org.hdispatch.bench.lbm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class RandomSpheresTest {
  @Test
  void porosityIsThatAskedForLessAtMostOneSphere() {
    double sphere = 4 * Math.PI / 3 * 4 * 4 * 4 / (40.0 * 40 * 40);
    for (double porosity : new double[] {0.1, 0.2, 0.4, 0.8}) {
      double made = new RandomSpheres(40, 4, porosity, 1).porosity();
      assertTrue(made <= porosity && made > porosity - 1.2 * sphere, "porosity=" + made);
    }
  }

  @Test
  void sameSeedGivesTheSameRock() {
    RandomSpheres one = new RandomSpheres(20, 3, 0.3, 7);
    RandomSpheres two = new RandomSpheres(20, 3, 0.3, 7);
    int fluid = 0;
    for (int n = 0; n < 20 * 20 * 20; n++) {
      int x = n % 20;
      int y = n / 20 % 20;
      int z = n / 400;
      assertEquals(one.fluid(x, y, z), two.fluid(x, y, z));
      fluid += one.fluid(x, y, z) ? 1 : 0;
    }
    assertEquals(one.porosity(), fluid / 8000.0, 1e-12);
  }

  @Test
  void refusesRocksThatCannotBe() {
    assertThrows(IllegalArgumentException.class, () -> new RandomSpheres(20, 10, 0.3, 1));
    assertThrows(IllegalArgumentException.class, () -> new RandomSpheres(20, 3, Double.NaN, 1));
  }
}
