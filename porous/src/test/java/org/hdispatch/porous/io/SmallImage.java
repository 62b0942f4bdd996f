package org.hdispatch.porous.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.file.Path;
import org.hdispatch.porous.image.VoxelBox;
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

  /** The file holds this image, and every box of it reads as the part that it is. */
  static void assertEveryBox(ImageFile file) throws IOException {
    assertEquals(VoxelBox.whole(NX, NY, NZ), file.whole());
    for (int x0 = 0; x0 < NX; x0++) {
      for (int y0 = 0; y0 < NY; y0++) {
        for (int z0 = 0; z0 < NZ; z0++) {
          for (int nx = 1; x0 + nx <= NX; nx++) {
            for (int ny = 1; y0 + ny <= NY; ny++) {
              for (int nz = 1; z0 + nz <= NZ; nz++) {
                VoxelBox box = new VoxelBox(x0, y0, z0, nx, ny, nz);
                VoxelImage part = file.read(box);
                assertEquals(box.voxels(), part.voxels());
                assertPart(part, x0, y0, z0);
                assertEquals(file.voxelEdge(), part.voxelEdge());
              }
            }
          }
        }
      }
    }
  }

  /** The labels of {@link #flat}, each in so many bytes. */
  static byte[] wide(int bytes, ByteOrder order) {
    byte[] labels = flat();
    byte[] wide = new byte[labels.length * bytes];
    for (int i = 0; i < labels.length; i++) {
      wide[i * bytes + (order == ByteOrder.BIG_ENDIAN ? bytes - 1 : 0)] = labels[i];
    }
    return wide;
  }

  /** What opening or else reading the file throws: one line that names the file. */
  static String refusal(Opening opening, Path named) {
    ImageFileException e =
        assertThrows(
            ImageFileException.class,
            () -> {
              ImageFile file = opening.open();
              file.read(file.whole());
            });
    assertEquals(1, e.getMessage().lines().count());
    assertTrue(e.getMessage().contains("file=" + named), e.getMessage());
    return e.getMessage();
  }

  /** How a file is opened. */
  interface Opening {
    ImageFile open() throws ImageFileException;
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
