package org.hdispatch.porous.pore;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.hdispatch.cell.Ends;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.LabelRule;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.io.Hdf5Dataset;
import org.hdispatch.porous.io.Hdf5Images;
import org.hdispatch.porous.io.RawImages;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * The Berea sandstone of Imperial College (400^3, 5.345 um): needs the folder of rock images in the
 * system property {@code hdispatch.data}; skipped without it.
 */
class BereaPercolationTest {
  private Path folder;

  @BeforeEach
  void findImages() {
    String data = System.getProperty("hdispatch.data", "");
    assumeTrue(!data.isBlank(), "hdispatch.data is not set: the large rock images are not tested");
    folder = Path.of(data).resolve("berea");
    assertTrue(Files.isDirectory(folder), "no folder berea in hdispatch.data=" + data);
  }

  private static PoreSpace poreSpace(VoxelImage image) {
    return PoreSpace.of(image, LabelRule.poreIs(1));
  }

  @Test
  void porosityAndSpanningShareAreThoseMeasured() throws IOException {
    Hdf5Dataset volume = Hdf5Images.select(folder.resolve("berea_400.h5"), Optional.empty());
    VoxelImage image = Hdf5Images.read(volume);
    assertEquals(5.345e-6, image.voxelEdge().getAsDouble());
    PoreSpace space = poreSpace(image);
    assertEquals(12_572_994, space.poreVoxels()); // data/berea/README.md
    assertEquals(0.19645, space.porosity(), 5e-6);
    for (Axis axis : Axis.values()) {
      Percolation percolation = Percolation.along(space, axis, Ends.OPEN, Ends.OPEN);
      double share = percolation.connectedPorosity() / space.porosity();
      assertEquals(0.99372, share, 5e-6); // data/berea/README.md: one cluster spans x, y and z
      assertEquals(1, percolation.spanningClusters());
    }
    VoxelImage raw = RawImages.read(folder.resolve("berea_400.raw.gz"), 400, 400, 400);
    assertTrue(Arrays.equals(image.toLabels(), raw.toLabels()));
  }

  /** Largest cluster of every 128^3 block: Mosser et al. 2017, berea_128_blocks.csv. */
  @Test
  void blocksConnectAlongZAsPublished() throws IOException {
    Hdf5Dataset volume = Hdf5Images.select(folder.resolve("berea_400.h5"), Optional.of("volume"));
    List<String> rows = Files.readAllLines(folder.resolve("berea_128_blocks.csv"));
    int blocks = 0;
    for (String row : rows.subList(1, rows.size())) {
      String[] cells = row.split(",");
      int z0 = Integer.parseInt(cells[1]);
      int y0 = Integer.parseInt(cells[2]);
      int x0 = Integer.parseInt(cells[3]);
      VoxelBox box = new VoxelBox(x0, y0, z0, 128, 128, 128);
      PoreSpace space = poreSpace(Hdf5Images.read(volume, box));
      Percolation z = Percolation.along(space, Axis.Z, Ends.OPEN, Ends.OPEN);
      assertEquals(Double.parseDouble(cells[4]), space.porosity(), 5e-7, "block " + cells[0]);
      assertEquals(Double.parseDouble(cells[5]), z.connectedPorosity(), 5e-7, "block " + cells[0]);
      blocks++;
    }
    assertEquals(27, blocks);
  }
}
