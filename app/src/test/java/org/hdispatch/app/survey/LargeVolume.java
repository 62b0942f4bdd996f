package org.hdispatch.app.survey;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.hdispatch.app.rock.SampleRock;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;

/**
 * A volume of 1840 x 1840 x 1940 voxels in a file of some megabytes: HDF5, chunked and compressed,
 * in which a few blocks of the grid of 200³ blocks are rock, and all else was never written.
 *
 * <p>The rock is the bundled sample of Berea sandstone beside its mirror images, and beginning
 * elsewhere in each block. Labels: 1 pore, 0 solid, {@value #FILL} where there is nothing.
 *
 * <pre>
 * mvn -q -B test-compile -pl app -am
 * java -cp app/target/test-classes:app/target/classes:porous/target/classes org.hdispatch.app.survey.LargeVolume core.h5
 * ./hdispatch survey core.h5 --block 200 --blocks 0,40,364,728 --outside-value 2 --output survey
 * </pre>
 */
final class LargeVolume {
  static final int NX = 1840;
  static final int NY = 1840;
  static final int NZ = 1940;

  /** Label of the voxels that were never written. */
  static final int FILL = 2;

  /** Edge of a block of rock; the first one begins at the first voxel. */
  static final int BLOCK = 200;

  /** Numbers of the blocks of rock in the grid, x fastest: the first, the last, two between. */
  static final List<Integer> ROCKS = List.of(0, 40, 364, 728);

  private static final int CHUNK = 64;
  private static final double VOXEL_EDGE = 2.8e-6;

  private LargeVolume() {}

  /** Where a block of rock lies. */
  static VoxelBox box(int block) {
    int nx = NX / BLOCK;
    int ny = NY / BLOCK;
    return new VoxelBox(
        block % nx * BLOCK,
        block / nx % ny * BLOCK,
        block / (nx * ny) * BLOCK,
        BLOCK,
        BLOCK,
        BLOCK);
  }

  /** The label of a voxel. */
  static int label(VoxelImage sample, int x, int y, int z) {
    int nx = NX / BLOCK;
    int ny = NY / BLOCK;
    boolean inGrid = x < nx * BLOCK && y < ny * BLOCK && z < NZ / BLOCK * BLOCK;
    int rock = inGrid ? ROCKS.indexOf(x / BLOCK + nx * (y / BLOCK + ny * (z / BLOCK))) : -1;
    if (rock < 0) {
      return FILL;
    }
    int shift = 17 * rock;
    int n = sample.nx();
    int i = mirrored(x % BLOCK + shift, n);
    int j = mirrored(y % BLOCK + 2 * shift, n);
    int k = mirrored(z % BLOCK + 3 * shift, n);
    return sample.label(i + n * (j + n * k));
  }

  private static int mirrored(int place, int length) {
    int in = place % (2 * length);
    return in < length ? in : 2 * length - 1 - in;
  }

  /** Writes the volume. */
  static void write(Path file) throws IOException {
    SampleRock rock = new SampleRock();
    VoxelImage sample = rock.read(rock.whole());
    byte[] voxels = new byte[CHUNK * CHUNK * CHUNK];
    try (SparseHdf5 volume =
        new SparseHdf5(file, new int[] {NZ, NY, NX}, CHUNK, FILL, VOXEL_EDGE)) {
      for (int z = 0; z < NZ; z += CHUNK) {
        for (int y = 0; y < NY; y += CHUNK) {
          for (int x = 0; x < NX; x += CHUNK) {
            if (holdsRock(x, y, z)) {
              fill(sample, x, y, z, voxels);
              volume.chunk(z, y, x, voxels);
            }
          }
        }
      }
    }
  }

  private static boolean holdsRock(int x, int y, int z) {
    return ROCKS.stream()
        .map(LargeVolume::box)
        .anyMatch(box -> meets(x, box.x0()) && meets(y, box.y0()) && meets(z, box.z0()));
  }

  private static boolean meets(int chunk, int block) {
    return chunk < block + BLOCK && block < chunk + CHUNK;
  }

  private static void fill(VoxelImage sample, int x0, int y0, int z0, byte[] voxels) {
    int to = 0;
    for (int z = z0; z < z0 + CHUNK; z++) {
      for (int y = y0; y < y0 + CHUNK; y++) {
        for (int x = x0; x < x0 + CHUNK; x++) {
          voxels[to++] = (byte) label(sample, x, y, z);
        }
      }
    }
  }

  /**
   * Writes the volume.
   *
   * @param args the file
   */
  public static void main(String[] args) throws IOException {
    if (args.length != 1) {
      throw new IllegalArgumentException("one file must be named: args=" + Arrays.toString(args));
    }
    write(Path.of(args[0]));
  }
}
