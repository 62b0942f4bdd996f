package org.hdispatch.porous.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
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

  @Test
  void nameTellsToo() throws IOException {
    assertEquals(
        ImageFormat.HDF5, ImageFormat.of(Files.write(folder.resolve("a.H5"), new byte[3])));
  }

  @Test
  void missingAndEmptyFilesAreRefused() throws IOException {
    assertThrows(ImageFileException.class, () -> ImageFormat.of(folder.resolve("missing")));
    assertThrows(ImageFileException.class, () -> ImageFormat.of(folder));
    Path empty = Files.write(folder.resolve("empty"), new byte[0]);
    assertThrows(ImageFileException.class, () -> ImageFormat.of(empty));
  }
}
