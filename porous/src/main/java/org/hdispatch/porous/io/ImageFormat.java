package org.hdispatch.porous.io;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Locale;

/** How an image is stored, as far as its file shows. */
public enum ImageFormat {
  /** HDF5: read with {@link Hdf5Images}. */
  HDF5,
  /** Nothing that is recognised: raw bytes, to be read with {@link RawImages}. */
  RAW;

  /** First bytes of the superblock (HDF5 File Format Specification, II.A), big-endian. */
  private static final long SIGNATURE = 0x894844460d0a1a0aL;

  private static final long FIRST_LATER_PLACE = 512;

  /**
   * The format of a file: HDF5 if it bears the signature, which may stand at byte 0, 512, 1024 and
   * so on, or is named {@code .h5}, {@code .hdf5} or {@code .hdf}.
   *
   * @param file the file
   * @return its format
   * @throws ImageFileException if the file is missing, a directory, empty or unreadable
   */
  public static ImageFormat of(Path file) throws ImageFileException {
    long length = ImageFiles.requireReadable(file);
    if (file.toString().toLowerCase(Locale.ROOT).matches(".*\\.(h5|hdf5|hdf)")) {
      return HDF5;
    }
    try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
      ByteBuffer start = ByteBuffer.allocate(Long.BYTES);
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
}
