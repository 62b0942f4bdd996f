package org.hdispatch.porous.io;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.TreeMap;
import java.util.zip.Deflater;

/** TIFF files for tests, written byte by byte: tags as given, blocks as cut and packed here. */
final class TiffBytes {
  static final int COMPRESSION = 259;
  static final int PHOTOMETRIC = 262;
  static final int SAMPLES = 277;
  static final int ROWS_PER_STRIP = 278;
  static final int PREDICTOR = 317;
  static final int TILE_WIDTH = 322;
  static final int TILE_HEIGHT = 323;
  static final int SAMPLE_FORMAT = 339;

  private static final int DEFLATE = 8;
  private static final int PACK_BITS = 32773;

  final TreeMap<Integer, Long> tags = new TreeMap<>();
  ByteOrder order = ByteOrder.LITTLE_ENDIAN;
  boolean big;
  String description = "";

  private final ByteArrayOutputStream file = new ByteArrayOutputStream();
  private final List<Integer> links = new ArrayList<>(); // where the place of a page is written
  private final List<Long> targets = new ArrayList<>();

  TiffBytes tag(int id, long value) {
    tags.put(id, value);
    return this;
  }

  private ByteBuffer buffer(int bytes) {
    return ByteBuffer.allocate(bytes).order(order);
  }

  private void put(ByteBuffer bytes) {
    file.writeBytes(bytes.array());
  }

  private ByteBuffer place(long value) {
    return big ? buffer(8).putLong(value) : buffer(4).putInt((int) value);
  }

  private void head() {
    put(ByteBuffer.wrap((order == ByteOrder.LITTLE_ENDIAN ? "II" : "MM").getBytes()));
    put(buffer(2).putShort((short) (big ? 43 : 42)));
    if (big) {
      put(buffer(4).putShort((short) 8).putShort((short) 0));
    }
    links.add(file.size());
    put(place(0));
  }

  /** Adds a page of samples, x fastest, of so many bits. */
  TiffBytes page(int width, int height, int bits, int[] samples) {
    if (file.size() == 0) {
      head();
    }
    boolean tiled = tags.containsKey(TILE_WIDTH);
    int across = tiled ? tags.get(TILE_WIDTH).intValue() : width;
    int down = tags.getOrDefault(tiled ? TILE_HEIGHT : ROWS_PER_STRIP, (long) height).intValue();
    List<Long> offsets = new ArrayList<>();
    List<Long> counts = new ArrayList<>();
    for (int y = 0; y < height; y += down) {
      for (int x = 0; x < width; x += across) {
        int rows = tiled ? down : Math.min(down, height - y);
        byte[] block = packed(block(width, height, bits, samples, x, y, across, rows));
        offsets.add((long) file.size());
        counts.add((long) block.length);
        file.writeBytes(block);
      }
    }
    TreeMap<Integer, List<Long>> all = new TreeMap<>();
    all.put(256, List.of((long) width));
    all.put(257, List.of((long) height));
    all.put(258, List.of((long) bits));
    all.put(PHOTOMETRIC, List.of(1L));
    tags.forEach((id, value) -> all.put(id, List.of(value)));
    all.put(tiled ? 324 : 273, offsets);
    all.put(tiled ? 325 : 279, counts);
    directory(all);
    return this;
  }

  private byte[] block(
      int width, int height, int bits, int[] samples, int x0, int y0, int across, int rows) {
    int rowBytes = (across * bits + 7) / 8;
    byte[] block = new byte[rowBytes * rows];
    boolean differences = tags.getOrDefault(PREDICTOR, 1L) == 2;
    for (int y = 0; y < rows; y++) {
      for (int x = 0; x < across; x++) {
        boolean inside = x0 + x < width && y0 + y < height;
        int sample = inside ? samples[x0 + x + width * (y0 + y)] : 77; // tiles are padded
        if (differences && x > 0) {
          boolean leftInside = x0 + x - 1 < width && y0 + y < height;
          sample -= leftInside ? samples[x0 + x - 1 + width * (y0 + y)] : 77;
        }
        if (bits < 8) {
          int bit = x * bits;
          block[rowBytes * y + bit / 8] |=
              (byte) ((sample & (1 << bits) - 1) << 8 - bits - bit % 8);
        } else {
          ByteBuffer to = ByteBuffer.wrap(block).order(order).position(rowBytes * y + x * bits / 8);
          switch (bits) {
            case 8 -> to.put((byte) sample);
            case 16 -> to.putShort((short) sample);
            default -> to.putInt(sample);
          }
        }
      }
    }
    return block;
  }

  private byte[] packed(byte[] block) {
    int compression = tags.getOrDefault(COMPRESSION, 1L).intValue();
    if (compression == DEFLATE) {
      Deflater deflater = new Deflater();
      deflater.setInput(block);
      deflater.finish();
      byte[] packed = new byte[2 * block.length + 100];
      int length = deflater.deflate(packed);
      deflater.end();
      return Arrays.copyOf(packed, length);
    } else if (compression == PACK_BITS) {
      ByteArrayOutputStream packed = new ByteArrayOutputStream();
      for (int at = 0; at < block.length; ) {
        int run = 1;
        while (at + run < block.length && run < 128 && block[at + run] == block[at]) {
          run++;
        }
        packed.write(run > 1 ? 1 - run : 0);
        packed.write(block[at]);
        packed.write(-128); // which means nothing
        at += run;
      }
      return packed.toByteArray();
    }
    return block;
  }

  private void directory(TreeMap<Integer, List<Long>> all) {
    int text = file.size();
    byte[] characters = (description + "\0").getBytes(StandardCharsets.US_ASCII);
    file.writeBytes(characters);
    TreeMap<Integer, Long> places = new TreeMap<>(); // of values that do not fit into their tag
    all.forEach(
        (id, values) -> {
          if (values.size() > 1) {
            places.put(id, (long) file.size());
            values.forEach(value -> put(place(value)));
          }
        });
    targets.add((long) file.size());
    int count = all.size() + 1;
    put(big ? buffer(8).putLong(count) : buffer(2).putShort((short) count));
    all.forEach(
        (id, values) -> {
          // One number as SHORT where it fits, left-justified; several as LONG or LONG8.
          boolean isShort = values.size() == 1 && values.get(0) < 1 << 16;
          int type = isShort ? 3 : big ? 16 : 4;
          put(buffer(4).putShort((short) (int) id).putShort((short) type));
          put(place(values.size()));
          ByteBuffer value = place(0);
          if (isShort) {
            value.putShort(0, (short) (long) values.get(0));
            put(value);
          } else {
            put(place(values.size() > 1 ? places.get(id) : values.get(0)));
          }
        });
    put(buffer(4).putShort((short) 270).putShort((short) 2));
    put(place(characters.length));
    put(characters.length <= (big ? 8 : 4) ? place(0) : place(text));
    links.add(file.size());
    put(place(0));
  }

  /** The file, its pages linked. */
  byte[] bytes() {
    byte[] bytes = file.toByteArray();
    for (int page = 0; page < targets.size(); page++) {
      System.arraycopy(place(targets.get(page)).array(), 0, bytes, links.get(page), big ? 8 : 4);
    }
    return bytes;
  }

  /** Where the place of a page is written. */
  int link(int page) {
    return links.get(page);
  }
}
