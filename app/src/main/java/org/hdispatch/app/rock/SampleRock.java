package org.hdispatch.app.rock;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.zip.GZIPInputStream;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;

/**
 * The bundled rock: 64 x 64 x 64 voxels of Berea sandstone, 1 = pore.
 *
 * <p>Cut at voxel (320, 192, 192) of the 400 x 400 x 400 image: a block like the whole, with a
 * porosity of 0.192 (the whole: 0.196), percolating along x, y and z, and with permeabilities of
 * 1.0 to 1.7 D along them.
 */
public final class SampleRock implements ImageSource {
  /** Edge of a voxel, m (README of the image). */
  static final double VOXEL_EDGE = 5.345e-6;

  /** Voxels along each axis. */
  static final int SIZE = 64;

  private static final String RESOURCE = "berea_64.raw.gz";

  @Override
  public String name() {
    return "Berea sandstone (bundled sample)";
  }

  @Override
  public VoxelBox whole() {
    return VoxelBox.whole(SIZE, SIZE, SIZE);
  }

  @Override
  public OptionalDouble voxelEdge() {
    return OptionalDouble.of(VOXEL_EDGE);
  }

  @Override
  public Map<String, Object> facts() {
    Map<String, Object> facts = new LinkedHashMap<>();
    facts.put("format", "bundled");
    facts.put("origin", "voxel (320, 192, 192) of the 400 x 400 x 400 image");
    return facts;
  }

  @Override
  public List<String> citation() {
    return List.of(
        "Imperial College London, Berea Sandstone, figshare 1153794,"
            + " doi:10.6084/m9.figshare.1153794",
        "Dong & Blunt 2009, Phys. Rev. E 80, 036307");
  }

  @Override
  public VoxelImage read(VoxelBox box) {
    try (InputStream packed = SampleRock.class.getResourceAsStream(RESOURCE);
        InputStream voxels = new GZIPInputStream(packed)) {
      return VoxelImage.of(SIZE, SIZE, SIZE, voxels.readAllBytes()).crop(box);
    } catch (IOException e) {
      throw new UncheckedIOException("bundled sample must be readable: resource=" + RESOURCE, e);
    }
  }
}
