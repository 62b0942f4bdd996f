package org.hdispatch.porous.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * HDF5 files as users have them, one per storage feature, written with h5py 3.16.0: each is read
 * right or refused with one line that names the remedy.
 */
class Hdf5CompatibilityTest {
  private static final String REPACK = "h5repack -f GZIP=6 in.h5 out.h5";

  /** What each refused file's line must contain: the remedy, and what it is about. */
  private static final Map<String, String[]> REFUSED =
      Map.of(
          "ok_float32.h5", new String[] {"convert them, e.g. to uint8", "type=float32"},
          "refused_bitshuffle_zstd.h5", new String[] {REPACK, "id=32008"},
          "refused_blosc.h5", new String[] {REPACK, "blosc"},
          "refused_external_raw.h5", new String[] {REPACK, "external raw file"},
          "refused_layout5_hdf5_2_0.h5", new String[] {"libver=('earliest', 'v114')", "HDF5 2.0"},
          "refused_scaleoffset.h5", new String[] {REPACK, "scaleoffset"},
          "refused_szip.h5", new String[] {REPACK, "szip"},
          "refused_virtual.h5", new String[] {"create_dataset(name, data=old[:])", "virtual"},
          "refused_zstd.h5", new String[] {REPACK, "zstd"},
          "silently_wrong_bitshuffle_lz4.h5", new String[] {REPACK, "id=32008"});

  private static Path file(String name) throws URISyntaxException {
    return Path.of(Hdf5CompatibilityTest.class.getResource("/hdf5-compat/" + name).toURI());
  }

  private static Stream<String> refused() {
    return REFUSED.keySet().stream().sorted();
  }

  /** 48 x 40 x 40 in file order (z, y, x); 1 = pore. */
  private static VoxelImage expected() throws IOException, URISyntaxException {
    return RawImages.read(file("expected_48x40x40.raw"), 40, 40, 48);
  }

  private static Hdf5Dataset select(String name) throws IOException, URISyntaxException {
    return Hdf5Images.select(file(name), Optional.empty());
  }

  private static void assertSame(VoxelImage expected, VoxelImage image, int poreLabel) {
    byte[] labels = expected.toLabels();
    for (int i = 0; i < labels.length; i++) {
      labels[i] = (byte) (labels[i] * poreLabel);
    }
    assertTrue(Arrays.equals(labels, image.toLabels()));
    assertEquals(5.345e-6, image.voxelEdge().getAsDouble());
  }

  @Test
  void everyFileIsEitherReadOrRefusedHere() throws IOException, URISyntaxException {
    TreeSet<String> here = new TreeSet<>(REFUSED.keySet());
    for (String name : readable()) {
      here.add(name);
    }
    TreeSet<String> there = new TreeSet<>();
    try (Stream<Path> files = Files.list(file("expected_48x40x40.raw").getParent())) {
      files
          .map(path -> path.getFileName().toString())
          .filter(name -> name.endsWith(".h5"))
          .forEach(there::add);
    }
    assertEquals(there, here);
  }

  private static String[] readable() {
    return new String[] {
      "ok_bool_enum.h5",
      "ok_compact_no_slice.h5",
      "ok_contiguous.h5",
      "ok_external_link.h5",
      "ok_gzip.h5",
      "ok_gzip_shuffle_fletcher.h5",
      "ok_int8.h5",
      "ok_lz4.h5",
      "ok_lzf.h5",
      "ok_resizable_v110.h5",
      "ok_uint16_be_0_255.h5",
      "ok_v114_gzip.h5"
    };
  }

  @ParameterizedTest
  @MethodSource("readable")
  void readsWhatWasWritten(String name) throws IOException, URISyntaxException {
    Hdf5Dataset dataset = select(name);
    VoxelImage image = Hdf5Images.read(dataset);
    VoxelImage expected = expected().crop(dataset.whole()); // the compact one is a corner of 16^3
    assertSame(expected, image, name.contains("0_255") ? 255 : 1);
  }

  @ParameterizedTest
  @MethodSource("readable")
  void hyperslabsEqualTheCropOfTheWhole(String name) throws IOException, URISyntaxException {
    Hdf5Dataset dataset = select(name);
    VoxelBox whole = dataset.whole();
    VoxelBox[] boxes = {
      new VoxelBox(3, 5, 7, 11, 9, 8), // across chunk borders
      new VoxelBox(0, 0, 2, whole.nx(), whole.ny(), 3), // whole planes
      new VoxelBox(whole.nx() - 1, whole.ny() - 1, whole.nz() - 1, 1, 1, 1) // the last voxel
    };
    for (VoxelBox box : boxes) {
      assertSame(
          expected().crop(box), Hdf5Images.read(dataset, box), name.contains("0_255") ? 255 : 1);
    }
  }

  @ParameterizedTest
  @MethodSource("refused")
  void refusesInOneLineThatNamesTheRemedy(String name) {
    ImageFileException e =
        assertThrows(ImageFileException.class, () -> Hdf5Images.read(select(name)));
    assertEquals(1, e.getMessage().lines().count());
    assertTrue(e.getMessage().contains(name), e.getMessage());
    for (String part : REFUSED.get(name)) {
      assertTrue(e.getMessage().contains(part), e.getMessage());
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"silently_wrong_bitshuffle_lz4.h5", "refused_bitshuffle_zstd.h5"})
  void refusesAMisreadFilterForSmallBoxesToo(String name) throws IOException, URISyntaxException {
    Hdf5Dataset dataset = select(name);
    VoxelBox corner = new VoxelBox(0, 0, 0, 1, 1, 1);
    assertThrows(ImageFileException.class, () -> Hdf5Images.read(dataset, corner));
  }

  /** See hdf5-unwritten/README.md: one chunk of 24 voxels is 1, the rest was never written. */
  @ParameterizedTest
  @ValueSource(strings = {"unwritten_earliest.h5", "unwritten_v110.h5"})
  void partsThatWereNeverWrittenReadAsTheFillValue(String name)
      throws IOException, URISyntaxException {
    Path file = file("../hdf5-unwritten/" + name);
    Map<String, Integer> fill =
        Map.of("/chunked", 7, "/chunked16", 7, "/contiguous", 7, "/default", 0);
    for (Hdf5Dataset dataset : Hdf5Images.describe(file)) {
      VoxelImage image = Hdf5Images.read(dataset);
      for (int i = 0; i < image.voxels(); i++) {
        int x = i % 8;
        int y = i / 8 % 6;
        int z = i / 48;
        boolean written = !dataset.path().equals("/contiguous") && z < 2 && y < 3 && x >= 4;
        assertEquals(written ? 1 : fill.get(dataset.path()), image.label(x, y, z));
      }
    }
    assertEquals(4, Hdf5Images.describe(file).size());
  }

  @Test
  void aBrokenExternalLinkSaysSo() throws IOException, URISyntaxException {
    Path alone = Files.createTempDirectory("link").resolve("link.h5");
    Files.copy(file("ok_external_link.h5"), alone);
    try {
      ImageFileException e =
          assertThrows(
              ImageFileException.class, () -> Hdf5Images.select(alone, Optional.of("/volume")));
      assertTrue(e.getMessage().startsWith("link must lead to a dataset"), e.getMessage());
    } finally {
      Files.delete(alone);
      Files.delete(alone.getParent());
    }
  }
}
