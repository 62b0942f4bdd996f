package org.hdispatch.porous.io;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import org.hdispatch.porous.image.VoxelBox;

/**
 * Reads a box of voxels out of a flat volume in a file, row by row, through one bounded buffer.
 *
 * <p>Both raw files and contiguous HDF5 datasets are flat volumes. Rows that follow one another in
 * the file are read together.
 */
final class FlatRows {
  private static final int BUFFER_BYTES = 1 << 20;

  private FlatRows() {}

  /**
   * Reads a box.
   *
   * @param channel the file
   * @param start where the volume begins, in bytes
   * @param nx voxels of the volume along x
   * @param ny voxels of the volume along y
   * @param box the box, already checked to lie inside the volume
   * @param type how a voxel is stored
   * @return the labels of the box, x fastest
   */
  static byte[] read(FileChannel channel, long start, int nx, int ny, VoxelBox box, LabelType type)
      throws IOException {
    byte[] labels = new byte[Math.toIntExact(box.voxels())];
    int size = type.bytes();
    // A box as wide as the volume is contiguous over a plane; otherwise only over a row.
    boolean fullRows = box.nx() == nx;
    int run = fullRows ? Math.multiplyExact(box.nx(), box.ny()) : box.nx();
    int runsPerPlane = fullRows ? 1 : box.ny();
    ByteBuffer buffer =
        ByteBuffer.allocate((int) Math.min(BUFFER_BYTES / size * (long) size, (long) run * size));
    int to = 0;
    for (int z = 0; z < box.nz(); z++) {
      for (int r = 0; r < runsPerPlane; r++) {
        long voxel = box.x0() + nx * (box.y0() + r + ny * ((long) box.z0() + z));
        long at = start + voxel * size;
        int left = run;
        while (left > 0) {
          int part = Math.min(left, buffer.capacity() / size);
          buffer.clear().limit(part * size);
          while (buffer.hasRemaining()) {
            int got = channel.read(buffer, at);
            if (got < 0) {
              throw new EOFException("file ends at " + channel.size() + " bytes");
            }
            at += got;
          }
          type.decode(buffer.array(), 0, labels, to, part);
          to += part;
          left -= part;
        }
      }
    }
    return labels;
  }
}
