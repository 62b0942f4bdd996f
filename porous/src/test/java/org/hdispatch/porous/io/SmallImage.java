package org.hdispatch.porous.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.hdispatch.porous.image.VoxelImage;

/** An image of 2 x 3 x 4 voxels, each with a label of its own. */
final class SmallImage {
  static final int NX = 2;
  static final int NY = 3;
  static final int NZ = 4;

  private SmallImage() {}

  /** Distinct for every voxel, up to 201. */
  static int label(int x, int y, int z) {
    return 60 * z + 10 * y + x;
  }

  /** In file order: x fastest. */
  static byte[] flat() {
    byte[] labels = new byte[NX * NY * NZ];
    int i = 0;
    for (int z = 0; z < NZ; z++) {
      for (int y = 0; y < NY; y++) {
        for (int x = 0; x < NX; x++) {
          labels[i++] = (byte) label(x, y, z);
        }
      }
    }
    return labels;
  }

  /** As HDF5 and NumPy index it: [z][y][x]. */
  static byte[][][] nested() {
    byte[][][] labels = new byte[NZ][NY][NX];
    for (int z = 0; z < NZ; z++) {
      for (int y = 0; y < NY; y++) {
        for (int x = 0; x < NX; x++) {
          labels[z][y][x] = (byte) label(x, y, z);
        }
      }
    }
    return labels;
  }

  /** Every voxel of a part stands where it stood in the whole. */
  static void assertPart(VoxelImage part, int x0, int y0, int z0) {
    for (int z = 0; z < part.nz(); z++) {
      for (int y = 0; y < part.ny(); y++) {
        for (int x = 0; x < part.nx(); x++) {
          assertEquals(
              label(x0 + x, y0 + y, z0 + z), part.label(x, y, z), "voxel " + x + "," + y + "," + z);
        }
      }
    }
  }
}
