package org.hdispatch.app.rock;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.hdispatch.app.Cli;
import org.hdispatch.app.RawFile;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The same rock in every format gives the same answers. */
class ImageInputsTest {
  private static final int NX = 12;
  private static final int NY = 10;
  private static final int NZ = 8;
  private static final String NRRD =
      "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 12 10 8\nencoding: raw\n";
  private static final String META =
      "NDims = 3\nDimSize = 12 10 8\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n";

  @TempDir Path folder;

  private byte[] voxels;
  private Path raw;

  @BeforeEach
  void writeRaw() throws IOException {
    raw = RawFile.write(folder, NX, NY, NZ, (x, y, z) -> (x + z / 4) % 5 < 3 && y > 1 && y < 8);
    voxels = Files.readAllBytes(raw);
  }

  private Path write(String name, String header) throws IOException {
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    file.write(header.getBytes("ISO-8859-1"));
    file.write(voxels);
    return Files.write(folder.resolve(name), file.toByteArray());
  }

  private Path numpy() throws IOException {
    String header = "{'descr': '|u1', 'fortran_order': False, 'shape': (8, 10, 12), }";
    String padded = header + " ".repeat(117 - header.length()) + "\n";
    return write("rock.npy", "\u0093NUMPY\1\0" + (char) padded.length() + "\0" + padded);
  }

  /** A folder of slices: header, pixels, directory. */
  private Path slices() throws IOException {
    Path slices = Files.createDirectory(folder.resolve("slices"));
    for (int z = 0; z < NZ; z++) {
      ByteBuffer page = ByteBuffer.allocate(8 + NX * NY + 2 + 7 * 12 + 4);
      page.order(ByteOrder.LITTLE_ENDIAN).put(new byte[] {'I', 'I', 42, 0}).putInt(8 + NX * NY);
      page.put(voxels, z * NX * NY, NX * NY).putShort((short) 7);
      int[][] tags = {
        {256, NX}, {257, NY}, {258, 8}, {262, 1}, {273, 8}, {278, NY}, {279, NX * NY}
      };
      for (int[] tag : tags) {
        page.putShort((short) tag[0]).putShort((short) 4).putInt(1).putInt(tag[1]);
      }
      Files.write(slices.resolve("slice" + (z + 5) + ".tif"), page.array());
    }
    return slices;
  }

  private static Map<String, String> without(Map<String, String> row, List<String> keys) {
    row.keySet().removeAll(keys);
    return row;
  }

  @Test
  void inspectSaysTheSameOfTheVoxelsInEveryFormat() throws IOException {
    List<String> ofTheFile =
        List.of(
            "image",
            "format",
            "file_bytes",
            "image_bytes",
            "type",
            "shape",
            "order",
            "encoding",
            "compressed",
            "slices",
            "first_slice",
            "last_slice");
    Map<String, String> expected =
        without(Cli.json("inspect", raw, "--dims=12,10,8", "--json"), ofTheFile);
    assertTrue(expected.containsKey("porosity_connected_z"));
    for (Path file :
        List.of(numpy(), slices(), write("rock.nrrd", NRRD + "\n"), write("rock.mha", META))) {
      assertEquals(
          expected, without(Cli.json("inspect", file, "--json"), ofTheFile), file.toString());
    }
  }

  @Test
  void permeabilityIsTheSameInEveryFormat() throws IOException {
    String[] keys = {"permeability_m2", "porosity", "steps", "voxel_edge_m"};
    String box = "--box=1,1,1,10,9,6";
    Map<String, String> expected =
        Cli.json("permeability", raw, "--dims=12,10,8", "--voxel-edge=5e-6", box, "--json");
    Path nrrd = write("rock.nrrd", NRRD + "spacings: 5 5 5\nunits: \"um\" \"um\" \"um\"\n\n");
    Path meta = write("rock.mha", "ElementSpacing = 0.005 0.005 0.005\n" + META);
    for (List<Object> file :
        List.of(
            List.<Object>of(numpy(), "--voxel-edge=5e-6"),
            List.<Object>of(slices(), "--voxel-edge=5e-6"),
            List.<Object>of(nrrd, "--axis=z"),
            List.<Object>of(meta, "--axis=z"))) {
      Map<String, String> found = Cli.json("permeability", file.get(0), box, "--json", file.get(1));
      for (String key : keys) {
        assertTrue(expected.containsKey(key), key);
        assertEquals(expected.get(key), found.get(key), key + " of " + file);
      }
    }
  }

  @Test
  void voxelEdgeMustBeGivenWhereTheFileDoesNotStateIt() throws IOException {
    for (Path file :
        List.of(
            numpy(),
            slices(),
            write("rock.nrrd", NRRD + "spacings: 5 5 5\n\n"),
            write("rock.mha", "ElementSpacing = 1 1 1\n" + META))) {
      Cli.run("permeability", file).assertRefused(2, "give --voxel-edge", "file=" + file);
    }
  }

  @Test
  void sizeIsKnownFromTheFile() throws IOException {
    Cli.run("inspect", numpy(), "--dims=12,10,8")
        .assertRefused(2, "--dims must be left out, as NumPy knows its size: file=");
    Cli.run("inspect", slices(), "--dims=12,10,8").assertRefused(2, "as TIFF knows its size");
    Cli.run("inspect", numpy(), "--dataset=/rock").assertRefused(3, "file must be HDF5");
  }

  @Test
  void wrongFilesAreRefusedInOneLine() throws IOException {
    for (String name : List.of("a.tif", "a.npy", "a.nrrd", "a.nhdr", "a.mhd", "a.mha")) {
      Path text = Files.writeString(folder.resolve(name), "not what its name says");
      Cli.run("inspect", text).assertRefused(3, "file must be", "file=" + text);
      Cli.run("inspect", folder.resolve("none-" + name)).assertRefused(3, "file must exist: file=");
    }
  }
}
