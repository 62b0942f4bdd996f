package org.hdispatch.lbm.vector;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hdispatch.lbm.Equilibrium;
import org.hdispatch.lbm.VelocitySet;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class KernelSourceTest {
  /**
   * After a change: {@code mvn -q -pl lbm-vector -am test-compile} and {@code java -cp
   * lbm-vector/target/test-classes:lbm/target/classes org.hdispatch.lbm.vector.KernelSource
   * lbm-vector/src/main/java/org/hdispatch/lbm/vector}.
   */
  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void kernelsAreWhatTheTableGives(VelocitySet set) throws IOException {
    for (Equilibrium equilibrium : Equilibrium.values()) {
      String name = KernelSource.className(set, equilibrium) + ".java";
      Path file = Path.of("src/main/java/org/hdispatch/lbm/vector", name);
      String written = Files.readString(file).replace("\r\n", "\n");
      assertEquals(KernelSource.of(set, equilibrium), written, name);
    }
  }
}
