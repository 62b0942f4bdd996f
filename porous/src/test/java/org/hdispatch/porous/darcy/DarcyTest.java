package org.hdispatch.porous.darcy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DarcyTest {
  private static final long DUCT_32_33 = 4630417613712655500L;
  private static final long DUCT_37_41 = 4632663446675195031L;

  @Test
  void oneDarcyIsAThousandMilliDarcy() {
    Permeability k = new Permeability(1, OptionalDouble.of(Math.sqrt(Permeability.DARCY)));
    assertEquals(Permeability.DARCY, k.squareMetres().getAsDouble(), 1e-27);
    assertEquals(1000, k.milliDarcy().getAsDouble(), 1e-9);
  }

  /** One voxel² of the Berea image: 2.857e-11 m², 28 948 mD. */
  @Test
  void voxelEdgeEntersSquared() {
    Permeability k = new Permeability(1, OptionalDouble.of(5.345e-6));
    assertEquals(2.857e-11, k.squareMetres().getAsDouble(), 1e-14);
    assertEquals(28_948, k.milliDarcy().getAsDouble(), 1);
  }

  @Test
  void unknownEdgeGivesNoUnits() {
    Permeability k = new Permeability(0.05, OptionalDouble.empty());
    assertTrue(k.squareMetres().isEmpty());
    assertTrue(k.milliDarcy().isEmpty());
    assertTrue(PhysicalFlow.WATER.superficialVelocity(k).isEmpty());
  }

  @Test
  void refusesWhatIsNoPermeability() {
    assertThrows(
        IllegalArgumentException.class, () -> new Permeability(Double.NaN, OptionalDouble.empty()));
    IllegalArgumentException e =
        assertThrows(
            IllegalArgumentException.class, () -> new Permeability(1, OptionalDouble.of(0)));
    assertEquals("voxel edge must be positive, from 1e-15 to 1e3 m: edge=0.0 m", e.getMessage());
  }

  @Test
  void slabsWithoutResistanceOnlyAddToTheDrive() {
    double open = Double.POSITIVE_INFINITY;
    double alone = Darcy.permeability(0.1, 2e-4, 1e-5, 100, 0, open);
    assertEquals(2, alone, 1e-15);
    assertEquals(alone / 1.1, Darcy.permeability(0.1, 2e-4, 1e-5, 100, 5, open), 1e-15);
  }

  /** Where the rock is an empty duct, the slabs are nothing else and must change nothing. */
  @Test
  void slabsOfTheRocksOwnPermeabilityChangeNothing() {
    double k = Darcy.permeability(0.1, 2e-4, 1e-5, 100, 0, Double.POSITIVE_INFINITY);
    assertEquals(k, Darcy.permeability(0.1, 2e-4, 1e-5, 100, 7, k), 1e-15);
  }

  /** Closed forms; the values of the series with 200 odd terms. */
  @ParameterizedTest
  @CsvSource({"1, 0.0351442537", "2, 0.0571704193", "4, 0.0702032396", "10, 0.0780812594"})
  void ductPermeabilityIsThatOfTheSeries(double aspect, double k) {
    assertEquals(k, Darcy.ductPermeability(1, aspect), 1e-10);
    assertEquals(9 * k, Darcy.ductPermeability(3 * aspect, 3), 1e-9);
  }

  @Test
  void slabsNeverTakeMoreThanTheirShareOfTheDrive() {
    double free = Darcy.permeability(0.1, 2e-4, 1e-5, 100, 0, Double.POSITIVE_INFINITY);
    assertEquals(free, Darcy.permeability(0.1, 2e-4, 1e-5, 100, 7, free / 10), 1e-15);
  }

  /** Where tanh of JDK 17 and 25 differ in the last bit, k must not. */
  @Test
  void ductPermeabilityHasTheSameBitsOnEveryJvm() {
    assertEquals(DUCT_32_33, Double.doubleToLongBits(Darcy.ductPermeability(32, 33)));
    assertEquals(DUCT_37_41, Double.doubleToLongBits(Darcy.ductPermeability(37, 41)));
  }

  @Test
  void waterThroughADarcyFollowsDarcysLaw() {
    Permeability k = new Permeability(1, OptionalDouble.of(1e-6)); // 1e-12 m²
    PhysicalFlow flow = new PhysicalFlow(1e-6, 1000, 2000);
    assertEquals(1e-3, flow.dynamicViscosity(), 1e-18);
    assertEquals(2e-6, flow.superficialVelocity(k).getAsDouble(), 1e-18); // 1e-12/1e-3*2000
    assertEquals(2e-3, flow.reynolds(1e-5, 2e-4), 1e-15);
  }

  @Test
  void refusesFluidsThatAreNone() {
    IllegalArgumentException e =
        assertThrows(
            IllegalArgumentException.class, () -> new PhysicalFlow(1e-6, 1000, Double.NaN));
    assertEquals("pressure gradient must be positive: pressure_gradient=NaN Pa/m", e.getMessage());
    assertThrows(IllegalArgumentException.class, () -> new PhysicalFlow(0, 1000, 1));
    assertThrows(IllegalArgumentException.class, () -> new PhysicalFlow(1e-6, -1, 1));
  }
}
