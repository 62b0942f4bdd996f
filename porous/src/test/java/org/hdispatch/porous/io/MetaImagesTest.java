package org.hdispatch.porous.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MetaImagesTest {
  private static final String HEAD =
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
          + "CompressedData = False\nElementNumberOfChannels = 1\nDimSize = 2 3 4\n"
          + "ElementType = MET_UCHAR\n";
  private static final String LOCAL = "ElementDataFile = LOCAL\n";

  @TempDir Path folder;

  private Path write(String name, String header, byte[] voxels) throws IOException {
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    file.write(header.getBytes("UTF-8"));
    file.write(voxels);
    return Files.write(folder.resolve(name), file.toByteArray());
  }

  private static byte[] packed(byte[] voxels, boolean gzip) throws IOException {
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    try (OutputStream out =
        gzip ? new GZIPOutputStream(packed) : new DeflaterOutputStream(packed)) {
      out.write(voxels);
    }
    return packed.toByteArray();
  }

  private static String refusal(Path file) {
    return SmallImage.refusal(() -> MetaImages.open(file), file);
  }

  private OptionalDouble edge(String fields) throws IOException {
    return MetaImages.open(write("edge.mha", HEAD + fields + LOCAL, SmallImage.flat())).voxelEdge();
  }

  @Test
  void everyBoxIsRead() throws IOException {
    ImageFile image = MetaImages.open(write("a.mha", HEAD + LOCAL, SmallImage.flat()));
    SmallImage.assertEveryBox(image);
    assertEquals("MetaImage", image.facts().get("format"));
    assertEquals(false, image.facts().get("compressed"));
  }

  @Test
  void detachedDataIsRead() throws IOException {
    write("a.raw", "", SmallImage.flat());
    ImageFile image =
        MetaImages.open(write("a.mhd", HEAD + "ElementDataFile = a.raw", new byte[0]));
    SmallImage.assertEveryBox(image);
    assertEquals(folder.resolve("a.raw").toString(), image.facts().get("data_file"));
    write("b.raw", "twelve bytes", SmallImage.flat());
    for (String size : new String[] {"12", "-1"}) {
      String header = HEAD + "HeaderSize = " + size + "\nElementDataFile = b.raw\n";
      SmallImage.assertEveryBox(MetaImages.open(write("b.mhd", header, new byte[0])));
    }
  }

  @Test
  void compressedDataIsRead() throws IOException {
    String compressed = HEAD.replace("CompressedData = False", "CompressedData = True");
    for (boolean gzip : new boolean[] {false, true}) {
      byte[] voxels = packed(SmallImage.flat(), gzip);
      SmallImage.assertEveryBox(MetaImages.open(write("a.mha", compressed + LOCAL, voxels)));
      write("a.zraw", "", voxels);
      String detached = compressed + "ElementDataFile = a.zraw\n";
      SmallImage.assertEveryBox(MetaImages.open(write("a.mhd", detached, new byte[0])));
      String wide = compressed.replace("UCHAR", "SHORT") + LOCAL;
      byte[] shorts = packed(SmallImage.wide(2, ByteOrder.LITTLE_ENDIAN), gzip);
      SmallImage.assertEveryBox(MetaImages.open(write("b.mha", wide, shorts)));
    }
  }

  @ParameterizedTest
  @CsvSource({
    "SHORT, 2",
    "USHORT, 2",
    "INT, 4",
    "UINT, 4",
    "LONG, 4",
    "ULONG, 4",
    "LONG_LONG, 8",
    "ULONG_LONG, 8"
  })
  void everyIntegerIsRead(String type, int bytes) throws IOException {
    String little = HEAD.replace("UCHAR", type) + LOCAL;
    SmallImage.assertEveryBox(
        MetaImages.open(write("a.mha", little, SmallImage.wide(bytes, ByteOrder.LITTLE_ENDIAN))));
    for (String field : new String[] {"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}) {
      String big = little.replace("BinaryDataByteOrderMSB = False", field + " = True");
      SmallImage.assertEveryBox(
          MetaImages.open(write("b.mha", big, SmallImage.wide(bytes, ByteOrder.BIG_ENDIAN))));
    }
    String unsaid = little.replace("BinaryDataByteOrderMSB = False\n", "");
    SmallImage.assertEveryBox(
        MetaImages.open(write("c.mha", unsaid, SmallImage.wide(bytes, ByteOrder.LITTLE_ENDIAN))));
  }

  @Test
  void voxelEdgeIsInMillimetresUnlessStated() throws IOException {
    assertEquals(OptionalDouble.empty(), edge(""));
    assertEquals(OptionalDouble.empty(), edge("ElementSpacing = 1 1 1\n")); // nobody knew
    assertEquals(5e-6, edge("ElementSpacing = 0.005 0.005 0.005\n").orElseThrow(), 0);
    assertEquals(5e-6, edge("ElementSize = 0.005 0.005 0.005\n").orElseThrow(), 0);
    assertEquals(
        4e-6, edge("ElementSize = 5 5 5\nElementSpacing = .004 .004 .004\n").orElseThrow(), 0);
    assertEquals(1e-6, edge("ElementSpacing = 1 1 1\nDistanceUnits = um\n").orElseThrow(), 0);
    assertEquals(OptionalDouble.empty(), edge("ElementSpacing = 5 5 5\nDistanceUnits = ?\n"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "NDims = 3 | NDims = 2 | image must have 3 dimensions (x y z): ",
        "DimSize = 2 3 4 | DimSize = 2 12 | image must have 3 dimensions (x y z): ",
        "DimSize = 2 3 4 | DimSize = 2 3 3 | file length must be",
        "DimSize = 2 3 4 | Size = 2 3 4 | header must have the field 'DimSize': ",
        "MET_UCHAR | MET_FLOAT | labels must be integers of 0..255 (convert them to uint8): ",
        "MET_UCHAR | MET_SHORT | file length must be",
        "Channels = 1 | Channels = 3 | voxels must have one channel: ",
        "BinaryData = True | BinaryData = False | voxels must be binary",
        "BinaryData = True | BinaryData = yes | field must be True or False: ",
        "CompressedData = False | CompressedData = True | file must be sound zlib",
        "ObjectType = Image | HeaderSize = -2 | header size must be",
        "ObjectType = Image | ElementSpacing = 1 1 2 | voxels must be cubes",
        "ObjectType = Image | ElementSpacing = 1 1 | field must be 3 numbers",
        "ObjectType = Image | NDims = 3 | header must state each field once: ",
        "ObjectType = Image | Image | header line must be 'Field = value': ",
        "= LOCAL | = LIST | voxels must be LOCAL or in one data file",
        "= LOCAL | = x%03d.raw 1 9 1 | voxels must be LOCAL or in one data file",
        "ElementDataFile | DataFile | file must be a MetaImage header that ends with Element",
      })
  void wrongHeadersAreRefused(String right, String wrong, String line) throws IOException {
    Path file = write("a.mha", (HEAD + LOCAL).replace(right, wrong), SmallImage.flat());
    assertTrue(refusal(file).startsWith(line), refusal(file));
  }

  @Test
  void streamThatIsCutShortIsRefused() throws IOException {
    byte[] whole = packed(SmallImage.flat(), false);
    String header = HEAD.replace("CompressedData = False", "CompressedData = True") + LOCAL;
    Path cut = write("a.mha", header, Arrays.copyOf(whole, whole.length - 6));
    assertTrue(refusal(cut).startsWith("zlib stream must be complete"), refusal(cut));
    Path fewer = write("b.mha", header, packed(new byte[23], false));
    assertTrue(refusal(fewer).startsWith("inflated length must be nx*ny*nz"), refusal(fewer));
    Path end = write("c.mhd", header.replace("LOCAL", "none.zraw"), new byte[0]);
    assertTrue(
        SmallImage.refusal(() -> MetaImages.open(end), folder.resolve("none.zraw"))
            .startsWith("file must exist"));
    String minusOne = header.replace("NDims", "HeaderSize = -1\nNDims");
    assertTrue(refusal(write("d.mha", minusOne, whole)).startsWith("header size must be"));
  }
}
