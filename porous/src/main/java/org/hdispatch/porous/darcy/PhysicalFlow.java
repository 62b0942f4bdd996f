package org.hdispatch.porous.darcy;

import java.io.Serializable;
import java.util.OptionalDouble;

/**
 * A fluid and the pressure gradient that drives it, in SI units. They set velocities and the
 * Reynolds number; a permeability does not depend on them.
 *
 * @param viscosity kinematic viscosity, m²/s
 * @param density density, kg/m³
 * @param pressureGradient pressure drop per length, Pa/m
 */
public record PhysicalFlow(double viscosity, double density, double pressureGradient)
    implements Serializable {
  private static final double LEAST = 1e-30;
  private static final double MOST = 1e30;

  /** Water at 20 °C under 1 kPa/m. */
  public static final PhysicalFlow WATER = new PhysicalFlow(1e-6, 1000, 1000);

  /**
   * Checks that all are positive.
   *
   * @throws IllegalArgumentException if one is not a number from 1e-30 to 1e30
   */
  public PhysicalFlow {
    requirePositive("viscosity", viscosity, "m2/s");
    requirePositive("density", density, "kg/m3");
    requirePositive("pressure gradient", pressureGradient, "Pa/m");
  }

  private static void requirePositive(String name, double value, String unit) {
    if (!(value >= LEAST && value <= MOST)) {
      String must = value > 0 ? " must lie between 1e-30 and 1e30: " : " must be positive: ";
      throw new IllegalArgumentException(
          name + must + name.replace(' ', '_') + "=" + value + " " + unit);
    }
  }

  /** Dynamic viscosity, Pa s. */
  public double dynamicViscosity() {
    return viscosity * density;
  }

  /** Superficial (Darcy) velocity q = k/mu dp/dx, m/s, if the voxel edge is known. */
  public OptionalDouble superficialVelocity(Permeability k) {
    OptionalDouble k2 = k.squareMetres();
    return k2.isEmpty()
        ? k2
        : OptionalDouble.of(k2.getAsDouble() / dynamicViscosity() * pressureGradient);
  }

  /**
   * Reynolds number of the mean pore velocity and the hydraulic diameter.
   *
   * @param poreVelocity mean velocity within the pores, m/s
   * @param hydraulicDiameter hydraulic diameter of the pores, m
   */
  public double reynolds(double poreVelocity, double hydraulicDiameter) {
    return poreVelocity * hydraulicDiameter / viscosity;
  }
}
