package org.hdispatch.porous.flow;

import org.hdispatch.cell.Ends;
import org.hdispatch.lbm.immersed.Coverage;
import org.hdispatch.lbm.immersed.Sphere;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.pore.PoreSpace;
import org.hdispatch.porous.pore.SpherePacking;

/**
 * How much of each voxel of a rock is solid, 0 to 1: what immersed boundaries need in place of a
 * pore space.
 *
 * <p>Shape: flat, x fastest; voxel (x, y, z) stands at {@code x + nx*(y + ny*z)}.
 */
public final class SolidFractions {
  private final int nx;
  private final int ny;
  private final int nz;
  private final float[] fractions;

  private SolidFractions(int nx, int ny, int nz) {
    this.nx = nx;
    this.ny = ny;
    this.nz = nz;
    fractions = new float[VoxelImage.requireFits(nx, ny, nz)];
  }

  /** Fractions of a segmented rock: 0 in pore, 1 in solid. */
  public static SolidFractions of(PoreSpace space) {
    SolidFractions solid = new SolidFractions(space.nx(), space.ny(), space.nz());
    for (int voxel = 0; voxel < solid.fractions.length; voxel++) {
      solid.fractions[voxel] = space.isPore(voxel) ? 0 : 1;
    }
    return solid;
  }

  /**
   * Exact fractions of regular spheres, periodic on all sides.
   *
   * @param size edge of the cell, voxels
   * @param solidFraction share of the volume that the spheres take
   * @throws IllegalArgumentException if there can be no such packing
   */
  public static SolidFractions of(SpherePacking packing, int size, double solidFraction) {
    Sphere sphere = new Sphere(packing.radius(size, solidFraction));
    SolidFractions solid = new SolidFractions(size, size, size);
    for (double[] centre : packing.centres()) {
      for (int image = 0; image < 27; image++) {
        solid.add(
            sphere,
            (centre[0] + image % 3 - 1) * size - 0.5,
            (centre[1] + image / 3 % 3 - 1) * size - 0.5,
            (centre[2] + image / 9 - 1) * size - 0.5);
      }
    }
    return solid;
  }

  /** Adds a sphere; voxel centres lie at integers. */
  private void add(Sphere sphere, double x, double y, double z) {
    double reach = sphere.reachX() + 0.5;
    for (int k = least(z - reach); k <= most(z + reach, nz); k++) {
      for (int j = least(y - reach); j <= most(y + reach, ny); j++) {
        for (int i = least(x - reach); i <= most(x + reach, nx); i++) {
          int voxel = i + nx * (j + ny * k);
          double sum = fractions[voxel] + sphere.fraction(i - x, j - y, k - z);
          fractions[voxel] = (float) Math.min(1, sum);
        }
      }
    }
  }

  private static int least(double low) {
    return (int) Math.max(0, Math.ceil(low));
  }

  private static int most(double high, int extent) {
    return (int) Math.min(extent - 1.0, Math.floor(high));
  }

  /**
   * Fractions of an image of grey values: linear from 0 at that of pure pore to 1 at that of pure
   * solid, cut off beyond.
   *
   * @param pore grey value of pore, 0 to 255
   * @param solid grey value of solid; may be below that of the pore
   * @throws IllegalArgumentException if both are the same, or one is not 0 to 255
   */
  public static SolidFractions ofGrey(VoxelImage image, int pore, int solid) {
    if (pore == solid || Math.min(pore, solid) < 0 || Math.max(pore, solid) > 255) {
      throw new IllegalArgumentException(
          "grey values of pore and solid must differ and lie within 0 to 255: pore="
              + pore
              + ", solid="
              + solid);
    }
    SolidFractions found = new SolidFractions(image.nx(), image.ny(), image.nz());
    for (int voxel = 0; voxel < found.fractions.length; voxel++) {
      double share = (double) (image.label(voxel) - pore) / (solid - pore);
      found.fractions[voxel] = (float) Math.max(0, Math.min(1, share));
    }
    return found;
  }

  /** The voxels that are less solid than this. */
  public PoreSpace below(double fraction) {
    return PoreSpace.of(nx, ny, nz, (x, y, z) -> fractions[x + nx * (y + ny * z)] < fraction);
  }

  /** Porosity: 1 less the mean fraction. */
  public double porosity() {
    double sum = 0;
    for (float each : fractions) {
      sum += each;
    }
    return 1 - sum / fractions.length;
  }

  /** Pore volume within some voxels, over that of the whole box. */
  double porosity(PoreSpace part) {
    double sum = 0;
    for (int voxel = 0; voxel < fractions.length; voxel++) {
      sum += part.isPore(voxel) ? 1 - fractions[voxel] : 0;
    }
    return sum / fractions.length;
  }

  /** Number of voxels that are partly or wholly solid. */
  long coveredVoxels() {
    long count = 0;
    for (float each : fractions) {
      count += each > 0 ? 1 : 0;
    }
    return count;
  }

  /**
   * Whether a voxel matters to the flow: it or one of its 26 neighbours is not wholly solid.
   *
   * @param alongX what lies beyond the ends of x
   * @param alongY what lies beyond the ends of y
   * @param alongZ what lies beyond the ends of z
   */
  boolean matters(int x, int y, int z, Ends alongX, Ends alongY, Ends alongZ) {
    if (fractions[x + nx * (y + ny * z)] < 1) {
      return true;
    }
    for (int near = 0; near < 27; near++) {
      int i = alongX.wrap(x + near % 3 - 1, nx);
      int j = alongY.wrap(y + near / 3 % 3 - 1, ny);
      int k = alongZ.wrap(z + near / 9 - 1, nz);
      if (i >= 0 && j >= 0 && k >= 0 && fractions[i + nx * (j + ny * k)] < 1) {
        return true;
      }
    }
    return false;
  }

  /** The same as a shape. */
  Coverage coverage() {
    return Coverage.of(nx, ny, nz, fractions);
  }
}
