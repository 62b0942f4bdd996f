package org.hdispatch.sph;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.hdispatch.cell.Ends;
import org.junit.jupiter.api.Test;

class WallsTest {
  private static final double EXACT = 1e-12; // round-off

  @Test
  void slitIsAsFarAsTheNearerPlane() {
    WallDistance walls = Walls.slit(1, 4);
    assertEquals(0.5, walls.at(7, 1.5, 0), EXACT);
    assertEquals(1, walls.at(-3, 3, 2), EXACT);
    assertEquals(-2, walls.at(0, 6, 0), EXACT);
  }

  @Test
  void ductIsAsFarAsItsSidesAndCorners() {
    WallDistance walls = Walls.duct(1, 4, 2, 4);
    assertEquals(0.25, walls.at(0, 2, 2.25), EXACT);
    assertEquals(-1, walls.at(0, 3, 5), EXACT);
    assertEquals(-5, walls.at(0, 1 - 3, 4 + 4), EXACT); // from an edge
  }

  @Test
  void spheresAreTheNearestOfAllTheirImages() {
    ParticleBox box = ParticleBox.space(3, 4, 5, Ends.PERIODIC, Ends.OPEN, Ends.PERIODIC);
    Random random = new Random(11);
    List<Walls.Sphere> spheres = new ArrayList<>();
    for (int n = 0; n < 25; n++) {
      spheres.add(
          new Walls.Sphere(
              3 * random.nextDouble(),
              4 * random.nextDouble(),
              5 * random.nextDouble(),
              0.05 + 0.5 * random.nextDouble()));
    }
    WallDistance walls = Walls.spheres(box, spheres);
    for (int n = 0; n < 2000; n++) {
      double x = 3 * random.nextDouble();
      double y = 4 * random.nextDouble();
      double z = 5 * random.nextDouble();
      double least = Double.POSITIVE_INFINITY;
      for (Walls.Sphere s : spheres) {
        double dx = Math.IEEEremainder(x - s.x(), 3);
        double dz = Math.IEEEremainder(z - s.z(), 5);
        double dy = y - s.y();
        least = Math.min(least, Math.sqrt(dx * dx + dy * dy + dz * dz) - s.radius());
      }
      assertEquals(least, walls.at(x, y, z), EXACT);
      assertEquals(least, walls.at(x - 3, y, z + 5), 4 * EXACT); // a particle not yet put back
    }
  }

  @Test
  void cylindersAreTheSameAtAnyHeight() {
    ParticleBox box = ParticleBox.plane(2, 2, Ends.PERIODIC, Ends.PERIODIC);
    WallDistance walls = Walls.cylinders(box, List.of(new Walls.Cylinder(0.1, 1, 0.3)));
    assertEquals(0.7, walls.at(1.1, 1, 0), EXACT);
    assertEquals(0.1, walls.at(1.7, 1, 9), EXACT); // through the end of the box
    assertEquals(-0.3, walls.at(0.1, 1, 0), EXACT);
  }

  @Test
  void badWallsAreRefusedInOneLine() {
    ParticleBox plane = ParticleBox.plane(1, 1, Ends.PERIODIC, Ends.PERIODIC);
    refused(() -> Walls.slit(2, 2), "low=2.0, high=2.0");
    refused(() -> Walls.duct(0, 1, 3, 2), "along z");
    refused(() -> Walls.cylinders(plane, List.of()), "bodies=0");
    refused(() -> Walls.spheres(plane, List.of()), "dimensions=2");
    refused(() -> new Walls.Cylinder(0, 0, -1), "r=-1.0");
    refused(() -> new Walls.Sphere(0, 0, 0, Double.NaN), "r=NaN");
  }

  private static void refused(Runnable what, String text) {
    IllegalArgumentException thrown = assertThrows(IllegalArgumentException.class, what::run);
    assertTrue(thrown.getMessage().contains(text), thrown.getMessage());
  }
}
