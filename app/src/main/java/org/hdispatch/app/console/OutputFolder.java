package org.hdispatch.app.console;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.io.WholeFiles;

/**
 * The folder that files are written to. It is made and tried before the computation, and taken away
 * again if nothing came into it.
 */
public final class OutputFolder implements AutoCloseable {
  private final Path folder;
  private final Deque<Path> made; // innermost first
  private final boolean own; // nobody else comes to it

  private OutputFolder(Path folder, Deque<Path> made, boolean own) {
    this.folder = folder;
    this.made = made;
    this.own = own;
  }

  /**
   * Makes a folder, if it is not there, and tries to write to it.
   *
   * @throws ImageFileException if that is not possible; nothing is left behind
   */
  public static OutputFolder open(Path folder) throws ImageFileException {
    return open(folder, true);
  }

  /**
   * Likewise, for a folder that other processes may come to at any time: it is not taken away, as
   * one of them may be about to write its first file.
   */
  public static OutputFolder openShared(Path folder) throws ImageFileException {
    return open(folder, false);
  }

  private static OutputFolder open(Path folder, boolean own) throws ImageFileException {
    if (Files.exists(folder) && !Files.isDirectory(folder)) {
      throw new ImageFileException("output must be a folder: folder=" + folder);
    }
    OutputFolder opened = new OutputFolder(folder, new ArrayDeque<>(), own);
    try {
      opened.makeWithParents(folder.toAbsolutePath().normalize());
      Files.delete(Files.createTempFile(folder, ".hdispatch", ".part"));
      return opened;
    } catch (IOException e) {
      opened.close();
      throw new ImageFileException("output must be writable: folder=" + folder + ", cause=" + e, e);
    }
  }

  private void makeWithParents(Path missing) throws IOException {
    if (!Files.isDirectory(missing)) {
      if (missing.getParent() != null) {
        makeWithParents(missing.getParent());
      }
      try {
        Files.createDirectory(missing);
      } catch (FileAlreadyExistsException e) {
        if (Files.isDirectory(missing)) {
          return; // another process made it meanwhile, as shards do that start together
        }
        throw e;
      }
      if (own) {
        made.push(missing);
        missing.toFile().deleteOnExit(); // if it is empty then: Ctrl-C may leave no time to close
      }
    }
  }

  /** The folder itself. */
  public Path path() {
    return folder;
  }

  /** A file in this folder. */
  public Path file(String name) {
    return folder.resolve(name);
  }

  /** Writes a text as UTF-8; it is whole or not there. */
  public void write(String name, String text) throws ImageFileException {
    WholeFiles.write(file(name), text);
  }

  /** Takes away what was made and is still empty. */
  @Override
  public void close() {
    try {
      while (!made.isEmpty()) {
        Files.delete(made.pop());
      }
    } catch (IOException e) {
      made.clear(); // it holds files, as it should
    }
  }
}
