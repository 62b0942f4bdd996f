package org.hdispatch.porous.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

class VtpWriterTest {
  private static final int COUNT = 5;
  private static final VtiArray POINTS = VtiArray.vector("points", COUNT, (n, c) -> 10 * n + c);

  @TempDir Path folder;

  @Test
  void everyPointIsAVertexWithItsValues() throws Exception {
    Path file = folder.resolve("particles.vtp");
    VtpWriter.write(
        file,
        POINTS,
        List.of(
            VtiArray.integers("id", COUNT, (n, c) -> 1 << 24 + n),
            VtiArray.labels("phase", COUNT, (n, c) -> n % 2),
            VtiArray.scalar("density", COUNT, (n, c) -> 0.5 * n)));
    byte[] bytes = Files.readAllBytes(file);
    String text = new String(bytes, StandardCharsets.ISO_8859_1);
    int start = text.indexOf("<AppendedData encoding=\"raw\">\n_") + 31;
    String header = text.substring(0, start - 1) + "</AppendedData></VTKFile>";
    Element root =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(new ByteArrayInputStream(header.getBytes(StandardCharsets.UTF_8)))
            .getDocumentElement();
    assertEquals("PolyData", root.getAttribute("type"));
    Element piece = (Element) root.getElementsByTagName("Piece").item(0);
    assertEquals("5", piece.getAttribute("NumberOfPoints"));
    assertEquals("5", piece.getAttribute("NumberOfVerts"));
    NodeList arrays = root.getElementsByTagName("DataArray");
    List<String> names = List.of("id", "phase", "density", "points", "connectivity", "offsets");
    int[] lengths = {4 * COUNT, COUNT, 4 * COUNT, 12 * COUNT, 4 * COUNT, 4 * COUNT};
    ByteBuffer data = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    data.position(start);
    assertEquals(names.size(), arrays.getLength());
    for (int i = 0; i < lengths.length; i++) {
      Element array = (Element) arrays.item(i);
      assertEquals(names.get(i), array.getAttribute("Name"));
      assertEquals(data.position() - start, Integer.parseInt(array.getAttribute("offset")));
      assertEquals(lengths[i], data.getLong());
      for (int n = 0; n < COUNT; n++) {
        switch (names.get(i)) {
          case "id" -> assertEquals(1 << 24 + n, data.getInt());
          case "phase" -> assertEquals(n % 2, data.get());
          case "density" -> assertEquals(0.5f * n, data.getFloat());
          case "connectivity" -> assertEquals(n, data.getInt());
          case "offsets" -> assertEquals(n + 1, data.getInt());
          default -> {
            for (int c = 0; c < 3; c++) {
              assertEquals(10 * n + c, data.getFloat());
            }
          }
        }
      }
    }
    String end = text.substring(data.position());
    assertEquals("\n</AppendedData>\n</VTKFile>\n", end);
  }

  @Test
  void arraysMustFitThePointsAndDiffer() {
    Path file = folder.resolve("particles.vtp");
    VtiArray scalar = VtiArray.scalar("p", COUNT, (n, c) -> 0);
    List<VtiArray> fewer = List.of(VtiArray.scalar("p", COUNT - 1, (n, c) -> 0));
    assertThrows(IllegalArgumentException.class, () -> VtpWriter.write(file, POINTS, fewer));
    List<VtiArray> twice = List.of(scalar, scalar);
    assertThrows(IllegalArgumentException.class, () -> VtpWriter.write(file, POINTS, twice));
    assertThrows(IllegalArgumentException.class, () -> VtpWriter.write(file, scalar, List.of()));
    assertTrue(Files.notExists(file));
  }
}
