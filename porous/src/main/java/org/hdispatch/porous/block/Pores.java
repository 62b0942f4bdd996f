package org.hdispatch.porous.block;

import java.util.List;
import java.util.Optional;
import org.hdispatch.porous.flow.SolidFractions;
import org.hdispatch.porous.image.LabelRule;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.pore.PoreSpace;

/**
 * The pores of a part of an image, as flows take them.
 *
 * @param space the pore space; of voxels solid in part, those that are less than half
 * @param solid solid fractions, if walls are immersed
 */
public record Pores(PoreSpace space, Optional<SolidFractions> solid) {
  /** Heap to make a pore space and to see what spans it: image, pore space, its part, its runs. */
  public static final int BYTES_PER_VOXEL = 5;

  /**
   * The pores of an image.
   *
   * @param rule which labels are pore, if the image is segmented
   * @param grey grey values of pure pore and pure solid, if walls are immersed and the image is not
   *     segmented; or empty
   * @throws IllegalArgumentException if the two grey values are the same, or none of 0 to 255
   */
  public static Pores of(VoxelImage image, LabelRule rule, Walls walls, List<Integer> grey) {
    if (!grey.isEmpty()) {
      SolidFractions solid = SolidFractions.ofGrey(image, grey.get(0), grey.get(1));
      return new Pores(solid.below(0.5), Optional.of(solid));
    }
    PoreSpace space = PoreSpace.of(image, rule);
    return new Pores(
        space, walls == Walls.IMB ? Optional.of(SolidFractions.of(space)) : Optional.empty());
  }

  /**
   * The same in finer voxels.
   *
   * @param n voxels along an edge of one
   * @throws IllegalArgumentException if there are walls that are immersed, or too many voxels
   * @throws HeapException if it does not fit
   */
  public Pores refined(int n, HeapLimit heap) {
    if (n == 1) {
      return this;
    }
    if (solid.isPresent()) {
      throw new IllegalArgumentException(BlockSettings.NOT_REFINED);
    }
    heap.require(
        "a rock of " + space.voxels() + " voxels, each cut into " + n * n * n,
        BYTES_PER_VOXEL * (double) space.voxels() * n * n * n);
    return new Pores(
        PoreSpace.of(
            times(n, space.nx()),
            times(n, space.ny()),
            times(n, space.nz()),
            (x, y, z) -> space.isPore(x / n, y / n, z / n)),
        solid);
  }

  private static int times(int n, int length) {
    return (int) Math.min((long) n * length, Integer.MAX_VALUE);
  }
}
