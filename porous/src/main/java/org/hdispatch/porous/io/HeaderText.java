package org.hdispatch.porous.io;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * The lines of text that a file begins with.
 *
 * @param lines the lines, without their ends
 * @param end where the next byte stands, if the last line was met before the file ended
 */
record HeaderText(List<String> lines, Optional<Long> end) {
  private static final int MOST_BYTES = 1 << 20;

  /**
   * Reads up to the last line of a header.
   *
   * @param file the file
   * @param last whether a line is the last
   */
  static HeaderText read(Path file, Predicate<String> last) throws ImageFileException {
    ImageFiles.requireReadable(file);
    List<String> lines = new ArrayList<>();
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
      for (long at = 1; at <= MOST_BYTES; at++) {
        int next = in.read();
        if (next >= 0 && next != '\n') {
          line.write(next);
          continue;
        }
        String text = line.toString(StandardCharsets.UTF_8).stripTrailing();
        line.reset();
        lines.add(text);
        if (next >= 0 && last.test(text)) {
          return new HeaderText(lines, Optional.of(at));
        } else if (next < 0) {
          boolean whole = last.test(text) && !text.isEmpty(); // its end is that of the file
          return new HeaderText(lines, whole ? Optional.of(at - 1) : Optional.empty());
        }
      }
    } catch (IOException e) {
      throw ImageFiles.unreadable(file, e);
    }
    throw new ImageFileException(
        "header must end within "
            + MOST_BYTES
            + " bytes (is this the right format?): file="
            + file);
  }
}
