package org.hdispatch.porous.survey;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hdispatch.porous.io.CsvLine;
import org.hdispatch.porous.io.ImageFileException;

/**
 * The rows of a survey to look at, all its shards joined; nothing is held, and another process may
 * be writing. It may be of another version: which figures there are, its header says.
 *
 * @param folder where it lies
 * @param settings what the rows depend on
 * @param rows what was found, in the order of the jobs
 */
public record SurveyTable(Path folder, SurveySettings settings, List<SurveyRow> rows) {
  /** Keeps a copy of the rows. */
  public SurveyTable {
    rows = List.copyOf(rows);
  }

  /**
   * Reads {@code survey.csv} and {@code survey.properties}.
   *
   * @throws ImageFileException if one of them is not there, cannot be read, or is something else
   */
  public static SurveyTable read(Path folder) throws ImageFileException {
    Path file = folder.resolve(Shard.WHOLE.fileName() + ".csv");
    Path properties = folder.resolve(Shard.WHOLE.fileName() + ".properties");
    if (!Files.isRegularFile(file) || !Files.isRegularFile(properties)) {
      throw new ImageFileException(
          "folder must hold a survey (survey.csv, survey.properties; shards are joined by survey"
              + " --collect): folder="
              + folder);
    }
    try {
      Optional<SurveySettings> settings = SurveySettings.parse(Files.readString(properties));
      if (settings.isEmpty()) {
        throw new ImageFileException("settings must be whole: file=" + properties);
      }
      List<String> columns = columns(file);
      return new SurveyTable(
          folder,
          settings.get(),
          RowFile.read(file, columns).lines().values().stream()
              .map(line -> SurveyRow.parse(columns, CsvLine.parse(line)))
              .toList());
    } catch (IllegalArgumentException | IOException e) {
      throw e instanceof ImageFileException known
          ? known
          : new ImageFileException(
              "rows must be those of a survey: file=" + file + ", cause=" + e.getMessage(), e);
    }
  }

  private static List<String> columns(Path file) throws IOException {
    try (BufferedReader lines = Files.newBufferedReader(file)) {
      String header = lines.readLine();
      List<String> columns = header == null ? List.of() : CsvLine.parse(header);
      if (!columns.equals(SurveyRow.columns(SurveyRow.figuresOf(columns)))) {
        throw new IllegalArgumentException("columns must be those of a survey: header=" + header);
      }
      return columns;
    }
  }
}
