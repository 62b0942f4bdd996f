package org.hdispatch.app.rock;

import org.hdispatch.app.console.UsageException;
import org.hdispatch.porous.darcy.PhysicalFlow;
import picocli.CommandLine.Option;

/** The fluid and its drive: they set velocities, never k. */
public final class FluidOptions {
  @Option(
      names = "--viscosity",
      paramLabel = "M2_PER_S",
      description = "Kinematic viscosity of the fluid, m2/s.")
  private double viscosity = PhysicalFlow.WATER.viscosity();

  @Option(
      names = "--density",
      paramLabel = "KG_PER_M3",
      description = "Density of the fluid, kg/m3.")
  private double density = PhysicalFlow.WATER.density();

  @Option(
      names = "--pressure-gradient",
      paramLabel = "PA_PER_M",
      description = "Pressure drop per length of rock, Pa/m.")
  private double pressureGradient = PhysicalFlow.WATER.pressureGradient();

  /**
   * The fluid.
   *
   * @throws UsageException if a property is not a positive number
   */
  public PhysicalFlow fluid() {
    return UsageException.orRefused(() -> new PhysicalFlow(viscosity, density, pressureGradient));
  }
}
