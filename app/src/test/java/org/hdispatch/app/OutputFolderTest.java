package org.hdispatch.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OutputFolderTest {
  @TempDir Path root;

  @Test
  void folderIsTakenAwayWhenNothingCameIntoIt() throws IOException {
    OutputFolder.open(root.resolve("a/b")).close();
    assertFalse(Files.exists(root.resolve("a")));
  }

  @Test
  void folderStaysWithWhatItHolds() throws IOException {
    try (OutputFolder folder = OutputFolder.open(root.resolve("a/b"))) {
      folder.write("text", "h\u00e9\n");
    }
    assertEquals("h\u00e9\n", Files.readString(root.resolve("a/b/text")));
  }

  @Test
  void folderThatWasThereStays() throws IOException {
    OutputFolder.open(root).close();
    assertTrue(Files.isDirectory(root));
  }
}
