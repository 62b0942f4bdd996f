package org.hdispatch.app.rock;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.io.Hdf5Dataset;
import org.hdispatch.porous.io.Hdf5Images;
import org.junit.jupiter.api.Test;

class SampleRockTest {
  @Test
  void isTheBlockThatItSaysItIs() throws IOException {
    String data = System.getProperty("hdispatch.data", "");
    assumeFalse(data.isBlank(), "needs -Dhdispatch.data");
    Hdf5Dataset berea = Hdf5Images.select(Path.of(data, "berea", "berea_400.h5"), Optional.empty());
    int n = SampleRock.SIZE;
    SampleRock sample = new SampleRock();
    assertArrayEquals(
        Hdf5Images.read(berea, new VoxelBox(320, 192, 192, n, n, n)).toLabels(),
        sample.read(sample.whole()).toLabels());
    assertEquals(berea.voxelEdge(), sample.voxelEdge());
  }
}
