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
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class NrrdImagesTest {
  private static final String RAW =
      "NRRD0004\n# a comment\ntype: uint8\ndimension: 3\nsizes: 2 3 4\nencoding: raw\nkey:=value\n";

  @TempDir Path folder;

  private Path write(String name, String header, byte[] voxels) throws IOException {
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    file.write(header.getBytes("UTF-8"));
    file.write(voxels);
    return Files.write(folder.resolve(name), file.toByteArray());
  }

  private static byte[] gzip(byte[] voxels) throws IOException {
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    try (OutputStream out = new GZIPOutputStream(packed)) {
      out.write(voxels);
    }
    return packed.toByteArray();
  }

  private static String refusal(Path file) {
    return SmallImage.refusal(() -> NrrdImages.open(file), file);
  }

  private OptionalDouble edge(String fields) throws IOException {
    Path file = write("edge.nrrd", RAW + fields + "\n", SmallImage.flat());
    return NrrdImages.open(file).voxelEdge();
  }

  @Test
  void everyBoxIsRead() throws IOException {
    ImageFile image = NrrdImages.open(write("a.nrrd", RAW + "\n", SmallImage.flat()));
    SmallImage.assertEveryBox(image);
    assertEquals("NRRD", image.facts().get("format"));
    assertEquals("raw", image.facts().get("encoding"));
    String windows = (RAW + "\n").replace("\n", "\r\n");
    SmallImage.assertEveryBox(NrrdImages.open(write("b.nrrd", windows, SmallImage.flat())));
  }

  @Test
  void everyBoxOfAGzippedImageIsRead() throws IOException {
    String header = RAW.replace("raw", "gzip");
    ImageFile image = NrrdImages.open(write("a.nrrd", header + "\n", gzip(SmallImage.flat())));
    SmallImage.assertEveryBox(image);
    String wide = header.replace("uint8", "ushort") + "endian: big\n\n";
    byte[] voxels = gzip(SmallImage.wide(2, ByteOrder.BIG_ENDIAN));
    SmallImage.assertEveryBox(NrrdImages.open(write("b.nrrd", wide, voxels)));
  }

  @Test
  void detachedDataIsRead() throws IOException {
    write("a.raw", "", SmallImage.flat());
    Path header = write("a.nhdr", RAW + "data file: a.raw\n", new byte[0]);
    ImageFile image = NrrdImages.open(header);
    SmallImage.assertEveryBox(image);
    assertEquals(header.toString(), image.name());
    assertEquals(folder.resolve("a.raw").toString(), image.facts().get("data_file"));
    write("a.raw.gz", "", gzip(SmallImage.flat()));
    SmallImage.assertEveryBox(
        NrrdImages.open(
            write("b.nhdr", RAW.replace("raw", "gz") + "datafile: a.raw.gz\n", new byte[0])));
  }

  @Test
  void bytesAreSkipped() throws IOException {
    write("a.raw", "twelve bytes", SmallImage.flat());
    String header = RAW + "data file: a.raw\nbyte skip: ";
    SmallImage.assertEveryBox(NrrdImages.open(write("a.nhdr", header + "12\n", new byte[0])));
    SmallImage.assertEveryBox(NrrdImages.open(write("b.nhdr", header + "-1\n", new byte[0])));
    Path wrong = write("c.nhdr", header + "11\n", new byte[0]);
    assertTrue(
        SmallImage.refusal(() -> NrrdImages.open(wrong), folder.resolve("a.raw"))
            .startsWith("file length must be 11 + nx*ny*nz (8 bit behind a header)"));
  }

  @ParameterizedTest
  @CsvSource({
    "int16, 2", "short int, 2", "signed short, 2", "unsigned short int, 2", "uint16_t, 2",
    "int, 4", "signed int, 4", "unsigned int, 4", "uint32, 4", "long long int, 8",
    "signed long long int, 8", "unsigned long long, 8", "ulonglong, 8"
  })
  void everyIntegerIsRead(String type, int bytes) throws IOException {
    for (ByteOrder order : new ByteOrder[] {ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN}) {
      String endian = order == ByteOrder.BIG_ENDIAN ? "big" : "little";
      String header = RAW.replace("uint8", type) + "endian: " + endian + "\n\n";
      SmallImage.assertEveryBox(
          NrrdImages.open(write("a.nrrd", header, SmallImage.wide(bytes, order))));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"domain domain domain", "Space  space SPACE", "none ??? domain"})
  void axesOfSpaceAreRead(String kinds) throws IOException {
    String header = RAW + "kinds: " + kinds + "\n\n";
    SmallImage.assertEveryBox(NrrdImages.open(write("a.nrrd", header, SmallImage.flat())));
  }

  @Test
  void voxelEdgeIsTakenWhereItsUnitIsStated() throws IOException {
    assertEquals(OptionalDouble.empty(), edge(""));
    assertEquals(OptionalDouble.empty(), edge("spacings: 5 5 5\n"));
    assertEquals(OptionalDouble.empty(), edge("spacings: nan nan nan\n"));
    assertEquals(
        OptionalDouble.empty(), edge("spacings: 5 5 5\nunits: \"pixel\" \"pixel\" \"pixel\"\n"));
    assertEquals(OptionalDouble.empty(), edge("spacings: 5 5 5\nunits: \"um\" \"um\" \"mm\"\n"));
    for (String micron : new String[] {"um", "µm", "micron", "microns", "micrometers"}) {
      String units = "\"" + micron + "\" \"" + micron + "\" \"" + micron + "\"\n";
      assertEquals(5e-6, edge("spacings: 5 5 5\nunits: " + units).orElseThrow(), 0);
    }
    String directions = "space directions: (0.005,0,0) (0,-0.003,0.004) (0,0.004,0.003)\n";
    assertEquals(OptionalDouble.empty(), edge(directions));
    assertEquals(5e-6, edge(directions + "space units: \"mm\" \"mm\" \"mm\"\n").orElseThrow(), 0);
  }

  @Test
  void voxelsThatAreNoCubesAreRefused() throws IOException {
    for (String spacing :
        new String[] {
          "spacings: 5 5 6\n",
          "spacings: 0 0 0\n",
          "spacings: -1 -1 -1\n",
          "space directions: (1,0,0) (0,2,0) (0,0,1)\n"
        }) {
      Path file = write("a.nrrd", RAW + spacing + "\n", SmallImage.flat());
      assertTrue(refusal(file).startsWith("voxels must be cubes"), refusal(file));
    }
    Path sheared =
        write("a.nrrd", RAW + "space directions: (1,0) (0,1) (.6,.8)\n\n", SmallImage.flat());
    assertTrue(refusal(sheared).startsWith("axes must be at right angles"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "NRRD0004 | NRRDX | file must be NRRD",
        "uint8 | float | labels must be integers of 0..255 (convert them to uint8): ",
        "uint8 | char | labels must be integers of 0..255",
        "uint8 | int16 | header must have the field 'endian': ",
        "dimension: 3 | dimension: 4 | image must have 3 dimensions (x y z): ",
        "sizes: 2 3 4 | sizes: 2 12 | image must have 3 dimensions (x y z): ",
        "sizes: 2 3 4 | sizes: 2 3 0 | image must have 3 dimensions",
        "sizes: 2 3 4 | sizes: 2 3 4000000000 | dimensions must be 1 to 2147483647: ",
        "sizes: 2 3 4 | sizes: 2 3 5 | file length must be",
        "sizes: 2 3 4 | size: 2 3 4 | header must have the field 'sizes': ",
        "encoding: raw | encoding: bzip2 | encoding must be raw or gzip",
        "encoding: raw | encoding: gzip | file must be sound gzip",
        "encoding: raw | no field here | header line must be 'field: value': ",
        "key:=value | type: uint8 | header must state each field once: ",
        "key:=value | line skip: 1 | line skip must be 0 (give byte skip): ",
        "key:=value | byte skip: x | field must be a whole number: ",
        "key:=value | byte skip: -2 | byte skip must be 0, or",
        "key:=value | data file: LIST | voxels must be in one data file",
        "key:=value | data file: x%03d.raw 1 9 1 | voxels must be in one data file",
        "key:=value | kinds: RGB-color domain domain | axes must be of space: 3 kinds of domain",
        "key:=value | kinds: domain domain time | axes must be of space",
        "key:=value | kinds: domain domain | axes must be of space",
        "key:=value | spacings: 1 1 | field must be 3 numbers (x y z): ",
        "key:=value | spacings: a b c | field must be numbers: ",
        "key:=value | space directions: none (1,0,0) (0,1,0) | field must be 3 vectors",
        "key:=value | space directions: (a) (b) (c) | field must be vectors of numbers",
      })
  void wrongHeadersAreRefused(String right, String wrong, String line) throws IOException {
    String header = RAW.replace(right, wrong) + "\n";
    Path file = write("a.nrrd", header, SmallImage.flat());
    assertTrue(refusal(file).startsWith(line), refusal(file));
  }

  @Test
  void missingDataIsRefused() throws IOException {
    Path header = write("a.nhdr", RAW + "data file: none.raw\n", new byte[0]);
    assertTrue(
        SmallImage.refusal(() -> NrrdImages.open(header), folder.resolve("none.raw"))
            .startsWith("file must exist"));
    Path endless = write("a.nrrd", RAW, new byte[0]);
    assertTrue(refusal(endless).startsWith("header must end with an empty line"));
    Path noText = write("b.nrrd", "NRRD0004\n", new byte[2 << 20]);
    assertTrue(refusal(noText).startsWith("header must end within 1048576 bytes"));
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 9, 12})
  void gzipThatIsCutShortIsRefused(int missing) throws IOException {
    byte[] packed = gzip(SmallImage.flat());
    byte[] cut = Arrays.copyOf(packed, packed.length - missing);
    Path file = write("a.nrrd", RAW.replace("raw", "gzip") + "\n", cut);
    assertTrue(refusal(file).startsWith("gzip stream must be complete"), refusal(file));
  }

  @Test
  void anotherInflatedLengthIsRefused() throws IOException {
    String header = RAW.replace("raw", "gzip") + "\n";
    assertTrue(
        refusal(write("a.nrrd", header, gzip(new byte[23])))
            .startsWith("inflated length must be nx*ny*nz (8 bit, no header): "));
    assertTrue(refusal(write("a.nrrd", header, gzip(new byte[25]))).contains("more than 24 bytes"));
    String wide = RAW.replace("raw", "gzip").replace("uint8", "int16") + "endian: little\n\n";
    assertTrue(
        refusal(write("a.nrrd", wide, gzip(new byte[47])))
            .startsWith("inflated length must be 2*nx*ny*nz (int16, no header): "));
  }
}
