package org.hdispatch.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.jhdf.HdfFile;
import io.jhdf.WritableHdfFile;
import io.jhdf.api.DatasetCreationOptions;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.hdispatch.app.console.Host;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Each wrong input gets one line, its exit code, and leaves nothing behind. */
class WrongInputTest {
  @TempDir Path folder;

  private List<Path> before;

  @BeforeEach
  void makeInputs() throws IOException {
    RawFile.write(folder, 4, 4, 4, (x, y, z) -> x > 0);
    Files.write(folder.resolve("solid.raw"), new byte[64]);
    Files.write(folder.resolve("empty.raw"), new byte[0]);
    Files.write(folder.resolve("text.h5"), "no HDF5".getBytes());
    try (WritableHdfFile hdf = HdfFile.write(folder.resolve("sets.h5"))) {
      hdf.putDataset("volume", pores(), DatasetCreationOptions.builder().unsigned().build());
      hdf.putDataset("plane", new byte[4][4]);
      hdf.putDataset("grey", new float[4][4][4]);
    }
    before = files();
  }

  @AfterEach
  void nothingIsLeftBehind() throws IOException {
    assertEquals(before, files());
  }

  private static byte[][][] pores() {
    byte[][][] labels = new byte[4][4][4];
    labels[0][0][0] = 1;
    return labels;
  }

  private List<Path> files() throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      return all.sorted().toList();
    }
  }

  private Cli permeability(String image, Object... more) {
    Object[] args = new Object[more.length + 2];
    args[0] = "permeability";
    args[1] = folder.resolve(image);
    System.arraycopy(more, 0, args, 2, more.length);
    return Cli.run(args);
  }

  @ParameterizedTest
  @ValueSource(strings = {"permeability", "inspect"})
  void fileMustExistAndHoldSomething(String command) {
    Cli.run(command, folder.resolve("missing.raw"))
        .assertRefused(3, "file must exist: file=", "missing.raw");
    Cli.run(command, folder.resolve("missing.h5")).assertRefused(3, "file must exist");
    Cli.run(command, folder).assertRefused(3, "folder must hold the slices of an image");
    Cli.run(command, folder.resolve("empty.raw"), "--dims", "4,4,4")
        .assertRefused(3, "file must not be empty");
    Cli.run(command, folder.resolve("text.h5")).assertRefused(3, "file must be HDF5");
  }

  @ParameterizedTest
  @ValueSource(strings = {"4,4,5", "4,4,3", "2000000,2000000,2000000"})
  void rawLengthMustMatchTheSize(String dims) {
    permeability("image.raw", "--dims", dims, "--voxel-edge", 1e-6)
        .assertRefused(3, "file length must be nx*ny*nz", "length=64 bytes", "dims=" + dims);
  }

  @Test
  void rawImageMustComeWithItsSize() {
    permeability("image.raw").assertRefused(2, "(--dims nx,ny,nz)", "--dims 4,4,4");
    permeability("image.raw", "--dims", "4,4").assertRefused(2, "--dims must be 3 integers");
    permeability("image.raw", "--dims", "4,4,0").assertRefused(2, "at least 1 voxel");
    permeability("sets.h5", "--dims", "4,4,4").assertRefused(2, "--dims must be left out");
  }

  @Test
  void datasetMustExistAndBeAnImageOfLabels() {
    permeability("sets.h5", "--dataset", "/rock")
        .assertRefused(3, "dataset must exist", "/volume", "/plane");
    permeability("sets.h5", "--dataset", "/plane").assertRefused(3, "must have 3 dimensions");
    permeability("sets.h5", "--dataset", "/grey").assertRefused(3, "labels must be integers");
  }

  @Test
  void imageMustHavePores() {
    permeability("solid.raw", "--dims", "4,4,4", "--voxel-edge", 1e-6)
        .assertRefused(3, "image must have pore voxels", "pore=1", "labels=0");
    permeability("sets.h5", "--box", "2,2,2,2,2,2", "--voxel-edge", 1e-6)
        .assertRefused(3, "image must have pore voxels", "box=2,2,2,2,2,2");
  }

  @Test
  void voxelEdgeMustBeKnownAndPositive() {
    permeability("image.raw", "--dims", "4,4,4").assertRefused(2, "give --voxel-edge");
    for (String edge : List.of("0", "-1e-6", "1e-200", "NaN", "Infinity")) {
      permeability("image.raw", "--dims", "4,4,4", "--voxel-edge", edge)
          .assertRefused(2, "voxel edge must be positive, from 1e-15 to 1e3 m: edge=");
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--tau | 0.5 | relaxation time must exceed 0.5",
        "--tau | NaN | relaxation time must exceed 0.5",
        "--tau | Infinity | tau=Infinity",
        "--tolerance | NaN | tolerance must lie between 0 and 1: tolerance=NaN",
        "--tolerance | 0 | tolerance must lie between 0 and 1: tolerance=0.0",
        "--tolerance | Infinity | tolerance must lie between 0 and 1",
        "--viscosity | NaN | viscosity must be positive: viscosity=NaN m2/s",
        "--density | -1 | density must be positive: density=-1.0 kg/m3",
        "--pressure-gradient | Infinity | pressure gradient must lie between",
        "--threads | 0 | threads must number 1 to 4096: threads=0",
        "--threads | two | --threads must be an integer: --threads=two",
        "--max-steps | 0 | steps must number at least 1: steps=0",
        "--max-steps | NaN | --max-steps must be an integer: --max-steps=NaN",
        "--inlet-layers | 0 | inlet layers must number 1 to 10000",
        "--axis | w | --axis must be one of x, y, z, all: --axis=w",
        "--lattice | D2Q9 | --lattice must be one of D3Q15, D3Q19",
        "--box | 0,0,0,65,64,64 | box must lie inside the image",
        "--box | 0,0,0,4,4 | --box must be 6 integers: --box=0,0,0,4,4",
        "--box | 0,0,0,4,4,x | --box must be 6 integers",
        "--box | 0,0,0,4,4,9999999999 | --box must be 6 integers",
        "--box | -1,0,0,4,4,4 | box origin must not be negative",
        "--pore-value | 256 | pore label must be within 0..255: label=256",
        "--dims | 4,4,4 | --dims must come with an IMAGE",
        "--size | 16 | --size must come with --spheres",
        "--voxel-ege | 1 | did you mean --voxel-edge?",
      })
  void optionsMustBePossible(String option, String value, String line) {
    Cli.run("permeability", option, value).assertRefused(2, line);
  }

  @Test
  void spheresMustComeAlone() {
    permeability("image.raw", "--spheres", "sc").assertRefused(2, "must not be combined");
    Cli.run("permeability", "--spheres", "sc", "--box", "0,0,0,1,1,1")
        .assertRefused(2, "--box must come with an image, not --spheres");
    Cli.run("permeability", "--spheres", "sc", "--sides", "wall")
        .assertRefused(2, "periodic on all sides");
    Cli.run("permeability", "--spheres", "sc", "--solid-fraction", "NaN")
        .assertRefused(2, "solid fraction must be between 0 and 1: c=NaN");
    Cli.run("permeability", "--spheres", "sc", "--solid-fraction", "0.6")
        .assertRefused(2, "spheres must not overlap");
    Cli.run("permeability", "--spheres", "sc", "--size", "0").assertRefused(2, "size=0");
  }

  @Test
  void boxMustComeOnce() {
    for (String command : List.of("permeability", "inspect")) {
      Cli.run(command, "--box=0,0,0,4,4,4", "--box=1,1,1,4,4,4")
          .assertRefused(2, "--box must come once: --box=0,0,0,4,4,4 1,1,1,4,4,4");
    }
  }

  @Test
  void layersMustBeOfASlab() {
    for (String inlet : new String[] {"periodic", "pressure"}) {
      Cli.run("permeability", "--inlet", inlet, "--inlet-layers", "3")
          .assertRefused(2, "--inlet-layers must come with --inlet slab");
    }
  }

  @Test
  void formsMustNotBeCombined() {
    Cli.run("permeability", "--json", "--csv").assertRefused(2, "--json and --csv");
  }

  @Test
  void allPoreWithoutWallsIsRefused() {
    for (String sides : new String[] {"periodic", "mirror"}) {
      permeability(
              "solid.raw",
              "--dims=4,4,4",
              "--pore-value=0",
              "--voxel-edge=1e-6",
              "--sides=" + sides,
              "--output=" + folder.resolve("result"))
          .assertRefused(
              2, "pore space must have a wall", "sides=" + sides.toUpperCase(Locale.ROOT));
    }
  }

  @Test
  void heapMustHoldTheComputation() {
    Host small = new Host(40L << 20, false);
    Cli.run(small, "permeability", "--output", folder.resolve("result"))
        .assertRefused(5, "heap must hold the flow of 50343 pore voxels", "heap=40 MiB", "-Xmx");
    Cli.run(small, "permeability", "--spheres", "sc", "--size", 1000)
        .assertRefused(5, "spheres of 1000^3 voxels", "-Xmx");
  }

  @Test
  void whatTheHeapLineAdvisesIsEnough() {
    Cli refused = Cli.run(new Host(40L << 20, false), "permeability");
    String megabytes = refused.err().replaceAll("(?s).* java -Xmx(\\d+)m.*", "$1");
    Host advised = new Host(Long.parseLong(megabytes) << 20, false);
    assertEquals(4, Cli.run(advised, "permeability", "--max-steps", 1).code());
  }

  @Test
  void outputMustBeWritable() {
    // Below a file: nobody can write there, root included.
    for (String command : List.of("permeability", "inspect")) {
      Cli.run(command, "--output", folder.resolve("image.raw/result"))
          .assertRefused(3, "output must be writable");
      Cli.run(command, "--output", folder.resolve("image.raw"))
          .assertRefused(3, "output must be a folder");
    }
  }

  @Test
  void stackTraceIsShownOnlyOnRequest() {
    assertFalse(Cli.run("permeability", "--threads", 0).err().contains("\tat "));
    assertTrue(Cli.run("permeability", "--threads", 0, "--stacktrace").err().contains("\tat "));
  }
}
