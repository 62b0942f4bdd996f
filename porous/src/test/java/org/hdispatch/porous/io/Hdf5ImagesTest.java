package org.hdispatch.porous.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.jhdf.HdfFile;
import io.jhdf.WritableHdfFile;
import io.jhdf.api.DatasetCreationOptions;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class Hdf5ImagesTest {
  @TempDir Path folder;

  /** How a dataset can be laid out by jHDF's writer. */
  enum Layout {
    CONTIGUOUS(DatasetCreationOptions.builder().unsigned()),
    ONE_CHUNK(DatasetCreationOptions.builder().unsigned().deflate(6)),
    /** Chunks that divide no axis evenly. */
    CHUNKED(DatasetCreationOptions.builder().unsigned().chunkDimensions(3, 2, 2).deflate(6)),
    SHUFFLED(DatasetCreationOptions.builder().unsigned().chunkDimensions(2, 2, 1).shuffle());

    private final DatasetCreationOptions options;

    Layout(DatasetCreationOptions.Builder builder) {
      this.options = builder.build();
    }
  }

  private Path write(String name, Consumer<WritableHdfFile> content) {
    Path file = folder.resolve(name);
    try (WritableHdfFile hdf = HdfFile.write(file)) {
      content.accept(hdf);
    }
    return file;
  }

  private static VoxelImage read(Path file) throws ImageFileException {
    return Hdf5Images.read(Hdf5Images.select(file, Optional.empty()));
  }

  private static String refusal(Path file, String dataset) {
    ImageFileException e =
        assertThrows(
            ImageFileException.class,
            () -> Hdf5Images.read(Hdf5Images.select(file, Optional.ofNullable(dataset))));
    assertEquals(1, e.getMessage().lines().count());
    assertTrue(e.getMessage().contains("file=" + file), e.getMessage());
    return e.getMessage();
  }

  @ParameterizedTest
  @EnumSource
  void everyVoxelStandsInItsPlace(Layout layout) throws IOException {
    Path file =
        write("small.h5", hdf -> hdf.putDataset("rock", SmallImage.nested(), layout.options));
    VoxelImage image = read(file);
    assertEquals(2, image.nx());
    assertEquals(3, image.ny());
    assertEquals(4, image.nz());
    SmallImage.assertPart(image, 0, 0, 0);
  }

  @ParameterizedTest
  @EnumSource
  void everyHyperslabEqualsTheCropOfTheWhole(Layout layout) throws IOException {
    Path file =
        write("small.h5", hdf -> hdf.putDataset("rock", SmallImage.nested(), layout.options));
    Hdf5Dataset rock = Hdf5Images.select(file, Optional.of("rock"));
    for (int x0 = 0; x0 < 2; x0++) {
      for (int y0 = 0; y0 < 3; y0++) {
        for (int z0 = 0; z0 < 4; z0++) {
          for (int nx = 1; x0 + nx <= 2; nx++) {
            for (int ny = 1; y0 + ny <= 3; ny++) {
              for (int nz = 1; z0 + nz <= 4; nz++) {
                VoxelBox box = new VoxelBox(x0, y0, z0, nx, ny, nz);
                SmallImage.assertPart(Hdf5Images.read(rock, box), x0, y0, z0);
              }
            }
          }
        }
      }
    }
  }

  @Test
  void integersOfAnyWidthAreReadWhenTheyFitIntoAByte() throws IOException {
    short[][][] shorts = new short[4][3][2];
    int[][][] ints = new int[4][3][2];
    long[][][] longs = new long[4][3][2];
    for (int z = 0; z < 4; z++) {
      for (int y = 0; y < 3; y++) {
        for (int x = 0; x < 2; x++) {
          shorts[z][y][x] = (short) SmallImage.label(x, y, z);
          ints[z][y][x] = SmallImage.label(x, y, z);
          longs[z][y][x] = SmallImage.label(x, y, z);
        }
      }
    }
    DatasetCreationOptions shuffled =
        DatasetCreationOptions.builder().chunkDimensions(3, 2, 2).shuffle().deflate(6).build();
    for (Object labels : List.of(shorts, ints, longs)) {
      SmallImage.assertPart(read(write("a.h5", hdf -> hdf.putDataset("a", labels))), 0, 0, 0);
      Files.delete(folder.resolve("a.h5"));
      SmallImage.assertPart(
          read(write("a.h5", hdf -> hdf.putDataset("a", labels, shuffled))), 0, 0, 0);
      Files.delete(folder.resolve("a.h5"));
    }
  }

  @Test
  void labelsOutsideAByteAreRefusedInTheBoxOnly() throws IOException {
    int[][][] labels = new int[4][3][2];
    labels[3][0][0] = 256;
    labels[3][0][1] = -1;
    Path file = write("wide.h5", hdf -> hdf.putDataset("a", labels));
    String refusal = refusal(file, null);
    assertTrue(refusal.startsWith("labels must be within 0..255 (map them to uint8)"), refusal);
    assertTrue(refusal.endsWith("type=int32, label=256"), refusal);
    Hdf5Dataset a = Hdf5Images.select(file, Optional.empty());
    assertEquals(18, Hdf5Images.read(a, new VoxelBox(0, 0, 0, 2, 3, 3)).histogram()[0]);
    ImageFileException e =
        assertThrows(
            ImageFileException.class, () -> Hdf5Images.read(a, new VoxelBox(1, 0, 3, 1, 1, 1)));
    assertTrue(e.getMessage().endsWith("label=-1"), e.getMessage());
  }

  @Test
  void signedBytesBelowZeroAreRefused() {
    Path file = write("int8.h5", hdf -> hdf.putDataset("a", new byte[][][] {{{1, -1}}}));
    assertTrue(refusal(file, null).endsWith("type=int8, label=-1"));
  }

  @Test
  void voxelEdgeIsTakenFromTheDatasetElseFromTheFile() throws IOException {
    Path file =
        write(
            "edges.h5",
            hdf -> {
              hdf.putAttribute("voxel_size_m", 2.8e-6);
              hdf.putDataset("a", new byte[1][1][1]).putAttribute("voxel_size_m", 5.345e-6);
              hdf.putDataset("b", new byte[1][1][1]);
              hdf.putDataset("c", new byte[1][1][1])
                  .putAttribute("voxel_size_m", new double[] {1e-6, 1e-6, 1e-6});
            });
    List<Hdf5Dataset> all = Hdf5Images.describe(file);
    assertEquals(List.of("/a", "/b", "/c"), all.stream().map(Hdf5Dataset::path).toList());
    assertEquals(5.345e-6, all.get(0).voxelEdge().getAsDouble());
    assertEquals(2.8e-6, all.get(1).voxelEdge().getAsDouble());
    assertEquals(1e-6, all.get(2).voxelEdge().getAsDouble());
    assertEquals(5.345e-6, Hdf5Images.read(all.get(0)).voxelEdge().getAsDouble());
  }

  @Test
  void voxelEdgesThatAreNoLengthAreRefused() {
    for (Object edge : List.of(0.0, -1e-6, Double.NaN, new double[] {1e-6, 2e-6, 1e-6})) {
      Path file =
          write(
              "edge.h5",
              hdf -> hdf.putDataset("a", new byte[1][1][1]).putAttribute("voxel_size_m", edge));
      assertTrue(
          refusal(file, "a").startsWith("attribute voxel_size_m must be one positive number"));
      assertTrue(file.toFile().delete());
    }
  }

  @Test
  void anotherAxisOrderIsRefused() {
    Path file =
        write(
            "order.h5",
            hdf -> hdf.putDataset("a", new byte[1][1][1]).putAttribute("axis_order", "x,y,z"));
    assertTrue(refusal(file, null).contains("axis_order=x,y,z"));
  }

  @Test
  void theOnlyImageIsFoundAmongOtherDatasets() throws IOException {
    Path file =
        write(
            "mixed.h5",
            hdf -> {
              hdf.putDataset("flow", new float[4][3][2]);
              hdf.putDataset("table", new int[5][2]);
              hdf.putGroup("rock").putDataset("labels", SmallImage.nested());
            });
    assertEquals("/rock/labels", Hdf5Images.select(file, Optional.empty()).path());
    assertEquals("/rock/labels", Hdf5Images.select(file, Optional.of("rock/labels")).path());
  }

  @Test
  void severalImagesMustBeNamed() {
    Path file =
        write(
            "two.h5",
            hdf -> {
              hdf.putDataset("a", new byte[1][2][3]);
              hdf.putDataset("b", new byte[1][1][1]);
            });
    assertEquals(
        "dataset must be named, as the file holds several images: file="
            + file
            + ", datasets=[/a int8 [1, 2, 3], /b int8 [1, 1, 1]]",
        refusal(file, null));
  }

  @Test
  void missingDatasetsAreRefusedWithWhatIsThere() {
    Path file = write("one.h5", hdf -> hdf.putDataset("a", new byte[1][2][3]));
    String expected =
        "dataset must exist: file=" + file + ", dataset=/b, datasets=[/a int8 [1, 2, 3]]";
    assertEquals(expected, refusal(file, "/b"));
    assertTrue(refusal(file, "/").contains("datasets=[/a int8 [1, 2, 3]]"));
  }

  @Test
  void datasetsOfTwoDimensionsAreRefused() {
    Path file = write("flat.h5", hdf -> hdf.putDataset("image", new byte[200][200]));
    assertEquals(
        "dataset must have 3 dimensions (z, y, x): file="
            + file
            + ", dataset=/image, shape=[200, 200]",
        refusal(file, "/image"));
    assertEquals(refusal(file, "/image"), refusal(file, null));
  }

  @Test
  void floatLabelsAreRefused() {
    Path file = write("float.h5", hdf -> hdf.putDataset("a", new double[1][2][3]));
    assertEquals(
        "labels must be integers of 0..255 (convert them, e.g. to uint8): file="
            + file
            + ", dataset=/a, shape=[1, 2, 3], type=float64",
        refusal(file, null));
  }

  @Test
  void filesWithoutAnyImageAreRefused() {
    Path file =
        write(
            "none.h5",
            hdf -> {
              hdf.putDataset("a", new double[1][2][3]);
              hdf.putDataset("b", new int[7]);
            });
    assertTrue(
        refusal(file, null)
            .startsWith("file must hold a dataset of integers with 3 dimensions (z, y, x)"));
  }

  @Test
  void missingFilesDirectoriesEmptyFilesAndOtherFormatsAreRefused() throws IOException {
    assertTrue(refusal(folder.resolve("no.h5"), null).startsWith("file must exist"));
    assertTrue(refusal(folder, null).startsWith("file must not be a directory"));
    Path empty = Files.createFile(folder.resolve("empty.h5"));
    assertTrue(refusal(empty, null).startsWith("file must not be empty"));
    Path text = Files.writeString(folder.resolve("text.h5"), "no rock here\n".repeat(100));
    assertEquals("file must be HDF5: file=" + text, refusal(text, null));
  }

  @ParameterizedTest
  @EnumSource
  void filesCutShortAnywhereAreRefusedOrReadRight(Layout layout) throws IOException {
    Path file = write("all.h5", hdf -> hdf.putDataset("a", SmallImage.nested(), layout.options));
    byte[] bytes = Files.readAllBytes(file);
    Path cut = folder.resolve("cut.h5");
    int refused = 0;
    for (int length = 1; length < bytes.length; length += 7) {
      Files.write(cut, Arrays.copyOf(bytes, length));
      try {
        SmallImage.assertPart(read(cut), 0, 0, 0);
      } catch (ImageFileException e) {
        assertEquals(1, e.getMessage().lines().count());
        refused++;
      }
    }
    assertTrue(refused > 0);
  }

  @Test
  void boxOutsideIsABadArgument() throws IOException {
    Path file = write("small.h5", hdf -> hdf.putDataset("a", SmallImage.nested()));
    Hdf5Dataset a = Hdf5Images.select(file, Optional.empty());
    VoxelBox box = new VoxelBox(0, 0, 0, 4, 3, 2);
    assertThrows(IllegalArgumentException.class, () -> Hdf5Images.read(a, box));
    assertFalse(a.voxelEdge().isPresent());
  }
}
