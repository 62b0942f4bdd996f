package org.hdispatch.porous.io;

/**
 * A named array of a VTI file: one scalar or one vector per voxel; or of a VTP file: one per point.
 *
 * <p>Shape: as the image, x fastest; as the points. The values are asked for one by one while the
 * file is written, so nothing is copied; they must not change meanwhile.
 */
public final class VtiArray {
  /** How the values are stored in the file. */
  enum Type {
    UINT8("UInt8", 1),
    INT32("Int32", 4),
    FLOAT32("Float32", 4);

    private final String vtkName;
    private final int bytes;

    Type(String vtkName, int bytes) {
      this.vtkName = vtkName;
      this.bytes = bytes;
    }

    String vtkName() {
      return vtkName;
    }

    int bytes() {
      return bytes;
    }
  }

  /** Where the values come from. */
  @FunctionalInterface
  public interface Values {
    /**
     * One value.
     *
     * @param voxel place of the voxel, x fastest; number of the point
     * @param component 0 for a scalar; 0, 1, 2 for a vector
     * @return the value, in the unit the array is named with
     */
    double at(int voxel, int component);
  }

  private final String name;
  private final Type type;
  private final int components;
  private final int voxels;
  private final Values values;

  private VtiArray(String name, Type type, int components, int voxels, Values values) {
    if (name.isBlank()) {
      throw new IllegalArgumentException("array must have a name: name='" + name + "'");
    }
    this.name = name;
    this.type = type;
    this.components = components;
    this.voxels = voxels;
    this.values = values;
  }

  /**
   * Labels, stored as UInt8.
   *
   * @param name name in ParaView
   * @param labels one byte per voxel, read as 0..255
   * @return the array
   */
  public static VtiArray labels(String name, byte[] labels) {
    return new VtiArray(name, Type.UINT8, 1, labels.length, (v, c) -> labels[v] & 0xff);
  }

  /**
   * Labels from anywhere, stored as UInt8.
   *
   * @param name name in ParaView
   * @param voxels number of voxels
   * @param values the labels, 0..255
   * @return the array
   */
  public static VtiArray labels(String name, int voxels, Values values) {
    return new VtiArray(name, Type.UINT8, 1, voxels, values);
  }

  /**
   * Integers from anywhere, stored as Int32.
   *
   * @param name name in ParaView
   * @param voxels number of voxels or points
   * @param values the integers
   * @return the array
   */
  public static VtiArray integers(String name, int voxels, Values values) {
    return new VtiArray(name, Type.INT32, 1, voxels, values);
  }

  /**
   * A scalar, stored as Float32.
   *
   * @param name name in ParaView, with its unit
   * @param values one value per voxel
   * @return the array
   */
  public static VtiArray scalar(String name, double[] values) {
    return new VtiArray(name, Type.FLOAT32, 1, values.length, (v, c) -> values[v]);
  }

  /**
   * A scalar, stored as Float32.
   *
   * @param name name in ParaView, with its unit
   * @param values one value per voxel
   * @return the array
   */
  public static VtiArray scalar(String name, float[] values) {
    return new VtiArray(name, Type.FLOAT32, 1, values.length, (v, c) -> values[v]);
  }

  /**
   * A scalar from anywhere, stored as Float32.
   *
   * @param name name in ParaView, with its unit
   * @param voxels number of voxels
   * @param values the values
   * @return the array
   */
  public static VtiArray scalar(String name, int voxels, Values values) {
    return new VtiArray(name, Type.FLOAT32, 1, voxels, values);
  }

  /**
   * A vector by its three components, stored as Float32.
   *
   * @param name name in ParaView, with its unit
   * @param x components along x, one per voxel
   * @param y components along y, one per voxel
   * @param z components along z, one per voxel
   * @return the array
   * @throws IllegalArgumentException if the three lengths differ
   */
  public static VtiArray vector(String name, double[] x, double[] y, double[] z) {
    requireSameLength(name, x.length, y.length, z.length);
    double[][] parts = {x, y, z};
    return new VtiArray(name, Type.FLOAT32, 3, x.length, (v, c) -> parts[c][v]);
  }

  /**
   * A vector by its three components, stored as Float32.
   *
   * @param name name in ParaView, with its unit
   * @param x components along x, one per voxel
   * @param y components along y, one per voxel
   * @param z components along z, one per voxel
   * @return the array
   * @throws IllegalArgumentException if the three lengths differ
   */
  public static VtiArray vector(String name, float[] x, float[] y, float[] z) {
    requireSameLength(name, x.length, y.length, z.length);
    float[][] parts = {x, y, z};
    return new VtiArray(name, Type.FLOAT32, 3, x.length, (v, c) -> parts[c][v]);
  }

  /**
   * A vector from anywhere, stored as Float32.
   *
   * @param name name in ParaView, with its unit
   * @param voxels number of voxels
   * @param values the components
   * @return the array
   */
  public static VtiArray vector(String name, int voxels, Values values) {
    return new VtiArray(name, Type.FLOAT32, 3, voxels, values);
  }

  private static void requireSameLength(String name, int x, int y, int z) {
    if (x != y || x != z) {
      throw new IllegalArgumentException(
          "components must have the same length: array="
              + name
              + ", x="
              + x
              + ", y="
              + y
              + ", z="
              + z);
    }
  }

  /**
   * Name in ParaView.
   *
   * @return the name
   */
  public String name() {
    return name;
  }

  /**
   * Number of components.
   *
   * @return 1 for a scalar, 3 for a vector
   */
  public int components() {
    return components;
  }

  /**
   * Number of voxels.
   *
   * @return voxels
   */
  public int voxels() {
    return voxels;
  }

  Type type() {
    return type;
  }

  Values values() {
    return values;
  }

  long bytes() {
    return (long) voxels * components * type.bytes();
  }
}
