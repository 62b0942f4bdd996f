package org.hdispatch.porous.image;

import java.util.OptionalDouble;

/**
 * A segmented image of rock: one label of 0..255 per voxel.
 *
 * <p>Shape: flat, x fastest; voxel (x, y, z) stands at {@code x + nx*(y + ny*z)}. Units: the voxel
 * edge is in metres and may be unknown (raw files hold none). Memory: one byte per voxel.
 *
 * <p>Nothing changes an image once it is made.
 */
public final class VoxelImage {
  /** The most voxels one image can hold: the longest array a JVM gives out. */
  public static final int MAX_VOXELS = Integer.MAX_VALUE - 8;

  /** How many different labels there are: 0..255. */
  public static final int LABELS = 256;

  private final int nx;
  private final int ny;
  private final int nz;
  private final byte[] labels;
  private final OptionalDouble voxelEdge;

  private VoxelImage(int nx, int ny, int nz, byte[] labels, OptionalDouble voxelEdge) {
    this.nx = nx;
    this.ny = ny;
    this.nz = nz;
    this.labels = labels;
    this.voxelEdge = voxelEdge;
  }

  /**
   * An image over an array of labels. The image takes the array over without copying it: nobody may
   * write to it afterwards.
   *
   * @param nx voxels along x
   * @param ny voxels along y
   * @param nz voxels along z
   * @param labels nx ny nz labels, x fastest, each byte read as 0..255
   * @return the image, its voxel edge unknown
   * @throws IllegalArgumentException if a size is below 1, the voxels are too many or the array has
   *     another length
   */
  public static VoxelImage of(int nx, int ny, int nz, byte[] labels) {
    int voxels = requireFits(nx, ny, nz);
    if (labels.length != voxels) {
      throw new IllegalArgumentException(
          "labels must be nx*ny*nz: labels=" + labels.length + ", image=" + size(nx, ny, nz));
    }
    return new VoxelImage(nx, ny, nz, labels, OptionalDouble.empty());
  }

  /**
   * The number of voxels of a box, checked to fit into one image.
   *
   * @param nx voxels along x
   * @param ny voxels along y
   * @param nz voxels along z
   * @return nx ny nz
   * @throws IllegalArgumentException if a size is below 1 or the voxels exceed {@link #MAX_VOXELS}
   */
  public static int requireFits(int nx, int ny, int nz) {
    if (nx < 1 || ny < 1 || nz < 1) {
      throw new IllegalArgumentException(
          "image size must be at least 1 voxel: image=" + size(nx, ny, nz));
    }
    long voxels = VoxelBox.whole(nx, ny, nz).voxels();
    if (voxels > MAX_VOXELS) {
      throw new IllegalArgumentException(
          "image must have at most "
              + MAX_VOXELS
              + " voxels (take a box of it): image="
              + size(nx, ny, nz)
              + ", voxels="
              + voxels);
    }
    return (int) voxels;
  }

  /**
   * This image with its voxel edge stated; the labels are shared.
   *
   * @param metres edge of a voxel, in m
   * @return the image with that edge
   * @throws IllegalArgumentException if the edge is not a positive finite number
   */
  public VoxelImage withVoxelEdge(double metres) {
    if (!(metres > 0) || metres == Double.POSITIVE_INFINITY) {
      throw new IllegalArgumentException(
          "voxel edge must be positive and finite: edge=" + metres + " m");
    }
    return new VoxelImage(nx, ny, nz, labels, OptionalDouble.of(metres));
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
   * Number of voxels.
   *
   * @return nx ny nz
   */
  public int voxels() {
    return labels.length;
  }

  /**
   * Edge of a voxel.
   *
   * @return the edge in metres, or empty when nobody stated it
   */
  public OptionalDouble voxelEdge() {
    return voxelEdge;
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
   * Label of a voxel.
   *
   * @param x voxel along x, 0..nx-1
   * @param y voxel along y, 0..ny-1
   * @param z voxel along z, 0..nz-1
   * @return its label, 0..255
   */
  public int label(int x, int y, int z) {
    return labels[index(x, y, z)] & 0xff;
  }

  /**
   * Label of a voxel by its place in the flat order.
   *
   * @param index place, {@link #index(int, int, int)}
   * @return its label, 0..255
   */
  public int label(int index) {
    return labels[index] & 0xff;
  }

  /**
   * All labels.
   *
   * @return a copy, x fastest
   */
  public byte[] toLabels() {
    return labels.clone();
  }

  /**
   * A part of this image as an image of its own; the voxel edge goes with it.
   *
   * @param box the part
   * @return a copy of the part
   * @throws IllegalArgumentException if the box does not lie inside this image
   */
  public VoxelImage crop(VoxelBox box) {
    box.within(nx, ny, nz);
    byte[] part = new byte[requireFits(box.nx(), box.ny(), box.nz())];
    int to = 0;
    for (int z = 0; z < box.nz(); z++) {
      for (int y = 0; y < box.ny(); y++) {
        System.arraycopy(labels, index(box.x0(), box.y0() + y, box.z0() + z), part, to, box.nx());
        to += box.nx();
      }
    }
    return new VoxelImage(box.nx(), box.ny(), box.nz(), part, voxelEdge);
  }

  /**
   * How many voxels carry each label.
   *
   * @return 256 counts; their sum is {@link #voxels()}
   */
  public long[] histogram() {
    long[] counts = new long[LABELS];
    for (byte label : labels) {
      counts[label & 0xff]++;
    }
    return counts;
  }

  private static String size(int nx, int ny, int nz) {
    return nx + "x" + ny + "x" + nz;
  }

  /** Size and voxel edge, such as {@code 400x400x400 voxels of 5.345E-6 m}. */
  @Override
  public String toString() {
    String edge = voxelEdge.isPresent() ? " of " + voxelEdge.getAsDouble() + " m" : "";
    return size(nx, ny, nz) + " voxels" + edge;
  }
}
