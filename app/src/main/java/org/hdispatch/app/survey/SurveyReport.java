package org.hdispatch.app.survey;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Optional;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.OutputOptions;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Table;
import org.hdispatch.porous.block.BlockColumns;
import org.hdispatch.porous.io.CsvLine;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.io.WholeFiles;
import org.hdispatch.porous.survey.SurveyFiles;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveyStatus;

/**
 * Tells what a survey found. Rows are read and told one at a time, as there may be a million.
 *
 * @param files the rows
 * @param jobs how many there should be
 * @param output in which form
 * @param console where to
 */
record SurveyReport(SurveyFiles files, int jobs, OutputOptions output, CommandConsole console) {
  /** What takes a row, which may fail. */
  private interface Taker {
    void take(SurveyRow row) throws IOException;
  }

  /**
   * Writes the files for programs and of the tensors, prints the summary, and returns the exit
   * code.
   */
  int tell() throws ImageFileException {
    SurveySummary summary = new SurveySummary(jobs);
    files.forEachRow(summary::add);
    WholeFiles.writeLines(files.jsonFile(), out -> json(summary, out));
    if (summary.tensors() > 0) {
      WholeFiles.writeLines(files.tensorFile(), this::tensorCsv);
      WholeFiles.writeLines(files.tensorJsonFile(), this::tensorJson);
    }
    print(summary);
    int failed = summary.count(SurveyStatus.FAILED);
    int unsteady = summary.count(SurveyStatus.NOT_CONVERGED);
    if (failed + unsteady == 0) {
      return ExitCode.DONE.code();
    }
    console
        .err()
        .println(
            "hdispatch: every block must have a converged k (its row says why not): failed="
                + failed
                + ", not converged="
                + unsteady
                + ", file="
                + files.file());
    return ExitCode.NOT_CONVERGED.code();
  }

  private void print(SurveySummary summary) throws ImageFileException {
    try {
      switch (output.form()) {
        case JSON -> json(summary, console.out());
        case CSV -> csv(console.out());
        case TEXT -> console.out().print(text(summary));
      }
    } catch (IOException e) {
      throw e instanceof ImageFileException known
          ? known
          : new ImageFileException("standard output must be writable", e);
    }
    console.print(""); // which looks whether all could be printed
  }

  private String text(SurveySummary summary) {
    Table table = summary.table();
    table.line("rows", files.file().toString()).line("", files.jsonFile().toString());
    if (summary.tensors() > 0) {
      table
          .line("tensors", files.tensorFile().toString())
          .line("", files.tensorJsonFile().toString());
    }
    table
        .line("times", files.timesFile().toString())
        .line("settings", files.settingsFile().toString())
        .line("to draw them", "./hdispatch survey-report " + folder() + " --output report");
    return table.toString();
  }

  private Path folder() {
    return files.file().getParent();
  }

  /** A JSON object of what sums up, {@code summary}, and the {@code rows} themselves. */
  private void json(SurveySummary summary, Appendable out) throws IOException {
    out.append("{\n\"summary\": ").append(summary.row().toJson().stripTrailing());
    out.append(",\n\"rows\": [");
    String[] before = {"\n"};
    each(
        row -> {
          out.append(before[0]).append(SurveyColumns.flat(row).toJson().stripTrailing());
          before[0] = ",\n";
        });
    out.append("\n]\n}\n");
  }

  private void csv(Appendable out) throws IOException {
    out.append(CsvLine.format(SurveyRow.columns(BlockColumns.FIGURES))).append('\n');
    each(
        row ->
            out.append(CsvLine.format(row.format(SurveyRow.columns(BlockColumns.FIGURES))))
                .append('\n'));
  }

  private void tensorCsv(Appendable out) throws IOException {
    SurveyTensors tensors = new SurveyTensors();
    each(
        row -> {
          Optional<FlatRow> tensor = tensors.add(row);
          if (tensor.isPresent()) {
            String lines = tensor.get().toCsv(); // a header and one row
            out.append(tensors.blocks() == 1 ? lines : lines.substring(lines.indexOf('\n') + 1));
          }
        });
  }

  private void tensorJson(Appendable out) throws IOException {
    SurveyTensors tensors = new SurveyTensors();
    out.append('[');
    each(
        row -> {
          Optional<FlatRow> tensor = tensors.add(row);
          if (tensor.isPresent()) {
            out.append(tensors.blocks() == 1 ? "\n" : ",\n");
            out.append(tensor.get().toJson().stripTrailing());
          }
        });
    out.append("\n]\n");
  }

  private void each(Taker taker) throws IOException {
    try {
      files.forEachRow(
          row -> {
            try {
              taker.take(row);
            } catch (IOException e) {
              throw new UncheckedIOException(e);
            }
          });
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }
}
