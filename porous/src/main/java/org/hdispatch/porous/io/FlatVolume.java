package org.hdispatch.porous.io;

import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.zip.GZIPInputStream;
import java.util.zip.InflaterInputStream;
import java.util.zip.ZipException;
import org.hdispatch.porous.image.VoxelBox;

/**
 * Voxels side by side from some byte of a file to its end, x fastest, plain or compressed.
 *
 * <p>The length is checked against the size: of a plain file before reading, of a compressed one
 * while inflating it, always to its end.
 *
 * @param file the file
 * @param start where the voxels begin, in bytes
 * @param packing how they are compressed
 * @param type how a voxel is stored
 * @param whole the whole volume
 */
record FlatVolume(Path file, long start, Packing packing, LabelType type, VoxelBox whole) {
  private static final int BUFFER_BYTES = 1 << 16;

  /** How voxels are compressed. */
  enum Packing {
    /** As they are. */
    PLAIN,
    /** RFC 1952. */
    GZIP,
    /** RFC 1950. */
    ZLIB;

    private InputStream unpack(InputStream in) throws IOException {
      return switch (this) {
        case PLAIN -> in;
        case GZIP -> new GZIPInputStream(in, BUFFER_BYTES);
        case ZLIB -> new InflaterInputStream(new BufferedInputStream(in, BUFFER_BYTES));
      };
    }

    private String word() {
      return this == GZIP ? "gzip" : "zlib";
    }
  }

  /** Bytes that all voxels take before compression; saturates. */
  static long bytes(VoxelBox whole, LabelType type) {
    long voxels = whole.voxels();
    return voxels > Long.MAX_VALUE / type.bytes() ? Long.MAX_VALUE : voxels * type.bytes();
  }

  /** Checks the length of the file, if it is not compressed; returns it. */
  long requireLength() throws ImageFileException {
    long length = ImageFiles.requireReadable(file);
    if (packing == Packing.PLAIN && length - start != bytes(whole, type)) {
      throw wrongLength("file length", Long.toString(length));
    }
    return length;
  }

  /** Reads the labels of a box that lies inside the volume and fits into an array; x fastest. */
  byte[] read(VoxelBox box) throws ImageFileException {
    requireLength();
    try {
      if (packing != Packing.PLAIN) {
        return inflate(box);
      }
      try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
        return FlatRows.read(channel, start, whole.nx(), whole.ny(), box, type);
      }
    } catch (LabelType.LabelRangeException e) {
      throw e.in("file=" + file, type);
    } catch (ImageFileException e) {
      throw e;
    } catch (IOException e) {
      throw ImageFiles.unreadable(file, e);
    }
  }

  private byte[] inflate(VoxelBox box) throws IOException {
    byte[] labels = new byte[Math.toIntExact(box.voxels())];
    int size = type.bytes();
    byte[] stored = new byte[Math.multiplyExact(box.nx(), size)];
    long total = bytes(whole, type);
    long at = 0;
    try (InputStream raw = Files.newInputStream(file)) {
      raw.skipNBytes(start);
      try (InputStream in = packing.unpack(raw)) {
        int to = 0;
        for (int z = 0; z < box.nz(); z++) {
          for (int y = 0; y < box.ny(); y++) {
            long row = box.x0() + whole.nx() * (box.y0() + y + whole.ny() * ((long) box.z0() + z));
            at += skip(in, row * size - at);
            if (at == row * size) {
              int got = in.readNBytes(stored, 0, stored.length);
              at += got;
              type.decode(stored, 0, labels, to, got / size);
              to += box.nx();
            }
          }
        }
        // One byte beyond the end is enough to know that there are too many.
        at += skip(in, total - at + 1);
      }
    } catch (ZipException e) {
      throw new ImageFileException(
          "file must be sound "
              + packing.word()
              + ", as its name or header says: file="
              + file
              + ", cause="
              + ImageFiles.describe(e),
          e);
    } catch (EOFException e) {
      throw new ImageFileException(
          packing.word() + " stream must be complete (the file is cut short): file=" + file, e);
    }
    if (at != total) {
      throw wrongLength("inflated length", at > total ? "more than " + total : Long.toString(at));
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

  private ImageFileException wrongLength(String what, String length) {
    boolean behindHeader = start > 0 && packing == Packing.PLAIN;
    return new ImageFileException(
        what
            + " must be "
            + (behindHeader ? start + " + " : "")
            + (type.bytes() == 1 ? "" : type.bytes() + "*")
            + "nx*ny*nz ("
            + (type.equals(LabelType.UINT8) ? "8 bit" : type)
            + (behindHeader ? " behind a header" : ", no header")
            + "): file="
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
