package org.hdispatch.sph.vector;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class SumsSourceTest {
  /**
   * After a change: {@code mvn -q -pl sph-vector -am test-compile} and, in the folder {@code
   * sph-vector}, {@code java -cp target/test-classes org.hdispatch.sph.vector.SumsSource}.
   */
  @ParameterizedTest
  @EnumSource(SumsSource.class)
  void loopsAreWhatTheSourceGives(SumsSource source) throws IOException {
    String written = Files.readString(source.file()).replace("\r\n", "\n");
    assertEquals(source.text(), written, source.file().toString());
  }
}
