package org.hdispatch.porous.io;

import java.util.Map;
import java.util.OptionalDouble;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;

/**
 * An image in a file whose header has been read and found right, and none of its voxels.
 *
 * <p>Each format has a class with a method {@code open} that gives one: {@link Hdf5Images}, {@link
 * TiffImages}, {@link NumpyImages}, {@link NrrdImages}, {@link MetaImages}, {@link RawImages};
 * {@link ImageFormat#of} says which. The file is open only while something is read from it.
 */
public interface ImageFile {
  /**
   * What reports and errors call it.
   *
   * @return the file, and the place inside of it where a file can hold several images
   */
  String name();

  /**
   * The box of the whole image.
   *
   * @return origin (0, 0, 0) and the size of the image, in voxels
   */
  VoxelBox whole();

  /**
   * Edge of a voxel.
   *
   * @return the edge in metres, or empty when the file does not state it with its unit
   */
  OptionalDouble voxelEdge();

  /**
   * What is to be said about the file: key, value. The first is its {@code format}, the second
   * {@code file_bytes}.
   *
   * @return facts in the order in which they are to be shown; keys are words joined by underscores
   * @throws ImageFileException if the file can no longer be read
   */
  Map<String, Object> facts() throws ImageFileException;

  /**
   * Reads a box; of the rest only what lies in its way. A plain file is sought in, a compressed one
   * streamed past, and of chunks, pages and strips those are unpacked that the box touches.
   *
   * @param box the part to read
   * @return the part as an image, with the voxel edge of the file where it has one
   * @throws ImageFileException if the file is unreadable, cut short or wrong, or a label lies
   *     outside 0..255
   * @throws IllegalArgumentException if the box does not lie inside the image, or is too large for
   *     one array
   */
  VoxelImage read(VoxelBox box) throws ImageFileException;
}
