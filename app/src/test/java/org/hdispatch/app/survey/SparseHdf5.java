package org.hdispatch.app.survey;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.Deflater;

/**
 * Writes an HDF5 file of one dataset {@code /volume} of bytes, chunked and compressed, of which
 * only some chunks are there; the others read as the fill value. Nothing but one chunk is held in
 * memory, so that the dataset may be of any size. (jHDF writes whole arrays only.)
 *
 * <p>The structures are those of the HDF5 File Format Specification, version 3.0, which every
 * release since 1.0 reads: superblock 0, object headers 1, B-trees 1, layout 3. Addresses and
 * lengths have 8 bytes; all is little-endian. The file is right once it has been closed.
 *
 * <pre>
 * 0    superblock, written last
 * 96   chunks, in the order in which they come
 *      B-tree of the chunks, its leaves first; object header of the dataset;
 *      name, symbol, B-tree and object header of the root group
 * </pre>
 */
final class SparseHdf5 implements AutoCloseable {
  private static final String NAME = "volume";
  private static final long UNDEFINED = -1;
  private static final int SUPERBLOCK_BYTES = 96;

  /** Half the most children of a node: of groups by the superblock, of chunks as it cannot say. */
  private static final int GROUP_LEAF_K = 4;

  private static final int GROUP_K = 16;
  private static final int CHUNK_K = 32;

  /** Bytes of a key of a chunk: size, filters left out, place along z, y, x and within the byte. */
  private static final int CHUNK_KEY = 8 + 4 * 8;

  private final FileChannel file;
  private final int[] shape; // z, y, x
  private final int edge;
  private final byte fill;
  private final double voxelEdge;
  private final List<Child> chunks = new ArrayList<>();
  private final Deflater deflater = new Deflater();
  private final byte[] packed;
  private long end = SUPERBLOCK_BYTES;

  /**
   * A chunk, or a node of the tree of chunks, by its first one.
   *
   * @param place of the first chunk: z, y, x, voxels
   * @param bytes of the first chunk
   * @param address where it is
   */
  private record Child(int[] place, int bytes, long address) {}

  /**
   * A file without a chunk, over an existing one.
   *
   * @param shape of the dataset, z, y, x
   * @param edge of a chunk, voxels
   * @param fill what reads where there is no chunk
   * @param voxelEdge the attribute {@code voxel_size_m}, m
   */
  SparseHdf5(Path path, int[] shape, int edge, int fill, double voxelEdge) throws IOException {
    this.shape = shape.clone();
    this.edge = edge;
    this.fill = (byte) fill;
    this.voxelEdge = voxelEdge;
    packed = new byte[edge * edge * edge + 1024]; // what does not shrink grows by less than that
    file =
        FileChannel.open(
            path,
            StandardOpenOption.CREATE,
            StandardOpenOption.TRUNCATE_EXISTING,
            StandardOpenOption.WRITE);
  }

  /**
   * Adds a chunk; they come z slowest, x fastest.
   *
   * @param voxels its edge³ voxels, x fastest; those beyond the dataset do not matter
   */
  void chunk(int z, int y, int x, byte[] voxels) throws IOException {
    deflater.reset();
    deflater.setInput(voxels);
    deflater.finish();
    int bytes = deflater.deflate(packed);
    if (!deflater.finished()) {
      throw new IllegalStateException("chunk must fit: bytes=" + bytes);
    }
    chunks.add(new Child(new int[] {z, y, x}, bytes, append(ByteBuffer.wrap(packed, 0, bytes))));
  }

  /** Writes what was put into a buffer at the end of the file; returns its address. */
  private long append(ByteBuffer bytes) throws IOException {
    long address = end;
    while (bytes.hasRemaining()) {
      end += file.write(bytes, end);
    }
    end = (end + 7) / 8 * 8;
    return address;
  }

  private static ByteBuffer bytes(int count) {
    return ByteBuffer.allocate(count).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static ByteBuffer text(ByteBuffer to, String text) {
    return to.put(text.getBytes(StandardCharsets.US_ASCII));
  }

  /** A node is as long in the file as if it had all its children. */
  private static ByteBuffer node(int type, int level, int k, int keyBytes, int children) {
    ByteBuffer node = bytes(24 + 2 * k * 8 + (2 * k + 1) * keyBytes);
    text(node, "TREE").put((byte) type).put((byte) level).putShort((short) children);
    return node;
  }

  private long treeOfChunks() throws IOException {
    List<Child> level = chunks;
    for (int height = 0; height == 0 || level.size() > 1; height++) {
      List<Child> above = new ArrayList<>();
      int nodes = (level.size() - 1) / (2 * CHUNK_K) + 1;
      long first = end;
      int length = node(1, 0, CHUNK_K, CHUNK_KEY, 0).capacity();
      for (int n = 0; n < nodes; n++) {
        List<Child> own =
            level.subList(n * 2 * CHUNK_K, Math.min((n + 1) * 2 * CHUNK_K, level.size()));
        ByteBuffer node = node(1, height, CHUNK_K, CHUNK_KEY, own.size());
        node.putLong(n == 0 ? UNDEFINED : first + (long) (n - 1) * length)
            .putLong(n == nodes - 1 ? UNDEFINED : first + (long) (n + 1) * length);
        for (Child each : own) {
          key(node, each.bytes(), each.place(), 0);
          node.putLong(each.address());
        }
        if (n < nodes - 1) {
          key(node, 0, level.get((n + 1) * 2 * CHUNK_K).place(), 0);
        } else {
          key(node, 0, chunks.get(chunks.size() - 1).place(), edge); // beyond the last of all
        }
        node.rewind();
        above.add(new Child(own.get(0).place(), own.get(0).bytes(), append(node)));
      }
      level = above;
    }
    return level.get(0).address();
  }

  private static void key(ByteBuffer node, int bytes, int[] place, int beyond) {
    node.putInt(bytes).putInt(0);
    for (int along : place) {
      node.putLong(along + beyond);
    }
    node.putLong(0);
  }

  /** An object header of some messages, each a type and its data. */
  private long header(List<Message> messages) throws IOException {
    int length = messages.stream().mapToInt(each -> 8 + each.data().capacity()).sum();
    ByteBuffer header = bytes(16 + length);
    header.put((byte) 1).put((byte) 0).putShort((short) messages.size()).putInt(1).putInt(length);
    header.position(16);
    for (Message each : messages) {
      header.putShort((short) each.type()).putShort((short) each.data().capacity()).putInt(0);
      header.put(each.data().rewind());
    }
    return append(header.flip());
  }

  /** A message of an object header; its data is a multiple of 8 bytes long. */
  private record Message(int type, ByteBuffer data) {}

  private long dataset(long tree) throws IOException {
    ByteBuffer space = bytes(32).put((byte) 1).put((byte) 3).position(8);
    for (int length : shape) {
      space.putLong(length);
    }
    ByteBuffer type = bytes(16).putInt(0x10).putInt(1).putShort((short) 0).putShort((short) 8);
    // Version 2; chunks come one by one; a fill value is written if one is set, and one is.
    ByteBuffer filling =
        bytes(16).put((byte) 2).put((byte) 3).put((byte) 2).put((byte) 1).putInt(1).put(fill);
    ByteBuffer filters =
        bytes(24).put((byte) 1).put((byte) 1).position(8).putShort((short) 1).putShort((short) 0);
    filters.putShort((short) 0).putShort((short) 1).putInt(6); // deflate, level 6
    ByteBuffer layout = bytes(32).put((byte) 3).put((byte) 2).put((byte) 4).putLong(tree);
    layout.putInt(edge).putInt(edge).putInt(edge).putInt(1);
    return header(
        List.of(
            new Message(0x01, space),
            new Message(0x03, type),
            new Message(0x05, filling),
            new Message(0x0b, filters),
            new Message(0x08, layout),
            new Message(0x0c, voxelSize())));
  }

  /** An attribute: a scalar, IEEE 754 double. */
  private ByteBuffer voxelSize() {
    ByteBuffer attribute = bytes(64).put((byte) 1).put((byte) 0);
    attribute.putShort((short) 13).putShort((short) 20).putShort((short) 8); // of its three parts
    text(attribute, "voxel_size_m").position(24);
    attribute.putInt(0x3f2011).putInt(8).putShort((short) 0).putShort((short) 64);
    attribute.put((byte) 52).put((byte) 11).put((byte) 0).put((byte) 52).putInt(1023);
    return attribute.position(48).put((byte) 1).position(56).putDouble(voxelEdge);
  }

  private long root(long dataset) throws IOException {
    long names = append(text(bytes(16).position(8), NAME).rewind());
    ByteBuffer heap = text(bytes(32), "HEAP").putInt(0).putLong(16).putLong(1).putLong(names);
    long heapAt = append(heap.flip());
    ByteBuffer symbols = text(bytes(8 + 2 * GROUP_LEAF_K * 40), "SNOD").put((byte) 1).put((byte) 0);
    symbols.putShort((short) 1).putLong(8).putLong(dataset);
    long symbolsAt = append(symbols.rewind());
    ByteBuffer tree = node(0, 0, GROUP_K, 8, 1).putLong(UNDEFINED).putLong(UNDEFINED);
    long treeAt = append(tree.putLong(0).putLong(symbolsAt).putLong(8).rewind());
    return header(List.of(new Message(0x11, bytes(16).putLong(treeAt).putLong(heapAt))));
  }

  /**
   * Writes what finds the chunks.
   *
   * @throws IllegalStateException if there is no chunk
   */
  @Override
  public void close() throws IOException {
    try (file) {
      if (chunks.isEmpty()) {
        throw new IllegalStateException("dataset must have a chunk");
      }
      long root = root(dataset(treeOfChunks()));
      ByteBuffer first = bytes(SUPERBLOCK_BYTES);
      first.put((byte) 0x89).put(new byte[] {'H', 'D', 'F', '\r', '\n', 0x1a, '\n'});
      first.position(13).put((byte) 8).put((byte) 8).position(16);
      first.putShort((short) GROUP_LEAF_K).putShort((short) GROUP_K).putInt(0);
      first.putLong(0).putLong(UNDEFINED).putLong(end).putLong(UNDEFINED);
      first.putLong(0).putLong(root).rewind();
      file.write(first, 0);
      file.force(true);
    } finally {
      deflater.end();
    }
  }
}
