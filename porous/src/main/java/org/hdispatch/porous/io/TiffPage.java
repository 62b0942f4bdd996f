package org.hdispatch.porous.io;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.io.TiffDirectory.Form;
import org.hdispatch.porous.io.TiffDirectory.WrongTiffException;

/**
 * How a page stores its samples, one per pixel: those of a grey, palette or bilevel image.
 *
 * @param width pixels of a row
 * @param height rows
 * @param bits bits of a sample: 1, 2, 4, 8, 16, 32
 * @param signed whether samples have a sign
 * @param meaning what a sample means: 0 grey with 0 white, 1 grey with 0 black, 3 palette index
 */
record TiffPage(int width, int height, int bits, boolean signed, int meaning) {
  private static final int WIDTH = 256;
  private static final int HEIGHT = 257;
  private static final int BITS = 258;
  private static final int COMPRESSION = 259;
  private static final int PHOTOMETRIC = 262;
  private static final int FILL_ORDER = 266;
  private static final int STRIP_OFFSETS = 273;
  private static final int SAMPLES = 277;
  private static final int ROWS_PER_STRIP = 278;
  private static final int STRIP_BYTES = 279;
  private static final int PREDICTOR = 317;
  private static final int TILE_WIDTH = 322;
  private static final int TILE_HEIGHT = 323;
  private static final int TILE_OFFSETS = 324;
  private static final int TILE_BYTES = 325;
  private static final int SAMPLE_FORMAT = 339;

  /** The page of a directory, checked to be one that can be read. */
  static TiffPage of(TiffDirectory tags) throws IOException {
    long width = tags.number(WIDTH, "ImageWidth");
    long height = tags.number(HEIGHT, "ImageLength");
    if (width < 1 || height < 1 || width > Integer.MAX_VALUE || height > Integer.MAX_VALUE) {
      throw new WrongTiffException(
          "dimensions must be 1 to " + Integer.MAX_VALUE, "width=" + width + ", height=" + height);
    }
    long samples = tags.number(SAMPLES, 1);
    long meaning = tags.number(PHOTOMETRIC, "PhotometricInterpretation");
    if (samples != 1 || meaning != 0 && meaning != 1 && meaning != 3) {
      throw new WrongTiffException(
          "pages must be grey, palette or bilevel (convert colours to 8-bit grey)",
          "samples=" + samples + ", photometric=" + meaning);
    }
    long bits = tags.number(BITS, 1);
    long format = tags.number(SAMPLE_FORMAT, 1);
    boolean integer = format == 1 || format == 2 && bits >= 8 || format == 4;
    if (bits < 1 || bits > 32 || Long.bitCount(bits) != 1 || !integer) {
      throw new WrongTiffException(
          "labels must be integers of 0..255 (convert the pages to 8 bit)",
          "bits=" + bits + ", sample_format=" + format);
    }
    if (tags.number(FILL_ORDER, 1) != 1) {
      throw new WrongTiffException(
          "pages must keep the first pixel in the highest bits (save them again)", "fill_order=2");
    }
    TiffPage page = new TiffPage((int) width, (int) height, (int) bits, format == 2, (int) meaning);
    page.blocks(tags);
    return page;
  }

  /** The type of the samples in words. */
  String type() {
    String name = bits < 8 ? bits + " bit" : (signed ? "int" : "uint") + bits;
    return switch (meaning) {
      case 0 -> name + ", 0 = white";
      case 3 -> name + ", palette";
      default -> name;
    };
  }

  /** What a page is cut into: strips, or tiles. */
  private record Blocks(
      int width, int height, TiffPacking packing, boolean differences, int offsets, int counts) {}

  private Blocks blocks(TiffDirectory tags) throws IOException {
    TiffPacking packing = TiffPacking.of(tags.number(COMPRESSION, 1));
    boolean mayDiffer = packing == TiffPacking.LZW || packing == TiffPacking.DEFLATE;
    long predictor = mayDiffer ? tags.number(PREDICTOR, 1) : 1;
    if (predictor != 1 && (predictor != 2 || bits < 8)) {
      throw new WrongTiffException(
          "predictor must be 1 or 2 (save the pages again)",
          "predictor=" + predictor + ", bits=" + bits);
    }
    boolean tiled = tags.number(TILE_WIDTH, 0) > 0;
    long across = tiled ? tags.number(TILE_WIDTH, 0) : width;
    long down = tiled ? tags.number(TILE_HEIGHT, 0) : tags.number(ROWS_PER_STRIP, height);
    down = tiled ? down : Math.min(down, height);
    if (down < 1
        || across > Integer.MAX_VALUE
        || (across * bits + 7) / 8 * down > VoxelImage.MAX_VOXELS) {
      throw new WrongTiffException(
          "strips must hold 1 to " + VoxelImage.MAX_VOXELS + " bytes", "rows=" + down);
    }
    return new Blocks(
        (int) across,
        (int) down,
        packing,
        predictor == 2,
        tiled ? TILE_OFFSETS : STRIP_OFFSETS,
        tiled ? TILE_BYTES : STRIP_BYTES);
  }

  /**
   * Reads the part of the page that a box covers.
   *
   * @param channel the file
   * @param form how it writes numbers
   * @param tags the page's directory
   * @param box the box, inside the image; only its x and y count
   * @param labels where the labels go
   * @param to place of the first
   */
  void read(FileChannel channel, Form form, TiffDirectory tags, VoxelBox box, byte[] labels, int to)
      throws IOException {
    Blocks blocks = blocks(tags);
    int across = (int) (((long) width + blocks.width() - 1) / blocks.width());
    int down = (int) (((long) height + blocks.height() - 1) / blocks.height());
    if ((long) across * down > channel.size()) {
      throw new WrongTiffException(
          "strips must number less than bytes", "strips=" + (long) across * down);
    }
    int count = across * down;
    long[] offsets = tags.numbers(blocks.offsets(), "StripOffsets or TileOffsets", count);
    long[] counts = tags.numbers(blocks.counts(), "StripByteCounts or TileByteCounts", count);
    int x1 = box.x0() + box.nx();
    int y1 = box.y0() + box.ny();
    for (int by = box.y0() / blocks.height(); by < down && by * blocks.height() < y1; by++) {
      for (int bx = box.x0() / blocks.width(); bx < across && bx * blocks.width() < x1; bx++) {
        int blockX = bx * blocks.width();
        int blockY = by * blocks.height();
        boolean strip = blocks.offsets() == STRIP_OFFSETS; // tiles reach beyond the last row
        int rows = strip ? Math.min(blocks.height(), height - blockY) : blocks.height();
        int x = Math.max(blockX, box.x0());
        int y = Math.max(blockY, box.y0());
        int nx = (int) Math.min((long) blockX + blocks.width(), x1) - x;
        int ny = (int) Math.min((long) blockY + blocks.height(), y1) - y;
        VoxelBox part = new VoxelBox(x - blockX, y - blockY, 0, nx, ny, 1);
        int n = bx + across * by;
        byte[] labelsOfPart = part(channel, form, blocks, rows, offsets[n], counts[n], part);
        for (int row = 0; row < ny; row++) {
          int at = to + x - box.x0() + box.nx() * (y - box.y0() + row);
          System.arraycopy(labelsOfPart, row * nx, labels, at, nx);
        }
      }
    }
  }

  /** A part of a strip or tile. */
  private byte[] part(
      FileChannel channel, Form form, Blocks blocks, int rows, long at, long count, VoxelBox part)
      throws IOException {
    int rowBytes = (int) (((long) blocks.width() * bits + 7) / 8);
    int bytes = rowBytes * rows;
    boolean plain = blocks.packing() == TiffPacking.NONE;
    if (at < 1 || count < (plain ? bytes : 1) || count > VoxelImage.MAX_VOXELS) {
      throw new WrongTiffException(
          "strip must hold its rows (the file is damaged)",
          "offset=" + at + ", bytes=" + count + ", full=" + bytes);
    }
    if (count > channel.size() - at) {
      throw new EOFException("file ends at " + channel.size() + " bytes");
    }
    if (plain && bits >= 8) {
      return FlatRows.read(channel, at, blocks.width(), rows, part, labelType(form.order()));
    }
    byte[] packed = form.read(channel, at, (int) (plain ? bytes : count)).array();
    byte[] stored = blocks.packing().unpack(packed, bytes);
    if (blocks.differences()) {
      TiffPacking.addDifferences(stored, rowBytes, bits / 8, form.order());
    }
    byte[] labels = new byte[part.nx() * part.ny()];
    for (int row = 0; row < part.ny(); row++) {
      int from = rowBytes * (part.y0() + row);
      int to = part.nx() * row;
      if (bits < 8) {
        for (int i = 0; i < part.nx(); i++) {
          int bit = (part.x0() + i) * bits;
          int high = 8 - bits - (bit & 7);
          labels[to + i] = (byte) (stored[from + (bit >> 3)] >> high & (1 << bits) - 1);
        }
      } else {
        LabelType type = labelType(form.order());
        type.decode(stored, from + part.x0() * type.bytes(), labels, to, part.nx());
      }
    }
    return labels;
  }

  private LabelType labelType(ByteOrder order) {
    return new LabelType(bits / 8, signed, order);
  }
}
