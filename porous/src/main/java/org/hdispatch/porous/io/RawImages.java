package org.hdispatch.porous.io;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;

/**
 * Raw 8-bit images: one byte per voxel, x fastest, no header; also gzipped.
 *
 * <p>Such a file holds neither its dimensions nor its voxel edge: both must be given. A name that
 * ends in {@code .gz} is inflated while reading. The length is checked against the dimensions: of a
 * plain file before reading, of a gzipped one while inflating it, always to its end.
 */
public final class RawImages {
  private RawImages() {}

  /**
   * An image in a raw file.
   *
   * @param file the file
   * @param whole its size: a box with origin (0, 0, 0), voxels
   * @return the image, its voxel edge unknown
   * @throws ImageFileException if the file is missing, a directory, empty or unreadable, or not
   *     gzipped and of another length
   */
  public static ImageFile open(Path file, VoxelBox whole) throws ImageFileException {
    boolean gzip = file.getFileName().toString().toLowerCase(Locale.ROOT).endsWith(".gz");
    FlatVolume.Packing packing = gzip ? FlatVolume.Packing.GZIP : FlatVolume.Packing.PLAIN;
    FlatVolume volume = new FlatVolume(file, 0, packing, LabelType.UINT8, whole);
    return FlatImage.of(
        ImageFormat.RAW.toString(),
        file,
        volume,
        FlatImage.Order.X_FASTEST,
        OptionalDouble.empty(),
        Map.of());
  }

  /**
   * Reads a whole image.
   *
   * @param file the file
   * @param nx voxels along x
   * @param ny voxels along y
   * @param nz voxels along z
   * @return the image, its voxel edge unknown
   * @throws ImageFileException if the file is missing, unreadable or of another length
   * @throws IllegalArgumentException if a dimension is below 1 or the image is too large for one
   *     array
   */
  public static VoxelImage read(Path file, int nx, int ny, int nz) throws ImageFileException {
    VoxelBox whole = VoxelBox.whole(nx, ny, nz);
    return open(file, whole).read(whole);
  }
}
