package org.hdispatch.porous.io;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Locale;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipException;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;

/**
 * Reads raw 8-bit images: one byte per voxel, x fastest, no header; also gzipped.
 *
 * <p>Such a file holds neither its dimensions nor its voxel edge: both must be given. A name that
 * ends in {@code .gz} is inflated while reading. The length is checked against the dimensions: of a
 * plain file before reading, of a gzipped one while inflating it, always to its end.
 */
public final class RawImages {
  private RawImages() {}

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
    return read(file, nx, ny, nz, VoxelBox.whole(nx, ny, nz));
  }

  /**
   * Reads a box of an image without loading the rest: a plain file is sought in, a gzipped one
   * streamed past.
   *
   * @param file the file
   * @param nx voxels of the whole image along x
   * @param ny voxels of the whole image along y
   * @param nz voxels of the whole image along z
   * @param box the part to read
   * @return the part, its voxel edge unknown
   * @throws ImageFileException if the file is missing, unreadable or of another length
   * @throws IllegalArgumentException if the box does not lie inside the image or is too large for
   *     one array
   */
  public static VoxelImage read(Path file, int nx, int ny, int nz, VoxelBox box)
      throws ImageFileException {
    VoxelBox whole = VoxelBox.whole(nx, ny, nz);
    box.within(nx, ny, nz);
    requireLength(file, nx, ny, nz);
    VoxelImage.requireFits(box.nx(), box.ny(), box.nz());
    try {
      byte[] labels;
      if (isGzip(file)) {
        labels = inflate(file, whole, box);
      } else {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
          labels = FlatRows.read(channel, 0, nx, ny, box, LabelType.UINT8);
        }
      }
      return VoxelImage.of(box.nx(), box.ny(), box.nz(), labels);
    } catch (ImageFileException e) {
      throw e;
    } catch (IOException e) {
      throw ImageFiles.unreadable(file, e);
    }
  }

  /**
   * Checks the length of a file against the size of its image, as far as that is possible without
   * reading it: not for gzipped files.
   *
   * @param file the file
   * @param nx voxels along x
   * @param ny voxels along y
   * @param nz voxels along z
   * @throws ImageFileException if the file is missing, a directory, empty or unreadable, or not
   *     gzipped and of another length
   * @throws IllegalArgumentException if a dimension is below 1
   */
  public static void requireLength(Path file, int nx, int ny, int nz) throws ImageFileException {
    VoxelBox whole = VoxelBox.whole(nx, ny, nz);
    long length = ImageFiles.requireReadable(file);
    if (!isGzip(file) && length != whole.voxels()) {
      throw wrongLength("file length", file, Long.toString(length), whole);
    }
  }

  private static boolean isGzip(Path file) {
    return file.getFileName().toString().toLowerCase(Locale.ROOT).endsWith(".gz");
  }

  private static byte[] inflate(Path file, VoxelBox whole, VoxelBox box) throws IOException {
    byte[] labels = new byte[Math.toIntExact(box.voxels())];
    long at = 0;
    try (InputStream raw = Files.newInputStream(file);
        InputStream in = new GZIPInputStream(raw, 1 << 16)) {
      int to = 0;
      for (int z = 0; z < box.nz(); z++) {
        for (int y = 0; y < box.ny(); y++) {
          long row =
              box.x0()
                  + (long) whole.nx() * (box.y0() + y)
                  + (long) whole.nx() * whole.ny() * (box.z0() + z);
          at += skip(in, row - at);
          if (at == row) {
            int got = in.readNBytes(labels, to, box.nx());
            at += got;
            to += box.nx();
          }
        }
      }
      // One voxel beyond the end is enough to know that the file is too long.
      at += skip(in, whole.voxels() - at + 1);
    } catch (ZipException e) {
      throw new ImageFileException(
          "file must be sound gzip, as its name ends in .gz: file="
              + file
              + ", cause="
              + ImageFiles.describe(e),
          e);
    } catch (EOFException e) {
      throw new ImageFileException(
          "gzip stream must be complete (the file is cut short): file=" + file, e);
    }
    if (at != whole.voxels()) {
      String inflated = at > whole.voxels() ? "more than " + whole.voxels() : Long.toString(at);
      throw wrongLength("inflated length", file, inflated, whole);
    }
    return labels;
  }

  /** Skips up to {@code count} bytes; fewer only at the end of the stream. */
  private static long skip(InputStream in, long count) throws IOException {
    long left = count;
    while (left > 0) {
      long skipped = in.skip(left);
      if (skipped == 0) {
        if (in.read() < 0) {
          break;
        }
        skipped = 1;
      }
      left -= skipped;
    }
    return count - left;
  }

  private static ImageFileException wrongLength(
      String what, Path file, String length, VoxelBox whole) {
    return new ImageFileException(
        what
            + " must be nx*ny*nz (8 bit, no header): file="
            + file
            + ", length="
            + length
            + " bytes, dims="
            + whole.nx()
            + ","
            + whole.ny()
            + ","
            + whole.nz()
            + " ("
            + whole.voxels()
            + " voxels)");
  }
}
