package org.hdispatch.porous.survey;

import java.util.ArrayList;
import java.util.List;
import org.hdispatch.porous.image.LabelRule;
import org.hdispatch.porous.image.Phase;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.io.ImageFileException;

/**
 * The porosity of cubes of one size, side by side from the first voxel of an image: without a flow,
 * a cheap look at what size of blocks represents the rock.
 *
 * @param edge of the cubes, voxels
 * @param porosity of the cubes that lie inside as a whole
 */
public record PorosityScale(int edge, Spread porosity) {
  /** Edge of the smallest cubes. */
  private static final int LEAST = 8;

  /** The most of the smallest cubes: larger images begin with larger ones. */
  private static final long MOST_CUBES = 1 << 24;

  /** Reads a part of an image. */
  @FunctionalInterface
  public interface Reader {
    /** Reads a box. */
    VoxelImage read(VoxelBox box) throws ImageFileException;
  }

  /**
   * Porosities of cubes of edge 8, 16, 32 and so on, as long as at least two of them fit. An image
   * of more than 2^24 of the smallest ones begins with a larger edge. It is read once, a layer of
   * the smallest cubes at a time.
   *
   * @param whole the image
   * @param reader reads it
   * @param rule which labels are pore
   */
  public static List<PorosityScale> of(VoxelBox whole, Reader reader, LabelRule rule)
      throws ImageFileException {
    int edge = LEAST;
    while (whole.voxels() / edge / edge / edge > MOST_CUBES) {
      edge *= 2;
    }
    Cubes cubes = new Cubes(edge, whole.nx() / edge, whole.ny() / edge, whole.nz() / edge);
    if (cubes.count() > 0) {
      count(cubes, whole, reader, rule);
    }
    List<PorosityScale> scales = new ArrayList<>();
    while (cubes.count() > 1) {
      scales.add(new PorosityScale(cubes.edge, Spread.of(cubes.porosities())));
      cubes = cubes.joined();
    }
    return scales;
  }

  private static void count(Cubes cubes, VoxelBox whole, Reader reader, LabelRule rule)
      throws ImageFileException {
    boolean[] pore = new boolean[VoxelImage.LABELS];
    for (int label = 0; label < pore.length; label++) {
      pore[label] = rule.phase(label) == Phase.PORE;
    }
    for (int layer = 0; layer < cubes.nz; layer++) {
      VoxelImage image =
          reader.read(
              new VoxelBox(
                  whole.x0(),
                  whole.y0(),
                  whole.z0() + layer * cubes.edge,
                  cubes.nx * cubes.edge,
                  cubes.ny * cubes.edge,
                  cubes.edge));
      for (int n = 0; n < image.voxels(); n++) {
        if (pore[image.label(n)]) {
          int x = n % image.nx() / cubes.edge;
          int y = n / image.nx() % image.ny() / cubes.edge;
          cubes.pores[x + cubes.nx * (y + cubes.ny * layer)]++;
        }
      }
    }
  }

  /** Pore voxels in each of the cubes, x fastest. */
  private static final class Cubes {
    final int edge;
    final int nx;
    final int ny;
    final int nz;
    final long[] pores;

    Cubes(int edge, int nx, int ny, int nz) {
      this.edge = edge;
      this.nx = nx;
      this.ny = ny;
      this.nz = nz;
      pores = new long[nx * ny * nz];
    }

    int count() {
      return pores.length;
    }

    double[] porosities() {
      double voxels = (double) edge * edge * edge;
      double[] porosities = new double[pores.length];
      for (int n = 0; n < pores.length; n++) {
        porosities[n] = pores[n] / voxels;
      }
      return porosities;
    }

    /** Cubes of twice the edge; what fills none is left out. */
    Cubes joined() {
      Cubes twice = new Cubes(2 * edge, nx / 2, ny / 2, nz / 2);
      for (int z = 0; z < twice.nz * 2; z++) {
        for (int y = 0; y < twice.ny * 2; y++) {
          for (int x = 0; x < twice.nx * 2; x++) {
            twice.pores[x / 2 + twice.nx * (y / 2 + twice.ny * (z / 2))] +=
                pores[x + nx * (y + ny * z)];
          }
        }
      }
      return twice;
    }
  }
}
