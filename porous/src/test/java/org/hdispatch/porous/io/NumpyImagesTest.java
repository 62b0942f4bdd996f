package org.hdispatch.porous.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class NumpyImagesTest {
  @TempDir Path folder;

  /** A file as numpy.save writes it: the header padded to a multiple of 64 bytes. */
  private Path write(int version, String header, byte[] voxels) throws IOException {
    int lengthBytes = version == 1 ? 2 : 4;
    int before = 8 + lengthBytes;
    int padded = (before + header.length() + 1 + 63) / 64 * 64 - before;
    ByteBuffer file =
        ByteBuffer.allocate(before + padded + voxels.length).order(ByteOrder.LITTLE_ENDIAN);
    file.put((byte) 0x93).put("NUMPY".getBytes(StandardCharsets.US_ASCII));
    file.put((byte) version).put((byte) 0);
    if (version == 1) {
      file.putShort((short) padded);
    } else {
      file.putInt(padded);
    }
    file.put((header + " ".repeat(padded - 1 - header.length()) + "\n").getBytes());
    return Files.write(folder.resolve("image.npy"), file.put(voxels).array());
  }

  private static String header(String type, boolean fortran, String shape) {
    return "{'descr': '%s', 'fortran_order': %s, 'shape': %s, }"
        .formatted(type, fortran ? "True" : "False", shape);
  }

  /** The labels of the small image, z fastest. */
  private static byte[] fortran() {
    byte[] labels = new byte[24];
    int i = 0;
    for (int x = 0; x < 2; x++) {
      for (int y = 0; y < 3; y++) {
        for (int z = 0; z < 4; z++) {
          labels[i++] = (byte) SmallImage.label(x, y, z);
        }
      }
    }
    return labels;
  }

  private String refusal(Path file) {
    return SmallImage.refusal(() -> NumpyImages.open(file), file);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void everyBoxOfEveryVersionIsRead(int version) throws IOException {
    Path file = write(version, header("|u1", false, "(4, 3, 2)"), SmallImage.flat());
    ImageFile image = NumpyImages.open(file);
    SmallImage.assertEveryBox(image);
    assertTrue(image.voxelEdge().isEmpty());
    assertEquals(
        "[NumPy, " + Files.size(file) + ", uint8, (4, 3, 2), C, 24]",
        image.facts().values().toString());
  }

  @ParameterizedTest
  @CsvSource({
    "|u1, 1", "<u1, 1", "<u2, 2", ">u2, 2", "<i2, 2", ">i2, 2", "<u4, 4", ">u4, 4", "<i4, 4",
    ">i4, 4", "<u8, 8", ">u8, 8", "<i8, 8", ">i8, 8"
  })
  void everyIntegerIsRead(String type, int bytes) throws IOException {
    ByteOrder order = type.startsWith(">") ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    byte[] voxels = SmallImage.wide(bytes, order);
    SmallImage.assertEveryBox(NumpyImages.open(write(1, header(type, false, "(4, 3, 2)"), voxels)));
  }

  @Test
  void fortranOrderIsTurnedRound() throws IOException {
    ImageFile image = NumpyImages.open(write(1, header("|u1", true, "(4,3,2)"), fortran()));
    SmallImage.assertEveryBox(image);
    assertEquals("Fortran", image.facts().get("order"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"|b1", "|i1"})
  void booleansAndSignedBytesAreRead(String type) throws IOException {
    byte[] voxels = {0, 1, 1, 0};
    ImageFile image = NumpyImages.open(write(1, header(type, false, "(1, 2, 2)"), voxels));
    assertEquals(Arrays.toString(voxels), Arrays.toString(image.read(image.whole()).toLabels()));
  }

  @Test
  void labelsThatDoNotFitAreRefusedWithTheirValue() throws IOException {
    byte[] high = {1, 1, 0, 0};
    assertTrue(
        refusal(write(1, header("<u2", false, "(1, 1, 2)"), high))
            .startsWith("labels must be within 0..255 (map them to uint8): file="));
    assertTrue(
        refusal(write(1, header("<u2", false, "(1, 1, 2)"), high))
            .endsWith(", type=uint16, label=257"));
    byte[] negative = {1, -1};
    assertTrue(refusal(write(1, header("|i1", false, "(1, 1, 2)"), negative)).endsWith("label=-1"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"<f4", "<f8", "|S1", "<c8", "|u2", "<b2", "=u2"})
  void otherTypesAreRefused(String type) throws IOException {
    Path file = write(1, header(type, false, "(4, 3, 2)"), SmallImage.flat());
    assertEquals(
        "labels must be booleans or integers of 0..255 (convert them: a.astype('uint8')): file="
            + file
            + ", descr='"
            + type
            + "'",
        refusal(file));
  }

  @ParameterizedTest
  @ValueSource(strings = {"()", "(24,)", "(4, 6)", "(1, 4, 3, 2)"})
  void otherDimensionsAreRefused(String shape) throws IOException {
    assertTrue(
        refusal(write(1, header("|u1", false, shape), SmallImage.flat()))
            .startsWith("array must have 3 dimensions (z, y, x): file="));
  }

  @ParameterizedTest
  @ValueSource(strings = {"(4, 0, 2)", "(4, 3, 2147483648)", "(4, 99999999999, 2)"})
  void impossibleDimensionsAreRefused(String shape) throws IOException {
    assertTrue(
        refusal(write(1, header("|u1", false, shape), SmallImage.flat()))
            .startsWith("dimensions must be 1 to 2147483647: file="));
  }

  @Test
  void anotherLengthIsRefused() throws IOException {
    Path tooShort = write(1, header("<u2", false, "(4, 3, 2)"), new byte[47]);
    assertEquals(
        "file length must be 128 + 2*nx*ny*nz (uint16 behind a header): file="
            + tooShort
            + ", length=175 bytes, dims=2,3,4 (24 voxels)",
        refusal(tooShort));
    assertTrue(
        refusal(write(1, header("|u1", false, "(4, 3, 2)"), new byte[25]))
            .startsWith("file length must be 128 + nx*ny*nz"));
  }

  @Test
  void whatIsNoArrayIsRefused() throws IOException {
    Path file = folder.resolve("text.npy");
    Files.writeString(file, "no array");
    assertTrue(refusal(file).startsWith("file must be in NumPy's format (.npy)"));
    assertTrue(
        refusal(write(4, header("|u1", false, "(4, 3, 2)"), SmallImage.flat()))
            .startsWith("format version must be 1 to 3"));
    assertTrue(refusal(write(1, "{'descr': '|u1'}", new byte[1])).startsWith("header must have"));
    byte[] whole = Files.readAllBytes(write(1, header("|u1", false, "(4,3,2)"), new byte[24]));
    Files.write(file, Arrays.copyOf(whole, 40));
    assertTrue(refusal(file).endsWith("cause=EOFException (in the header)"));
    Files.write(file, Arrays.copyOf(whole, 7));
    assertTrue(refusal(file).startsWith("file must be in NumPy's format"));
  }
}
