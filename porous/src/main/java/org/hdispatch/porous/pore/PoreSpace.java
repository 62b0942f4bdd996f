package org.hdispatch.porous.pore;

import org.hdispatch.porous.image.LabelRule;
import org.hdispatch.porous.image.Phase;
import org.hdispatch.porous.image.VoxelImage;

/**
 * Which voxels of a box are pore.
 *
 * <p>Shape: flat, x fastest; voxel (x, y, z) stands at {@code x + nx*(y + ny*z)}. Memory: one byte
 * per voxel. Nothing changes a pore space once it is made.
 */
public final class PoreSpace {
  static final byte PORE = 1;
  static final byte SOLID = 0;

  private final int nx;
  private final int ny;
  private final int nz;
  private final byte[] pore;
  private final int poreVoxels;

  /** Takes the array over. */
  PoreSpace(int nx, int ny, int nz, byte[] pore) {
    this.nx = nx;
    this.ny = ny;
    this.nz = nz;
    this.pore = pore;
    this.poreVoxels = poreVoxels(0, pore.length);
  }

  /** Says of a voxel whether it is pore. */
  @FunctionalInterface
  public interface VoxelPredicate {
    /**
     * Whether a voxel is pore.
     *
     * @param x voxel along x, 0..nx-1
     * @param y voxel along y, 0..ny-1
     * @param z voxel along z, 0..nz-1
     * @return true if it is pore
     */
    boolean isPore(int x, int y, int z);
  }

  /**
   * The pore space of an image.
   *
   * @param image the image
   * @param rule which labels are pore
   * @return its pore space, of the same size
   */
  public static PoreSpace of(VoxelImage image, LabelRule rule) {
    byte[] byLabel = new byte[VoxelImage.LABELS];
    for (int label = 0; label < byLabel.length; label++) {
      byLabel[label] = rule.phase(label) == Phase.PORE ? PORE : SOLID;
    }
    byte[] pore = new byte[image.voxels()];
    for (int i = 0; i < pore.length; i++) {
      pore[i] = byLabel[image.label(i)];
    }
    return new PoreSpace(image.nx(), image.ny(), image.nz(), pore);
  }

  /**
   * The pore space of a formula.
   *
   * @param nx voxels along x
   * @param ny voxels along y
   * @param nz voxels along z
   * @param predicate which voxels are pore; asked once per voxel
   * @return the pore space
   * @throws IllegalArgumentException if a size is below 1 or the voxels are too many for one array
   */
  public static PoreSpace of(int nx, int ny, int nz, VoxelPredicate predicate) {
    byte[] pore = new byte[VoxelImage.requireFits(nx, ny, nz)];
    int i = 0;
    for (int z = 0; z < nz; z++) {
      for (int y = 0; y < ny; y++) {
        for (int x = 0; x < nx; x++) {
          pore[i++] = predicate.isPore(x, y, z) ? PORE : SOLID;
        }
      }
    }
    return new PoreSpace(nx, ny, nz, pore);
  }

  /**
   * Size along x.
   *
   * @return voxels along x
   */
  public int nx() {
    return nx;
  }

  /**
   * Size along y.
   *
   * @return voxels along y
   */
  public int ny() {
    return ny;
  }

  /**
   * Size along z.
   *
   * @return voxels along z
   */
  public int nz() {
    return nz;
  }

  /**
   * Number of voxels, pore and solid.
   *
   * @return nx ny nz
   */
  public int voxels() {
    return pore.length;
  }

  /**
   * Place of a voxel in the flat order.
   *
   * @param x voxel along x, 0..nx-1; not checked
   * @param y voxel along y, 0..ny-1; not checked
   * @param z voxel along z, 0..nz-1; not checked
   * @return {@code x + nx*(y + ny*z)}
   */
  public int index(int x, int y, int z) {
    return x + nx * (y + ny * z);
  }

  /**
   * Whether a voxel is pore.
   *
   * @param x voxel along x, 0..nx-1
   * @param y voxel along y, 0..ny-1
   * @param z voxel along z, 0..nz-1
   * @return true if it is pore
   */
  public boolean isPore(int x, int y, int z) {
    return pore[index(x, y, z)] != SOLID;
  }

  /**
   * Whether a voxel is pore, by its place in the flat order.
   *
   * @param index place, {@link #index(int, int, int)}
   * @return true if it is pore
   */
  public boolean isPore(int index) {
    return pore[index] != SOLID;
  }

  /**
   * Phase of a voxel.
   *
   * @param x voxel along x, 0..nx-1
   * @param y voxel along y, 0..ny-1
   * @param z voxel along z, 0..nz-1
   * @return its phase
   */
  public Phase phase(int x, int y, int z) {
    return isPore(x, y, z) ? Phase.PORE : Phase.SOLID;
  }

  /**
   * Number of pore voxels.
   *
   * @return pore voxels
   */
  public int poreVoxels() {
    return poreVoxels;
  }

  /**
   * Porosity phi: pore voxels over all voxels.
   *
   * @return porosity, 0..1
   */
  public double porosity() {
    return (double) poreVoxels / pore.length;
  }

  /**
   * Number of pore voxels in a stretch of the flat order.
   *
   * @param from place of the first voxel
   * @param to place behind the last one
   * @return pore voxels
   */
  public int poreVoxels(int from, int to) {
    int count = 0;
    for (int i = from; i < to; i++) {
      count += pore[i];
    }
    return count;
  }

  /**
   * Number of voxels in a stretch of the flat order whose phase is not that of the voxel a distance
   * behind.
   *
   * @param from place of the first voxel
   * @param to place behind the last one
   * @param distance places from a voxel to the one that it is compared with
   * @return how many differ
   */
  public int differences(int from, int to, int distance) {
    int count = 0;
    for (int i = from; i < to; i++) {
      count += pore[i] ^ pore[i + distance];
    }
    return count;
  }

  /** The flags themselves, {@link #PORE} or {@link #SOLID}; nobody writes to them. */
  byte[] flags() {
    return pore;
  }

  /** Size and porosity, such as {@code 64x64x64 voxels, porosity 0.657}. */
  @Override
  public String toString() {
    return nx + "x" + ny + "x" + nz + " voxels, porosity " + porosity();
  }
}
