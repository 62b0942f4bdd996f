package org.hdispatch.app.console;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.concurrent.Callable;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
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

  /** As shards that start together do. */
  @Test
  void folderMayBeMadeBySeveralAtOnce() throws Exception {
    int several = 4;
    CyclicBarrier together = new CyclicBarrier(several);
    ExecutorService threads = Executors.newFixedThreadPool(several);
    try {
      for (int round = 0; round < 50; round++) {
        Path folder = root.resolve(round + "/a/b/c/d");
        Callable<OutputFolder> open =
            () -> {
              together.await();
              return OutputFolder.open(folder);
            };
        for (Future<OutputFolder> opened : threads.invokeAll(Collections.nCopies(several, open))) {
          assertEquals(folder, opened.get().path());
        }
      }
    } finally {
      threads.shutdown();
    }
  }

  @Test
  void folderThatWasThereStays() throws IOException {
    OutputFolder.open(root).close();
    assertTrue(Files.isDirectory(root));
  }
}
