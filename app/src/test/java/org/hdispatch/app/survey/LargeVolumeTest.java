package org.hdispatch.app.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.hdispatch.app.Cli;
import org.hdispatch.app.Forked;
import org.hdispatch.app.RawFile;
import org.hdispatch.app.rock.SampleRock;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.io.Hdf5Images;
import org.hdispatch.porous.io.ImageFile;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A volume of 6.6 x 10^9 voxels is surveyed in the memory of one block. */
class LargeVolumeTest {
  @TempDir Path folder;

  private Path volume() throws Exception {
    Path file = folder.resolve("core.h5");
    LargeVolume.write(file);
    assertTrue(Files.size(file) < 12 << 20, "bytes: " + Files.size(file));
    return file;
  }

  @Test
  void everyVoxelReadsAsItWasWritten() throws Exception {
    ImageFile file = Hdf5Images.open(volume(), Optional.empty());
    assertEquals(VoxelBox.whole(1840, 1840, 1940), file.whole());
    assertEquals(OptionalDouble.of(2.8e-6), file.voxelEdge());
    SampleRock rock = new SampleRock();
    VoxelImage sample = rock.read(rock.whole());
    Random random = new Random(1840);
    for (int n = 0; n < 24; n++) { // around the corners of all blocks of rock, and anywhere
      VoxelBox near = LargeVolume.box(LargeVolume.ROCKS.get(n % LargeVolume.ROCKS.size()));
      boolean anywhere = n >= 16;
      int x0 = start(random, anywhere, near.x0(), LargeVolume.NX);
      int y0 = start(random, anywhere, near.y0(), LargeVolume.NY);
      int z0 = start(random, anywhere, near.z0(), LargeVolume.NZ);
      VoxelBox box = new VoxelBox(x0, y0, z0, 24, 24, 24);
      VoxelImage read = file.read(box);
      for (int voxel = 0; voxel < read.voxels(); voxel++) {
        int x = x0 + voxel % 24;
        int y = y0 + voxel / 24 % 24;
        int z = z0 + voxel / (24 * 24);
        assertEquals(LargeVolume.label(sample, x, y, z), read.label(voxel), () -> "box " + box);
      }
    }
  }

  private static int start(Random random, boolean anywhere, int near, int length) {
    int at = anywhere ? random.nextInt(length) : near + (random.nextBoolean() ? 0 : 200) - 12;
    return Math.max(0, Math.min(at, length - 24));
  }

  private List<Map<String, String>> survey(String heap, String to, String... options)
      throws Exception {
    String[] all = new String[options.length + 5];
    System.arraycopy(options, 0, all, 5, options.length);
    all[0] = volume().toString();
    all[1] = "--outside-value=2";
    all[2] = "--threads=1";
    all[3] = "--quiet";
    all[4] = "--output=" + folder.resolve(to);
    assertEquals(0, Forked.ended(Forked.survey(List.of(heap), all)));
    return SurveyCommandTest.rows(folder.resolve(to).resolve("survey.csv"));
  }

  private static List<String> column(List<Map<String, String>> rows, String key) {
    return rows.stream().map(row -> row.get(key)).toList();
  }

  /** Blocks of 40³ of rock, at the edge of it and where nothing was written, in 96 MiB. */
  @Test
  void blocksAreSurveyedInAHeapThatHoldsOne() throws Exception {
    List<Map<String, String>> rows =
        survey(
            "-Xmx96m",
            "small",
            "--block=40",
            "--origin=1660,1640,1660",
            "--origin=800,800,800",
            "--origin=780,800,800",
            "--origin=300,1100,1900");
    assertEquals(List.of("done", "done", "outside", "outside"), column(rows, "status"));
    assertEquals(List.of("0.0", "0.0", "0.5", "1.0"), column(rows, "outside_fraction"));
    assertEquals(alone(800), rows.get(1).get("permeability_mD"));
  }

  /** The permeability of the block at a place along all axes, from a file of its own. */
  private String alone(int first) throws Exception {
    SampleRock rock = new SampleRock();
    VoxelImage sample = rock.read(rock.whole());
    RawFile.write(
        folder,
        40,
        40,
        40,
        (x, y, z) -> LargeVolume.label(sample, first + x, first + y, first + z) == 1);
    Cli run =
        Cli.run(
            "permeability",
            folder.resolve("image.raw"),
            "--dims=40,40,40",
            "--voxel-edge=2.8e-6",
            "--csv",
            "--quiet");
    Path table = Files.writeString(folder.resolve("alone.csv"), run.out());
    return SurveyCommandTest.rows(table).get(0).get("permeability_mD");
  }

  /** A whole block of 200³ and an empty one, in the heap that the first one needs. */
  @Test
  @Tag("validation")
  void blocksOf200AreSurveyedInAHeapThatHoldsOne() throws Exception {
    List<Map<String, String>> rows =
        survey("-Xmx1280m", "large", "--block=200", "--blocks=0,41", "--tolerance=0.01");
    assertEquals(List.of("done", "outside"), column(rows, "status"));
    assertEquals(Double.toString(1499581 / 8e6), rows.get(0).get("porosity"));
  }
}
