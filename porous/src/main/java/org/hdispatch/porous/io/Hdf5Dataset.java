package org.hdispatch.porous.io;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.hdispatch.porous.image.VoxelBox;

/**
 * A dataset as it stands in an HDF5 file; nothing of its voxels has been read yet.
 *
 * <p>Shape: in file order, slowest first; (z, y, x) for an image.
 *
 * @param file the file it was found in
 * @param path its path inside the file, such as {@code /volume}
 * @param shape its dimensions in file order
 * @param type the type of its elements, such as {@code uint8} or {@code float32}
 * @param integer whether the elements are integers that can be labels
 * @param voxelEdge edge of a voxel in metres, from the attribute {@code voxel_size_m} of the
 *     dataset or of the file; empty when there is none
 */
public record Hdf5Dataset(
    Path file,
    String path,
    List<Long> shape,
    String type,
    boolean integer,
    OptionalDouble voxelEdge) {

  /** A dataset; the shape is copied. */
  public Hdf5Dataset {
    shape = List.copyOf(shape);
  }

  /**
   * Whether this can be an image: 3 dimensions, integer elements.
   *
   * @return true if it can
   */
  public boolean isImage() {
    return shape.size() == 3 && integer;
  }

  /**
   * The box of the whole image.
   *
   * @return origin (0, 0, 0) and the size of the image, in voxels
   * @throws ImageFileException if this is not an image of at least one voxel, or a dimension
   *     exceeds 2^31 - 1
   */
  public VoxelBox whole() throws ImageFileException {
    if (shape.size() != 3) {
      throw new ImageFileException("dataset must have 3 dimensions (z, y, x): " + where());
    }
    if (!integer) {
      throw new ImageFileException(
          "labels must be integers of 0..255 (convert them, e.g. to uint8): "
              + where()
              + ", type="
              + type);
    }
    for (long length : shape) {
      if (length < 1 || length > Integer.MAX_VALUE) {
        throw new ImageFileException(
            "dataset dimensions must be 1 to " + Integer.MAX_VALUE + ": " + where());
      }
    }
    return VoxelBox.whole(
        shape.get(2).intValue(), shape.get(1).intValue(), shape.get(0).intValue());
  }

  /** File, dataset and shape as errors name them. */
  String where() {
    return "file=" + file + ", dataset=" + path + ", shape=" + shape;
  }

  /** Path, type and shape, such as {@code /volume uint8 [400, 400, 400]}. */
  @Override
  public String toString() {
    return path + " " + type + " " + shape;
  }
}
