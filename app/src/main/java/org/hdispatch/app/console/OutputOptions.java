package org.hdispatch.app.console;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hdispatch.app.text.FlatRow;
import picocli.CommandLine.Option;

/** Where the result goes, and in which form. */
public final class OutputOptions {
  @Option(names = "--json", description = "Print the result as flat JSON.")
  private boolean json;

  @Option(names = "--csv", description = "Print the result as CSV with a header.")
  private boolean csv;

  @Option(
      names = "--output",
      paramLabel = "DIR",
      description = "Also write files to this folder, made if missing. Default: none.")
  private Path folder;

  @Option(names = "--quiet", description = "No progress and no warnings on standard error.")
  private boolean quiet;

  /**
   * The folder for files, if one is asked for.
   *
   * @throws UsageException if two forms are asked for
   */
  public Optional<Path> folder() {
    if (json && csv) {
      throw new UsageException("--json and --csv must not be combined");
    }
    if (folder != null && folder.toString().isEmpty()) {
      throw new UsageException("--output must name a folder: --output=");
    }
    return Optional.ofNullable(folder);
  }

  /** Whether neither progress nor warnings are wanted. */
  public boolean quiet() {
    return quiet;
  }

  /** The result in the form asked for. */
  public String form(FlatRow row, String text) {
    return json ? row.toJson() : csv ? row.toCsv() : text;
  }

  /** Forms of a result. */
  public enum Form {
    /** For people. */
    TEXT,
    /** For programs. */
    JSON,
    /** For tables. */
    CSV
  }

  /** The form asked for. */
  public Form form() {
    return json ? Form.JSON : csv ? Form.CSV : Form.TEXT;
  }

  /** Several results and what sums them up, in the form asked for; as CSV, the results alone. */
  public String form(FlatRow summary, List<FlatRow> rows, String text) {
    return json ? FlatRow.toJson(summary, rows) : form(rows, text);
  }

  /** Several results in the form asked for. */
  public String form(List<FlatRow> rows, String text) {
    return json ? FlatRow.toJson(rows) : csv ? FlatRow.toCsv(rows) : text;
  }
}
