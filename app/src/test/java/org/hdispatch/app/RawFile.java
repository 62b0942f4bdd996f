package org.hdispatch.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hdispatch.porous.pore.PoreSpace;

/** Raw images for tests: 1 = pore, 0 = solid. */
public final class RawFile {
  private RawFile() {}

  public static Path write(Path folder, int nx, int ny, int nz, PoreSpace.VoxelPredicate pore) {
    PoreSpace space = PoreSpace.of(nx, ny, nz, pore);
    byte[] labels = new byte[space.voxels()];
    for (int voxel = 0; voxel < labels.length; voxel++) {
      labels[voxel] = (byte) (space.isPore(voxel) ? 1 : 0);
    }
    try {
      return Files.write(folder.resolve("image.raw"), labels);
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
