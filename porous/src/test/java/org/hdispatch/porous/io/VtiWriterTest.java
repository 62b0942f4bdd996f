package org.hdispatch.porous.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

class VtiWriterTest {
  private static final VtiGrid GRID = new VtiGrid(2, 3, 4, 5e-6, 0, 1e-6, -2e-6);

  @TempDir Path folder;

  private static double[] counting(double from) {
    double[] values = new double[24];
    for (int i = 0; i < values.length; i++) {
      values[i] = from + i;
    }
    return values;
  }

  /** Index of the first byte of appended data: the one after the underscore. */
  private static int dataStart(byte[] bytes) {
    String text = new String(bytes, StandardCharsets.ISO_8859_1);
    return text.indexOf('_', text.indexOf("<AppendedData encoding=\"raw\">")) + 1;
  }

  private static Document header(byte[] bytes) throws Exception {
    String text = new String(bytes, 0, dataStart(bytes) - 1, StandardCharsets.UTF_8);
    byte[] xml = (text + "</AppendedData></VTKFile>").getBytes(StandardCharsets.UTF_8);
    return DocumentBuilderFactory.newInstance()
        .newDocumentBuilder()
        .parse(new ByteArrayInputStream(xml));
  }

  private static Element only(Document document, String tag) {
    NodeList list = document.getElementsByTagName(tag);
    assertEquals(1, list.getLength());
    return (Element) list.item(0);
  }

  private void assertNothingBeside(String... names) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(
          List.of(names), files.map(path -> path.getFileName().toString()).sorted().toList());
    }
  }

  @Test
  void headerSaysSizeSpacingAndWhereEachArrayStarts() throws Exception {
    Path file = folder.resolve("flow.vti");
    VtiWriter.write(
        file,
        GRID,
        List.of(
            VtiArray.labels("solid", SmallImage.flat()),
            VtiArray.vector("velocity (m/s)", counting(0), counting(100), counting(200)),
            VtiArray.scalar("p < \"0\" & more", counting(0.5))));
    byte[] bytes = Files.readAllBytes(file);
    Document document = header(bytes);
    Element root = document.getDocumentElement();
    assertEquals("ImageData", root.getAttribute("type"));
    assertEquals("LittleEndian", root.getAttribute("byte_order"));
    assertEquals("UInt64", root.getAttribute("header_type"));
    Element image = only(document, "ImageData");
    assertEquals("0 2 0 3 0 4", image.getAttribute("WholeExtent"));
    assertEquals("5.0E-6 5.0E-6 5.0E-6", image.getAttribute("Spacing"));
    assertEquals("0.0 1.0E-6 -2.0E-6", image.getAttribute("Origin"));
    assertEquals("0 2 0 3 0 4", only(document, "Piece").getAttribute("Extent"));

    NodeList arrays = only(document, "CellData").getElementsByTagName("DataArray");
    String[] types = {"UInt8", "Float32", "Float32"};
    String[] names = {"solid", "velocity (m/s)", "p < \"0\" & more"};
    int[] components = {1, 3, 1};
    int[] lengths = {24, 24 * 3 * 4, 24 * 4};
    ByteBuffer data = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    int end = dataStart(bytes);
    for (int i = 0; i < 3; i++) {
      Element array = (Element) arrays.item(i);
      assertEquals(types[i], array.getAttribute("type"));
      assertEquals(names[i], array.getAttribute("Name"));
      assertEquals(components[i], Integer.parseInt(array.getAttribute("NumberOfComponents")));
      assertEquals("appended", array.getAttribute("format"));
      int at = dataStart(bytes) + Integer.parseInt(array.getAttribute("offset"));
      assertEquals(end, at);
      assertEquals(lengths[i], data.getLong(at));
      end = at + 8 + lengths[i];
    }
    assertEquals(
        "\n</AppendedData>\n</VTKFile>\n",
        new String(bytes, end, bytes.length - end, StandardCharsets.US_ASCII));
    assertNothingBeside("flow.vti");
  }

  @Test
  void valuesComeBackAsTheyWere() throws IOException {
    Path file = folder.resolve("flow.vti");
    double[] x = counting(0.25);
    double[] y = counting(-100);
    float[] pressure = {1.5f, -2, Float.MIN_VALUE, 0, 3, 4, 5, 6, 7, 8, 9, 10};
    VtiWriter.write(
        file,
        VtiGrid.atOrigin(2, 3, 2, 1),
        List.of(
            VtiArray.vector("v", 12, (v, c) -> c == 0 ? x[v] : c == 1 ? y[v] : 0),
            VtiArray.scalar("p", pressure),
            VtiArray.labels("l", 12, (v, c) -> 244 + v)));
    byte[] bytes = Files.readAllBytes(file);
    ByteBuffer data = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    data.position(dataStart(bytes) + 8);
    for (int i = 0; i < 12; i++) {
      assertEquals((float) x[i], data.getFloat());
      assertEquals((float) y[i], data.getFloat());
      assertEquals(0f, data.getFloat());
    }
    assertEquals(12 * 4, data.getLong());
    for (float p : pressure) {
      assertEquals(p, data.getFloat());
    }
    assertEquals(12, data.getLong());
    for (int i = 0; i < 12; i++) {
      assertEquals(244 + i, data.get() & 0xff);
    }
  }

  @Test
  void arraysLargerThanTheBufferAreWhole() throws IOException {
    Path file = folder.resolve("large.vti");
    int n = 70; // 343,000 vectors of 12 bytes: four buffers
    VtiWriter.write(
        file,
        VtiGrid.atOrigin(n, n, n, 1),
        List.of(VtiArray.vector("v", n * n * n, (v, c) -> 3 * v + c)));
    byte[] bytes = Files.readAllBytes(file);
    ByteBuffer data = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    data.position(dataStart(bytes));
    assertEquals(n * n * n * 12L, data.getLong());
    for (int i = 0; i < n * n * n * 3; i++) {
      assertEquals(i, data.getFloat());
    }
  }

  @Test
  void anExistingFileIsReplacedOnlyByAWholeOne() throws IOException {
    Path file = folder.resolve("flow.vti");
    Files.writeString(file, "earlier result");
    VtiArray failing =
        VtiArray.scalar(
            "p",
            24,
            (v, c) -> {
              if (v == 20) {
                throw new IllegalStateException("solver gone");
              }
              return v;
            });
    assertThrows(IllegalStateException.class, () -> VtiWriter.write(file, GRID, List.of(failing)));
    assertEquals("earlier result", Files.readString(file));
    assertNothingBeside("flow.vti");
    VtiWriter.write(file, GRID, List.of(VtiArray.labels("l", new byte[24])));
    assertTrue(Files.readString(file).startsWith("<?xml"));
    assertNothingBeside("flow.vti");
  }

  @Test
  void unwritableTargetsAreRefusedAndLeaveNothing() throws IOException {
    List<VtiArray> arrays = List.of(VtiArray.labels("l", new byte[24]));
    Path nowhere = folder.resolve("none").resolve("flow.vti");
    ImageFileException e =
        assertThrows(ImageFileException.class, () -> VtiWriter.write(nowhere, GRID, arrays));
    assertTrue(e.getMessage().startsWith("output must be writable: file=" + nowhere));
    assertThrows(ImageFileException.class, () -> VtiWriter.write(folder, GRID, arrays));
    assertNothingBeside();
  }

  @Test
  void arraysMustFitTheGridAndDiffer() {
    Path file = folder.resolve("flow.vti");
    List<VtiArray> wrongSize = List.of(VtiArray.labels("l", new byte[23]));
    assertThrows(IllegalArgumentException.class, () -> VtiWriter.write(file, GRID, wrongSize));
    VtiArray twice = VtiArray.labels("l", new byte[24]);
    List<VtiArray> sameName = List.of(twice, twice);
    assertThrows(IllegalArgumentException.class, () -> VtiWriter.write(file, GRID, sameName));
    assertThrows(
        IllegalArgumentException.class,
        () -> VtiArray.vector("v", new float[1], new float[2], new float[1]));
    assertTrue(Files.notExists(file));
  }

  @Test
  void spacingMustBePositiveAndFinite() {
    for (double spacing : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
      assertThrows(IllegalArgumentException.class, () -> VtiGrid.atOrigin(1, 1, 1, spacing));
    }
  }
}
