package org.hdispatch.porous.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HexFormat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ImageFormatTest {
  private static final long SIGNATURE = 0x894844460d0a1a0aL;

  @TempDir Path folder;

  private Path signatureAt(int place) throws IOException {
    byte[] bytes = new byte[place + 20];
    ByteBuffer.wrap(bytes).putLong(place, SIGNATURE);
    return Files.write(folder.resolve("image.dat"), bytes);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 512, 1024, 4096})
  void signatureIsFoundBehindAnyUserBlock(int place) throws IOException {
    assertEquals(ImageFormat.HDF5, ImageFormat.of(signatureAt(place)));
  }

  @Test
  void signatureElsewhereIsNone() throws IOException {
    assertEquals(ImageFormat.RAW, ImageFormat.of(signatureAt(100)));
    assertEquals(
        ImageFormat.RAW, ImageFormat.of(Files.write(folder.resolve("a.raw"), new byte[3])));
  }

  @ParameterizedTest
  @CsvSource({
    "a.tif, TIFF", "a.TIFF, TIFF", "a.npy, NUMPY", "a.nrrd, NRRD", "a.nhdr, NRRD",
    "a.mhd, META_IMAGE", "a.mha, META_IMAGE", "a.raw, RAW", "a.npy.gz, RAW", "tif, RAW"
  })
  void nameTellsTheFormat(String name, ImageFormat format) throws IOException {
    assertEquals(format, ImageFormat.of(Files.write(folder.resolve(name), new byte[3])));
  }

  @ParameterizedTest
  @CsvSource({
    "49492a0008000000, TIFF",
    "4d4d002a00000008, TIFF",
    "49492b0008000000, TIFF",
    "934e554d50590100, NUMPY",
    "4e52524430303034, NRRD",
    "4949004200000000, RAW",
    "4949, RAW"
  })
  void signatureTellsTheFormat(String hex, ImageFormat format) throws IOException {
    byte[] start = HexFormat.of().parseHex(hex);
    assertEquals(format, ImageFormat.of(Files.write(folder.resolve("image.dat"), start)));
  }

  @Test
  void folderIsOneOfSlices() throws IOException {
    assertEquals(ImageFormat.TIFF, ImageFormat.of(folder));
  }

  @Test
  void nameTellsToo() throws IOException {
    assertEquals(
        ImageFormat.HDF5, ImageFormat.of(Files.write(folder.resolve("a.H5"), new byte[3])));
  }

  @Test
  void missingAndEmptyFilesAreRefused() throws IOException {
    assertThrows(ImageFileException.class, () -> ImageFormat.of(folder.resolve("missing")));
    Path empty = Files.write(folder.resolve("empty"), new byte[0]);
    assertThrows(ImageFileException.class, () -> ImageFormat.of(empty));
  }
}
