package org.hdispatch.porous.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.zip.GZIPOutputStream;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RawImagesTest {
  @TempDir Path folder;

  private Path write(String name, byte[] bytes) throws IOException {
    Path file = folder.resolve(name);
    try (OutputStream raw = Files.newOutputStream(file);
        OutputStream out = name.endsWith(".gz") ? new GZIPOutputStream(raw) : raw) {
      out.write(bytes);
    }
    return file;
  }

  private static String refusal(Path file, int nx, int ny, int nz) {
    ImageFileException e =
        assertThrows(ImageFileException.class, () -> RawImages.read(file, nx, ny, nz));
    assertEquals(1, e.getMessage().lines().count());
    return e.getMessage();
  }

  @ParameterizedTest
  @ValueSource(strings = {"small.raw", "small.raw.gz"})
  void everyVoxelStandsInItsPlace(String name) throws IOException {
    VoxelImage image = RawImages.read(write(name, SmallImage.flat()), 2, 3, 4);
    assertEquals(2, image.nx());
    assertEquals(3, image.ny());
    assertEquals(4, image.nz());
    SmallImage.assertPart(image, 0, 0, 0);
    assertTrue(image.voxelEdge().isEmpty());
  }

  @ParameterizedTest
  @ValueSource(strings = {"small.raw", "small.raw.gz"})
  void everyBoxEqualsTheCropOfTheWhole(String name) throws IOException {
    Path file = write(name, SmallImage.flat());
    SmallImage.assertEveryBox(RawImages.open(file, VoxelBox.whole(2, 3, 4)));
  }

  @Test
  void lengthIsCheckedWithoutReading() throws IOException {
    Path file = write("small.raw", SmallImage.flat());
    RawImages.open(file, VoxelBox.whole(2, 3, 4));
    ImageFileException e =
        assertThrows(ImageFileException.class, () -> RawImages.open(file, VoxelBox.whole(2, 3, 5)));
    assertTrue(e.getMessage().startsWith("file length must be nx*ny*nz"), e.getMessage());
    // Not known yet:
    RawImages.open(write("small.raw.gz", SmallImage.flat()), VoxelBox.whole(2, 3, 5));
  }

  @Test
  void planesLargerThanTheBufferAreReadWhole() throws IOException {
    // 2000 x 1000 voxels a plane: two buffers of 1 MiB.
    byte[] labels = new byte[2000 * 1000 * 2];
    for (int i = 0; i < labels.length; i++) {
      labels[i] = (byte) (i % 251);
    }
    Path file = write("wide.raw", labels);
    VoxelImage whole = RawImages.read(file, 2000, 1000, 2);
    assertTrue(Arrays.equals(labels, whole.toLabels()));
    VoxelBox box = new VoxelBox(500, 3, 1, 1500, 900, 1);
    assertTrue(
        Arrays.equals(
            whole.crop(box).toLabels(),
            RawImages.open(file, VoxelBox.whole(2000, 1000, 2)).read(box).toLabels()));
  }

  @Test
  void anotherLengthIsRefusedWithBothLengths() throws IOException {
    Path file = write("short.raw", new byte[23]);
    assertEquals(
        "file length must be nx*ny*nz (8 bit, no header): file="
            + file
            + ", length=23 bytes, dims=2,3,4 (24 voxels)",
        refusal(file, 2, 3, 4));
    assertTrue(refusal(write("long.raw", new byte[25]), 2, 3, 4).contains("length=25 bytes"));
  }

  @Test
  void anotherInflatedLengthIsRefusedEvenWhenTheBoxIsThere() throws IOException {
    Path tooShort = write("short.raw.gz", new byte[23]);
    assertTrue(refusal(tooShort, 2, 3, 4).contains("inflated length must be nx*ny*nz"));
    assertTrue(refusal(tooShort, 2, 3, 4).contains("length=23 bytes"));
    Path tooLong = write("long.raw.gz", new byte[25]);
    assertTrue(refusal(tooLong, 2, 3, 4).contains("length=more than 24 bytes"));
    VoxelBox corner = new VoxelBox(0, 0, 0, 1, 1, 1);
    assertThrows(
        ImageFileException.class,
        () -> RawImages.open(tooShort, VoxelBox.whole(2, 3, 4)).read(corner));
    assertThrows(
        ImageFileException.class,
        () -> RawImages.open(tooLong, VoxelBox.whole(2, 3, 4)).read(corner));
  }

  @Test
  void dimensionsBeyondAnyFileAreRefusedByTheLength() throws IOException {
    Path file = write("small.raw", SmallImage.flat());
    int most = Integer.MAX_VALUE;
    assertTrue(refusal(file, most, most, most).contains("length=24 bytes"));
  }

  @Test
  void gzipThatIsCutShortOrNoneIsRefused() throws IOException {
    Path whole = write("whole.raw.gz", SmallImage.flat());
    byte[] bytes = Files.readAllBytes(whole);
    Path cut = folder.resolve("cut.raw.gz");
    Files.write(cut, Arrays.copyOf(bytes, bytes.length - 12));
    assertTrue(refusal(cut, 2, 3, 4).contains("cut short"));
    Path plain = folder.resolve("plain.raw.gz");
    Files.write(plain, SmallImage.flat());
    assertTrue(refusal(plain, 2, 3, 4).contains("file must be sound gzip"));
  }

  @Test
  void missingFilesDirectoriesAndEmptyFilesAreRefused() throws IOException {
    assertTrue(refusal(folder.resolve("none.raw"), 2, 3, 4).startsWith("file must exist: file="));
    assertTrue(refusal(folder, 2, 3, 4).startsWith("file must not be a directory: file="));
    assertTrue(
        refusal(write("empty.raw", new byte[0]), 2, 3, 4).startsWith("file must not be empt"));
  }

  @Test
  void boxOutsideIsABadArgument() throws IOException {
    Path file = write("small.raw", SmallImage.flat());
    VoxelBox box = new VoxelBox(0, 0, 0, 2, 3, 5);
    assertThrows(
        IllegalArgumentException.class,
        () -> RawImages.open(file, VoxelBox.whole(2, 3, 4)).read(box));
  }
}
