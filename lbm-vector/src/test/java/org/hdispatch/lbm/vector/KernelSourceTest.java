package org.hdispatch.lbm.vector;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.hdispatch.lbm.VelocitySet;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class KernelSourceTest {
  /**
   * After a change: {@code mvn -q -pl lbm-vector -am test-compile} and, in the folder {@code
   * lbm-vector}, {@code java -cp target/test-classes:../lbm/target/classes
   * org.hdispatch.lbm.vector.KernelSource}.
   */
  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void kernelsAreWhatTheTableGives(VelocitySet set) throws IOException {
    for (Map.Entry<Path, String> file : KernelSource.files(set).entrySet()) {
      String written = Files.readString(file.getKey()).replace("\r\n", "\n");
      assertEquals(file.getValue(), written, file.getKey().toString());
    }
  }
}
