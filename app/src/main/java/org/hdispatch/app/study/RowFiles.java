package org.hdispatch.app.study;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * The rows of a study in a folder, a JSON file for each, and the smallest heaps; a file is whole or
 * not there.
 */
public final class RowFiles {
  private static final String ROWS = "rows";
  private static final String JSON = ".json";

  /** How rows are listed: by what was done, the ways to do it next to each other. */
  private static final Comparator<GcCase> ORDER =
      Comparator.comparing(GcCase::workload)
          .thenComparing(GcCase::scratchBytes)
          .thenComparing(run -> Runtime.Version.parse(run.java()))
          .thenComparing(GcCase::collector)
          .thenComparing(GcCase::heapFactor)
          .thenComparing(GcCase::policy);

  private final Path folder;

  /**
   * Names the folder.
   *
   * @param folder of a study; exists
   */
  public RowFiles(Path folder) {
    this.folder = folder;
  }

  /**
   * All rows, in an order that does not depend on when they were made.
   *
   * @throws IOException if a file cannot be read, or is not of a row
   */
  public List<GcRow> all() throws IOException {
    List<GcRow> rows = new ArrayList<>();
    Path place = folder.resolve(ROWS);
    if (Files.isDirectory(place)) {
      try (DirectoryStream<Path> files = Files.newDirectoryStream(place, "*" + JSON)) {
        for (Path each : files) {
          rows.add(read(GcRow.class, each));
        }
      }
    }
    rows.sort(Comparator.comparing(GcRow::of, ORDER).thenComparing(GcRow::fork));
    return List.copyOf(rows);
  }

  /** The row of a run of a case, if it is there. */
  Optional<GcRow> row(GcCase of, int fork) throws IOException {
    Path file = file(of, fork);
    return Files.exists(file) ? Optional.of(read(GcRow.class, file)) : Optional.empty();
  }

  /**
   * Keeps a row, in place of the one of the same run.
   *
   * @throws IOException if it cannot be written; nothing is left then
   */
  public void write(GcRow row) throws IOException {
    write(file(row.of(), row.fork()), RecordJson.write(row));
  }

  /**
   * Rows as text.
   *
   * @throws IOException if they cannot be told as JSON
   */
  public static String json(List<GcRow> rows) throws IOException {
    return RecordJson.write(rows);
  }

  /** The smallest heap that a workload was found to run in, if it was looked for. */
  Optional<SmallestHeap> smallestHeap(Workload workload, int scratchBytes) throws IOException {
    Path file = heapFile(workload, scratchBytes);
    return Files.exists(file) ? Optional.of(read(SmallestHeap.class, file)) : Optional.empty();
  }

  /**
   * Keeps the smallest heap of a workload.
   *
   * @throws IOException if it cannot be written; nothing is left then
   */
  public void write(SmallestHeap heap) throws IOException {
    write(heapFile(heap.workload(), heap.scratchBytes()), RecordJson.write(heap));
  }

  private Path heapFile(Workload workload, int scratchBytes) {
    return folder.resolve("heaps").resolve(workload + "-" + scratchBytes + JSON);
  }

  private Path file(GcCase of, int fork) {
    String name =
        String.format(
            Locale.ROOT,
            "%s-%s-%s-%s-%d-%s-%d",
            of.java(),
            of.collector(),
            of.policy(),
            of.workload(),
            of.scratchBytes(),
            of.heapFactor(),
            fork);
    return folder.resolve(ROWS).resolve(name + JSON);
  }

  private static <R extends Record> R read(Class<R> type, Path file) throws IOException {
    try {
      return RecordJson.read(type, Files.readString(file));
    } catch (IOException e) {
      throw new IOException("file of a study must be readable: file=" + file + ", cause=" + e, e);
    }
  }

  private static void write(Path file, String text) throws IOException {
    Files.createDirectories(file.getParent());
    Path part = Files.createTempFile(file.getParent(), "row", ".part");
    try {
      Files.writeString(part, text);
      Files.move(part, file, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
    } finally {
      Files.deleteIfExists(part);
    }
  }
}
