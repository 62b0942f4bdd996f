package org.hdispatch.app.console;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class HostTest {
  @TempDir private Path folder;

  @Test
  void machineFileIsWhereUsersExpectIt() {
    Path end = Path.of("hdispatch", "machine.properties");
    String config = folder.resolve("config").toString();
    assertEquals(
        Optional.of(Path.of(config).resolve(end)),
        Host.machineFile(Map.of("XDG_CONFIG_HOME", config), "/home/me"));
    assertEquals(
        Optional.of(Path.of(config).resolve(end)),
        Host.machineFile(Map.of("APPDATA", config), "/home/me"));
    for (String unfit : List.of("", "relative")) {
      assertEquals(
          Optional.of(Path.of("/home/me", ".config").resolve(end)),
          Host.machineFile(Map.of("XDG_CONFIG_HOME", unfit), "/home/me"));
    }
    assertEquals(Optional.empty(), Host.machineFile(Map.of(), null));
  }
}
