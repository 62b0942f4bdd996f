package org.hdispatch.porous.io;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.Locale;

/** How an image is stored, as far as its file shows. */
public enum ImageFormat {
  /** HDF5: read with {@link Hdf5Images}. */
  HDF5("HDF5", "h5|hdf5|hdf"),
  /** TIFF or BigTIFF, or a folder of slices: read with {@link TiffImages}. */
  TIFF("TIFF", "tiff?|btf|tf8"),
  /** A NumPy array: read with {@link NumpyImages}. */
  NUMPY("NumPy", "npy"),
  /** NRRD: read with {@link NrrdImages}. */
  NRRD("NRRD", "nrrd|nhdr"),
  /** MetaImage, known by its name alone: read with {@link MetaImages}. */
  META_IMAGE("MetaImage", "mhd|mha"),
  /** Nothing that is recognised: raw bytes, to be read with {@link RawImages}. */
  RAW("raw 8 bit", "");

  /** First bytes of HDF5's superblock (HDF5 File Format Specification, II.A), big-endian. */
  private static final long SIGNATURE = 0x894844460d0a1a0aL;

  private static final long FIRST_LATER_PLACE = 512;

  private final String title;
  private final String names;

  ImageFormat(String title, String names) {
    this.title = title;
    this.names = names;
  }

  /**
   * The format of a file: by the end of its name, or else by the signature that it bears. That of
   * HDF5 may stand at byte 0, 512, 1024 and so on. A folder is one of TIFF slices.
   *
   * @param file the file or folder
   * @return its format
   * @throws ImageFileException if the file is missing, empty or unreadable
   */
  public static ImageFormat of(Path file) throws ImageFileException {
    if (Files.isDirectory(file)) {
      return TIFF;
    }
    long length = ImageFiles.requireReadable(file);
    for (ImageFormat format : values()) {
      if (file.toString().toLowerCase(Locale.ROOT).matches(".*\\.(" + format.names + ")")) {
        return format;
      }
    }
    try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
      ByteBuffer start = ByteBuffer.allocate(Long.BYTES);
      channel.read(start, 0);
      byte[] bytes = Arrays.copyOf(start.array(), start.position());
      if (TiffFile.isStart(bytes)) {
        return TIFF;
      } else if (NumpyImages.isStart(bytes)) {
        return NUMPY;
      } else if (NrrdImages.isStart(bytes)) {
        return NRRD;
      }
      for (long at = 0; at + Long.BYTES <= length; at = Math.max(FIRST_LATER_PLACE, 2 * at)) {
        channel.read(start.clear(), at);
        if (!start.hasRemaining() && start.getLong(0) == SIGNATURE) {
          return HDF5;
        }
      }
      return RAW;
    } catch (IOException e) {
      throw ImageFiles.unreadable(file, e);
    }
  }

  /** The name of the format, such as {@code NumPy}. */
  @Override
  public String toString() {
    return title;
  }
}
