package org.hdispatch.app.survey;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.app.console.OutputOptions;
import org.hdispatch.app.console.StandardOptions;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.app.draw.StudyPage.Photo;
import org.hdispatch.app.survey.page.CrossPlot;
import org.hdispatch.app.survey.page.Series;
import org.hdispatch.app.survey.page.SurveyPage;
import org.hdispatch.app.survey.page.SurveyStudy;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.survey.PorosityScale;
import org.hdispatch.porous.survey.SurveyTable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code hdispatch survey-report}: surveys as a figure, tables and a page. */
@Command(
    name = "survey-report",
    description = {
      "Lay surveys side by side: permeability against porosity over reference bands and beside"
          + " points from elsewhere, mean and spread by the size of the blocks, maps, and tables.",
      "--output writes figure5.svg and figure5.png, a page, survey-report.html, and what is drawn,"
          + " survey-report.csv and survey-report.json."
    })
public final class SurveyReportCommand implements Callable<Integer> {
  private static final String NAME = "survey-report";
  private static final String FIGURE = "figure5";

  private final Host host;

  @Mixin private final SurveyReportOptions options = new SurveyReportOptions();
  @Mixin private final OutputOptions output = new OutputOptions();
  @Mixin private final StandardOptions standard = new StandardOptions();
  @Spec private CommandSpec spec;

  /**
   * Makes the command.
   *
   * @param host what it runs in
   */
  public SurveyReportCommand(Host host) {
    this.host = host;
  }

  @Override
  public Integer call() throws ImageFileException {
    Optional<Path> to = output.folder();
    List<Series> series = series();
    for (Path image : options.images()) {
      if (series.stream().noneMatch(each -> SurveyImage.isNamed(image, each.table()))) {
        throw new UsageException("--image must be the image of a survey: file=" + image);
      }
      if (!Files.exists(image)) {
        throw new ImageFileException("image must exist: file=" + image);
      }
    }
    Map<String, List<Photo>> slices = new LinkedHashMap<>();
    Map<String, List<PorosityScale>> porosities = new LinkedHashMap<>();
    for (Series each : series) {
      if (!slices.containsKey(each.rock())) {
        Optional<SurveyImage> image = SurveyImage.find(each.table(), options.images(), host);
        if (image.isPresent()) {
          slices.put(each.rock(), image.get().slices());
          if (options.porositySizes()) {
            porosities.put(each.rock(), image.get().porosities());
          }
        } else {
          console().warn("image is not here, there are no slices (--image): rock=" + each.rock());
        }
      }
    }
    SurveyStudy report = new SurveyStudy(series, options.points(), options.bands(), porosities);
    if (to.isEmpty()) {
      print(report, List.of());
      return ExitCode.DONE.code();
    }
    try (OutputFolder folder = OutputFolder.open(to.get())) {
      print(report, write(report, slices, folder));
    }
    return ExitCode.DONE.code();
  }

  private List<Series> series() throws ImageFileException {
    List<String> labels = options.labels();
    List<Series> series = new ArrayList<>();
    for (Path folder : options.folders()) {
      SurveyTable table = SurveyTable.read(folder);
      String image = table.settings().values().getOrDefault("image", folder.toString());
      series.add(
          new Series(
              labels.isEmpty() ? image.replaceFirst(":/.*", "") : labels.get(series.size()),
              table));
    }
    return series;
  }

  private List<Path> write(SurveyStudy report, Map<String, List<Photo>> slices, OutputFolder folder)
      throws ImageFileException {
    List<String> beside = new ArrayList<>(List.of(NAME + ".csv", NAME + ".json"));
    List<FlatRow> rows = rows(report);
    folder.write(beside.get(0), FlatRow.toCsv(rows));
    folder.write(beside.get(1), FlatRow.toJson(rows));
    if (CrossPlot.hasPoints(report)) {
      CrossPlot figure = new CrossPlot(report);
      folder.write(FIGURE + ".svg", figure.svg());
      figure.pixels().write(folder.file(FIGURE + ".png"));
      beside.addAll(List.of(FIGURE + ".svg", FIGURE + ".png"));
    }
    List<String> given = spec.root().commandLine().getParseResult().originalArgs();
    folder.write(
        NAME + ".html",
        new SurveyPage(report, slices)
            .html("./hdispatch " + String.join(" ", given), List.copyOf(beside)));
    List<Path> files = new ArrayList<>(List.of(folder.file(NAME + ".html")));
    beside.forEach(each -> files.add(folder.file(each)));
    return files;
  }

  private static List<FlatRow> rows(SurveyStudy report) {
    return report.rows().stream().map(row -> new FlatRow().putAll(row)).toList();
  }

  private void print(SurveyStudy report, List<Path> files) throws ImageFileException {
    StringBuilder text = new StringBuilder();
    report.sentences().forEach(each -> text.append(each).append(System.lineSeparator()));
    files.forEach(each -> text.append("file: ").append(each).append(System.lineSeparator()));
    console().print(output.form(rows(report), text.toString()));
  }

  private CommandConsole console() {
    return new CommandConsole(spec, host, output.quiet());
  }
}
