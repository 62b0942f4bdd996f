package org.hdispatch.porous.io;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.hdispatch.porous.io.TiffDirectory.WrongTiffException;

/**
 * How strips and tiles are compressed (TIFF 6.0, sections 9, 13 and 14; Deflate: TIFF Technical
 * Note of 2002), and how they become samples again.
 *
 * <p>Each must give exactly the bytes that it is to give. (The reader of the JDK lets a strip that
 * ends too early pass and leaves the rest of it black, which is why it is not used.)
 */
enum TiffPacking {
  /** As they are. */
  NONE,
  /** Lempel, Ziv and Welch. */
  LZW,
  /** As in ZIP and PNG. */
  DEFLATE,
  /** Runs of equal bytes. */
  PACK_BITS;

  private static final int LZW_CLEAR = 256;
  private static final int LZW_END = 257;
  private static final int LZW_CODES = 4096;

  /** What the tag Compression says. */
  static TiffPacking of(long compression) throws WrongTiffException {
    return switch ((int) compression) {
      case 1 -> NONE;
      case 5 -> LZW;
      case 8, 32946 -> DEFLATE;
      case 32773 -> PACK_BITS;
      default ->
          throw new WrongTiffException(
              "pages must be uncompressed, or packed by LZW, Deflate or PackBits (save them so)",
              "compression=" + compression);
    };
  }

  /**
   * Unpacks a strip or tile.
   *
   * @param packed its bytes in the file
   * @param bytes how many it must give
   */
  byte[] unpack(byte[] packed, int bytes) throws IOException {
    byte[] to = new byte[bytes];
    int got =
        switch (this) {
          case NONE -> copy(packed, to);
          case LZW -> lzw(packed, to);
          case DEFLATE -> inflate(packed, to);
          case PACK_BITS -> packBits(packed, to);
        };
    if (got != bytes) {
      throw new WrongTiffException(
          "strip must unpack to its full size (the file is damaged)",
          "bytes=" + got + ", full=" + bytes);
    }
    return to;
  }

  private static int copy(byte[] from, byte[] to) {
    int count = Math.min(from.length, to.length);
    System.arraycopy(from, 0, to, 0, count);
    return count;
  }

  private static int inflate(byte[] from, byte[] to) throws WrongTiffException {
    Inflater inflater = new Inflater();
    try {
      inflater.setInput(from);
      int got = 0;
      while (got < to.length && !inflater.finished()) {
        int more = inflater.inflate(to, got, to.length - got);
        if (more == 0 && (inflater.needsInput() || inflater.needsDictionary())) {
          break;
        }
        got += more;
      }
      return got;
    } catch (DataFormatException e) {
      throw new WrongTiffException(
          "strip must be sound Deflate (the file is damaged)", "cause=" + ImageFiles.describe(e));
    } finally {
      inflater.end();
    }
  }

  private static int packBits(byte[] from, byte[] to) {
    int at = 0;
    int got = 0;
    while (at + 1 < from.length && got < to.length) {
      int head = from[at++];
      if (head >= 0) {
        int run = Math.min(head + 1, Math.min(from.length - at, to.length - got));
        System.arraycopy(from, at, to, got, run);
        at += run;
        got += run;
      } else if (head != Byte.MIN_VALUE) { // which says nothing
        int run = Math.min(1 - head, to.length - got);
        Arrays.fill(to, got, got + run, from[at++]);
        got += run;
      }
    }
    return got;
  }

  /** Codes of 9 to 12 bits, the most significant first; the width grows one code early. */
  private static int lzw(byte[] from, byte[] to) throws WrongTiffException {
    // A code stands for a run of bytes that was written before: its place and length.
    int[] place = new int[LZW_CODES];
    int[] length = new int[LZW_CODES];
    int next = LZW_END + 1;
    int width = 9;
    int previous = LZW_CLEAR;
    long bit = 0;
    int got = 0;
    while (got < to.length && bit + width <= 8L * from.length) {
      int code = bits(from, bit, width);
      bit += width;
      if (code == LZW_END) {
        break;
      }
      if (code == LZW_CLEAR) {
        next = LZW_END + 1;
        width = 9;
        previous = LZW_CLEAR;
        continue;
      }
      int start = got;
      if (previous != LZW_CLEAR && next < LZW_CODES) {
        // The previous run and the first byte of this one, side by side in what was written.
        int run = previous < LZW_CLEAR ? 1 : length[previous];
        place[next] = start - run;
        length[next] = run + 1;
        next++;
      }
      if (code < LZW_CLEAR) {
        to[got++] = (byte) code;
      } else if (code < next) {
        int run = Math.min(length[code], to.length - got);
        for (int i = 0; i < run; i++) { // byte by byte, as a run may reach into itself
          to[got++] = to[place[code] + i];
        }
      } else {
        throw new WrongTiffException(
            "strip must be sound LZW (the file is damaged)", "code=" + code + ", next=" + next);
      }
      previous = code;
      if (next + 1 >= 1 << width && width < 12) {
        width++;
      }
    }
    return got;
  }

  private static int bits(byte[] from, long bit, int width) {
    int at = (int) (bit >> 3);
    int three = 0;
    for (int i = 0; i < 3; i++) {
      three = three << 8 | (at + i < from.length ? from[at + i] & 0xff : 0);
    }
    return three >> 24 - width - (int) (bit & 7) & (1 << width) - 1;
  }

  /** Adds up samples that are stored as differences from their left neighbour. */
  static void addDifferences(byte[] samples, int rowBytes, int bytes, ByteOrder order) {
    boolean big = order == ByteOrder.BIG_ENDIAN;
    for (int row = 0; row < samples.length; row += rowBytes) {
      for (int at = row + bytes; at < row + rowBytes; at += bytes) {
        int carry = 0;
        for (int i = 0; i < bytes; i++) { // from the least significant byte
          int b = big ? bytes - 1 - i : i;
          int sum = (samples[at + b] & 0xff) + (samples[at + b - bytes] & 0xff) + carry;
          samples[at + b] = (byte) sum;
          carry = sum >> 8;
        }
      }
    }
  }
}
