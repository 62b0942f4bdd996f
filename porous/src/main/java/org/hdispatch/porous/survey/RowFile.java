package org.hdispatch.porous.survey;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.hdispatch.porous.io.CsvLine;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.io.WholeFiles;

/**
 * A table in a file that only grows, row by row: a header, then lines that begin with the number of
 * a job. If a job comes twice, its last line counts.
 *
 * <p>A line is written in one piece and forced to the disk. So whatever ends the process, all lines
 * are whole but possibly the last one; that one has no line end, and is cut off when the file is
 * opened again.
 */
final class RowFile {
  private final Path file;
  private final List<String> columns;
  private final TreeMap<Integer, String> lines = new TreeMap<>();

  private RowFile(Path file, List<String> columns) {
    this.file = file;
    this.columns = List.copyOf(columns);
  }

  /**
   * Opens a file to go on with it; makes it if it is not there, and cuts off a torn last line.
   *
   * @throws ImageFileException if it cannot be read or written, or holds another table
   */
  static RowFile open(Path file, List<String> columns) throws ImageFileException {
    RowFile opened = new RowFile(file, columns);
    try {
      long whole = opened.load();
      if (whole == 0) {
        opened.write(opened.header(), false);
      } else {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
          channel.truncate(whole);
        }
      }
      return opened;
    } catch (IOException e) {
      throw failed(file, e);
    }
  }

  /**
   * Reads a file as it is, which another process may be writing to.
   *
   * @throws ImageFileException if it cannot be read, or holds another table
   */
  static RowFile read(Path file, List<String> columns) throws ImageFileException {
    RowFile read = new RowFile(file, columns);
    try {
      read.load();
      return read;
    } catch (IOException e) {
      throw failed(file, e);
    }
  }

  private static ImageFileException failed(Path file, IOException e) {
    return e instanceof ImageFileException known
        ? known
        : new ImageFileException("rows must be kept: file=" + file + ", cause=" + e, e);
  }

  private String header() {
    return CsvLine.format(columns) + "\n";
  }

  /** Takes in all whole lines; returns how many bytes they have. */
  private long load() throws IOException {
    if (!Files.exists(file)) {
      return 0;
    }
    long whole = 0;
    int at = 0;
    try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
      ByteArrayOutputStream line = new ByteArrayOutputStream();
      for (int next = in.read(); next >= 0; next = in.read()) {
        if (next != '\n') {
          line.write(next);
          continue;
        }
        whole += line.size() + 1;
        at++;
        take(line.toString(StandardCharsets.UTF_8), at);
        line.reset();
      }
    }
    return whole;
  }

  private void take(String line, int at) throws ImageFileException {
    if (at > 1) {
      keep(line, at);
    } else if (!header().equals(line + "\n")) {
      throw new ImageFileException(
          "table must have the columns of this version (move it away to begin anew): file=" + file);
    }
  }

  private void keep(String line, int at) throws ImageFileException {
    try {
      List<String> values = CsvLine.parse(line);
      if (values.size() != columns.size()) {
        throw new IllegalArgumentException("values=" + values.size());
      }
      lines.put(Integer.parseInt(values.get(0)), line);
    } catch (IllegalArgumentException e) {
      throw new ImageFileException(
          "line must hold a job and "
              + columns.size()
              + " values (take it out, and the job is done again): file="
              + file
              + ", line="
              + at,
          e);
    }
  }

  List<String> columns() {
    return columns;
  }

  /** The numbers of the jobs, and their lines, in rising order. */
  Map<Integer, String> lines() {
    return lines;
  }

  /**
   * Adds a row; when this returns, it is on the disk.
   *
   * @param values a value for each column, the number of the job first
   */
  void append(List<String> values) throws ImageFileException {
    String line = CsvLine.format(values);
    try {
      write(line + "\n", true);
    } catch (IOException e) {
      throw failed(file, e);
    }
    lines.put(Integer.parseInt(values.get(0)), line);
  }

  /** Not by a channel: an interruption would close it, and lose a row that is done. */
  private void write(String text, boolean append) throws IOException {
    try (FileOutputStream out = new FileOutputStream(file.toFile(), append)) {
      out.write(text.getBytes(StandardCharsets.UTF_8));
      out.getFD().sync();
    }
  }

  /** Takes in a line of another table of the same columns; it is not written yet. */
  void take(int job, String line) {
    lines.put(job, line);
  }

  /** Writes the file anew: each job once, in rising order. It is whole or as before. */
  void sort() throws ImageFileException {
    WholeFiles.writeLines(
        file,
        out -> {
          out.append(header());
          for (String line : lines.values()) {
            out.append(line).append('\n');
          }
        });
  }
}
