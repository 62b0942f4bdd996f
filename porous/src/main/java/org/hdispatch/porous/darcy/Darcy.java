package org.hdispatch.porous.darcy;

/** Darcy's law in lattice units. */
public final class Darcy {
  private Darcy() {}

  /**
   * Permeability of a rock of length L between two slabs of fluid, B layers each, in a periodic box
   * that a body force drives. The force acts on the slabs too, and the rock takes up what it adds
   * there, but for the little that the slabs need for themselves:
   *
   * <pre>
   *   g (L + 2 B) = nu q (L/k + 2 B/k_slab)
   * </pre>
   *
   * For rock, k is so much less than k_slab that this is k = nu q L/(g (L + 2 B)). The slabs never
   * take more than their own length of the drive, so that k is at most nu q/g: no rock is more
   * permeable than the empty cross-section.
   *
   * @param viscosity kinematic viscosity nu, voxel²/step
   * @param flux superficial velocity q: mean over the whole rock box, solid included, voxel/step
   * @param force body force per mass g, voxel/step²
   * @param length length L of the rock along the flow, voxels
   * @param layers layers B of fluid at each end
   * @param slab permeability k_slab of the empty cross-section, voxel²; infinite without walls
   * @return k in voxel²
   */
  public static double permeability(
      double viscosity, double flux, double force, int length, int layers, double slab) {
    double drive = force * (length + 2.0 * layers) - viscosity * flux * 2 * layers / slab;
    return viscosity * flux * length / Math.max(drive, force * length);
  }

  /**
   * Permeability of an empty rectangular duct, sides 2a and 2b with a not above b (White, Viscous
   * Fluid Flow, eq. 3-48):
   *
   * <pre>
   *   k = a²/3 (1 - 192 a/(pi⁵ b) sum_{i = 1, 3, 5 ...} tanh(i pi b/(2 a))/i⁵)
   * </pre>
   *
   * <p>Strict: the same bits on every JVM.
   *
   * @param width one side, voxels
   * @param height the other side, voxels
   * @return k in voxel²
   */
  public static double ductPermeability(double width, double height) {
    double a = Math.min(width, height) / 2;
    double b = Math.max(width, height) / 2;
    double sum = 0;
    for (int i = 1; i < 200; i += 2) {
      sum += StrictMath.tanh(i * Math.PI * b / (2 * a)) / StrictMath.pow(i, 5);
    }
    return a * a / 3 * (1 - 192 * a / (StrictMath.pow(Math.PI, 5) * b) * sum);
  }
}
