package org.hdispatch.porous.darcy;

/** Darcy's law in lattice units. */
public final class Darcy {
  private Darcy() {}

  /**
   * Permeability of a rock of length L between two slabs of fluid, B layers each, in a periodic box
   * that a body force drives: k = nu q L / (g (L + 2 B)), for the force acts on the slabs too, and
   * the rock takes up what it adds there.
   *
   * @param viscosity kinematic viscosity nu, voxel²/step
   * @param flux superficial velocity q: mean over the whole rock box, solid included, voxel/step
   * @param force body force per mass g, voxel/step²
   * @param length length L of the rock along the flow, voxels
   * @param layers layers B of fluid at each end
   * @return k in voxel²
   */
  public static double permeability(
      double viscosity, double flux, double force, int length, int layers) {
    return viscosity * flux / force * length / (length + 2.0 * layers);
  }
}
