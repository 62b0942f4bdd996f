package org.hdispatch.lbm;

import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;

/**
 * The faces that bound some axes of a lattice in place of walls, half a spacing outside the first
 * and last nodes. Beyond a face lies the mirror image of the nodes before it:
 *
 * <ul>
 *   <li>beyond a symmetry face with the mirrored flow: f_i = f_s, where f_s is what leaves the
 *       mirrored place along the mirrored velocity. Fluid slips along the face; nothing passes.
 *   <li>beyond a pressure face with the mirrored flow turned round, about the density rho of the
 *       face: f_i = 2 w_i rho - f_s. The density is rho at the face and fluid passes it at right
 *       angles. This is anti-bounce-back, but for oblique velocities from the mirrored place
 *       instead of the node itself: else the face would bear no shear stress, and not even a
 *       parabola would pass it unchanged.
 * </ul>
 *
 * <p>The streaming plan takes a face for a wall, so that what left a node through it stands in the
 * node's own slot, whatever the streaming, and nobody else reads that slot. A pass before the
 * collision exchanges these slots, two by two ({@link FaceLinks}); each pair belongs to one bundle.
 * Between steps they hold what left the nodes, like all others.
 */
final class Faces {
  /** Kinds of faces. */
  static final int SYMMETRY = 0;

  static final int FIRST = 1;
  static final int LAST = 2;

  private final VelocitySet set;
  private final boolean[] symmetric; // per axis
  private final int pressureAxis; // -1: none
  private final double[][] sum = new double[LAST + 1][]; // f_i + f_s less weights, by kind

  /**
   * Checks that lattice and equilibrium can have such faces.
   *
   * @param symmetric whether an axis has symmetry faces, for each axis
   * @param pressureAxis axis of the pressure faces; -1: none
   * @throws IllegalArgumentException if an axis with faces is periodic or has faces of both kinds,
   *     or if there are pressure faces and the equilibrium is not linear
   */
  Faces(
      Lattice lattice,
      VelocitySet set,
      Equilibrium equilibrium,
      boolean[] symmetric,
      int pressureAxis) {
    this.set = set;
    this.symmetric = symmetric.clone();
    this.pressureAxis = pressureAxis;
    Ends[] ends = {lattice.x(), lattice.y(), lattice.z()};
    for (int axis = 0; axis < ends.length; axis++) {
      if (isBounded(axis) && ends[axis] != Ends.OPEN) {
        throw new IllegalArgumentException(
            "an axis with faces must have open ends: axis=" + axis + ", ends=" + ends[axis]);
      }
    }
    if (pressureAxis >= 0 && symmetric[pressureAxis]) {
      throw new IllegalArgumentException(
          "an axis must have symmetry or pressure faces, not both: axis=" + pressureAxis);
    }
    if (pressureAxis >= 0 && equilibrium != Equilibrium.LINEAR) {
      throw new IllegalArgumentException(
          "pressure faces need the linear equilibrium: equilibrium=" + equilibrium);
    }
    for (int kind = SYMMETRY; kind <= LAST; kind++) {
      sum[kind] = new double[set.size()];
    }
  }

  /** Axis of the pressure faces; -1: none. */
  int pressureAxis() {
    return pressureAxis;
  }

  /** Whether an axis has faces. */
  boolean isBounded(int axis) {
    return symmetric[axis] || axis == pressureAxis;
  }

  /** Whether there are any. */
  boolean any() {
    return isBounded(0) || isBounded(1) || isBounded(2);
  }

  /**
   * Sets the densities of the pressure faces.
   *
   * @throws IllegalArgumentException if one is not a positive number
   */
  void densities(double first, double last) {
    if (!(first > 0 && last > 0 && first + last < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(
          "densities at pressure faces must be positive: first=" + first + ", last=" + last);
    }
    for (int i = 0; i < set.size(); i++) {
      sum[FIRST][i] = 2 * set.weight(i) * (first - 1);
      sum[LAST][i] = 2 * set.weight(i) * (last - 1);
    }
  }

  /** What arrives along velocity i for what has left along the mirrored one, less weights. */
  double arriving(int kind, int i, double left) {
    return kind == SYMMETRY ? left : sum[kind][i] - left;
  }

  /** Gives the bundles at a face their links. */
  void link(Lattice lattice, BundleSize size, CellMap<NodalBundle> bundles) {
    FaceLinker linker = new FaceLinker(this, lattice, set, size.within(lattice), bundles);
    for (int n = 0; n < bundles.size(); n++) {
      bundles.cellAt(n).link(linker.links(bundles.cellAt(n)));
    }
  }
}
