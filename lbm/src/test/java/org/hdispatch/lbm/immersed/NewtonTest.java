package org.hdispatch.lbm.immersed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.hdispatch.cell.Ends;
import org.hdispatch.lbm.Lattice;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Motion without the fluid's force. */
class NewtonTest {
  private static final Lattice BOX =
      Lattice.empty(100, 100, 100, Ends.PERIODIC, Ends.OPEN, Ends.OPEN);
  private static final double DENSE = 1e9; // the fluid inside weighs nothing

  private static void run(Contact contact, Point gravity, int steps, Body... bodies) {
    Newton newton = new Newton(bodies, BOX, gravity, contact);
    for (int step = 0; step < steps; step++) {
      newton.step();
    }
  }

  @Test
  void bodyFallsByItsWeightLessBuoyancy() {
    Body dense = Body.free(new Sphere(2), DENSE, new Point(50, 50, 50));
    run(Contact.DEFAULT, new Point(0, 0, -1e-3), 100, dense);
    assertEquals(-0.1, dense.uz(), 1e-9); // 1/density
    assertEquals(50 - 1e-3 * 100 * 101 / 2, dense.z(), 1e-7); // leapfrog: half a step ahead
    // In a vacuum that still buoys, m a = m_f a' + (m - m_f) g tends to a = g.
    Body twice = Body.free(new Sphere(2), 2, new Point(50, 50, 50));
    run(Contact.DEFAULT, new Point(0, 0, -1e-3), 100, twice);
    assertEquals(-1e-3 * (100 - 1), twice.uz(), 1e-9); // the first steps lack 1/2 + 1/4 + ...
  }

  @ParameterizedTest
  @CsvSource({"1, 2", "0.8, 2", "0.5, 2", "0.8, 10", "0.8, 0.5"})
  void collisionsReturnTheRestitution(double restitution, double duration) {
    Contact contact = new Contact(duration, restitution);
    Body one = Body.free(new Sphere(3), DENSE, new Point(95, 50, 50));
    Body other = Body.free(new Sphere(2), DENSE, new Point(104, 50, 50)); // across the end
    one.moveAt(0.05, 0, 0);
    other.moveAt(-0.02, 0, 0);
    run(contact, Point.ZERO, 200, one, other);
    assertEquals(restitution, (other.ux() - one.ux()) / 0.07, 0.03); // 4 to 80 steps a collision
    double momentum = one.mass() * one.ux() + other.mass() * other.ux();
    assertEquals(one.mass() * 0.05 - other.mass() * 0.02, momentum, 1e-9 * one.mass());
    Body fast = Body.free(new Sphere(2), DENSE, new Point(50, 50, 4));
    fast.moveAt(0.01, 0, -0.08);
    run(contact, Point.ZERO, 100, fast);
    assertEquals(restitution, fast.uz() / 0.08, 0.03); // the same
    assertEquals(0.01, fast.ux(), 0); // no friction
  }

  @Test
  void sphereBouncesOffAFixedOneAndOffAWallWithoutLoss() {
    Body fixed = Body.fixed(new Sphere(5), new Point(50, 50, 50));
    Body free = Body.free(new Sphere(2), 4, new Point(50, 50, 60));
    free.moveAt(0, 0, -0.1);
    Contact elastic = new Contact(2, 1);
    run(elastic, Point.ZERO, 100, fixed, free);
    assertEquals(50, fixed.z(), 0);
    Body dense = Body.free(new Sphere(2), DENSE, new Point(50, 50, 60));
    dense.moveAt(0, 0, -0.1);
    run(elastic, Point.ZERO, 100, fixed, dense);
    assertEquals(0.1, dense.uz(), 3e-3); // 20 steps in each of the two of a collision
  }

  @Test
  void spheresComeToRestOnTheFloorAndOnEachOther() {
    double g = 1e-4;
    Body low = Body.free(new Sphere(2), DENSE, new Point(50, 50, 2.5));
    Body high = Body.free(new Sphere(3), DENSE, new Point(50, 50, 9));
    run(Contact.DEFAULT, new Point(0, 0, -g), 3_000, low, high);
    assertEquals(0, low.uz(), 1e-9); // nothing left of 0.02
    assertEquals(0, high.uz(), 1e-9);
    assertEquals(1.5, low.z(), 1e-3); // overlap: (1 + m_high/m_low) g over spring/mass, 10/4
    assertEquals(6.5, high.z(), 1e-3);
  }

  @Test
  void refusesContactsThatNeverEnd() {
    assertThrows(IllegalArgumentException.class, () -> new Contact(0, 1));
    assertThrows(IllegalArgumentException.class, () -> new Contact(1, 0));
    assertThrows(IllegalArgumentException.class, () -> new Contact(1, 1.1));
  }
}
