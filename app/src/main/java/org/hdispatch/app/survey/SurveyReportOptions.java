package org.hdispatch.app.survey;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.survey.GivenPoint;
import org.hdispatch.porous.survey.ReferenceBand;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Which surveys are reported, and what is laid beside them. */
final class SurveyReportOptions {
  private static final String NONE = "none";

  @Parameters(
      arity = "1..*",
      paramLabel = "SURVEY_DIR",
      description =
          "Folders of surveys (their --output): of several images, of one in blocks of several"
              + " sizes, by either method. Default: none, at least one must be given.")
  private List<Path> folders;

  @Option(
      names = "--label",
      paramLabel = "TEXT",
      description =
          "What the rock of a survey is called: once for each SURVEY_DIR, in their order. Default:"
              + " the file of its image.")
  private List<String> labels;

  @Option(
      names = "--band",
      paramLabel = "BAND",
      split = ",",
      hideParamSyntax = true,
      defaultValue = "lucia,fontainebleau",
      completionCandidates = Choices.OfBands.class,
      description =
          "Reference bands to draw: ${COMPLETION-CANDIDATES}, several of them, or none. Lucia: rock"
              + " fabrics of carbonates. Fontainebleau: the trend of that sandstone.")
  private List<String> bands;

  @Option(
      names = "--points",
      paramLabel = "FILE.csv",
      description =
          "Points from elsewhere to draw beside: columns label, porosity, and permeability_mD or"
              + " permeability_voxel2 with voxel_edge_m; where they are of a block of a survey also"
              + " block and axis, and if need be size (its edge, voxels) and image. Default: none.")
  private List<Path> points;

  @Option(
      names = "--image",
      paramLabel = "FILE",
      description =
          "Where the image of a survey lies, for slices. Default: a file of its name in the folder"
              + " of the survey, beside that, or here; without one there are no slices.")
  private List<Path> images;

  @Option(
      names = "--porosity-sizes",
      description =
          "Also read the whole images, and say how porosity spreads in cubes of 8, 16, 32 ..."
              + " voxels: takes no flow.")
  private boolean porositySizes;

  List<Path> folders() {
    return List.copyOf(folders);
  }

  /**
   * What the rocks are called, if that is given.
   *
   * @throws UsageException if there are not as many as surveys
   */
  List<String> labels() {
    if (labels != null && labels.size() != folders.size()) {
      throw new UsageException(
          "--label must come once for each survey: labels="
              + labels.size()
              + ", surveys="
              + folders.size());
    }
    return labels == null ? List.of() : List.copyOf(labels);
  }

  /**
   * The bands, each once.
   *
   * @throws UsageException if one is not known, or none comes with others
   */
  List<ReferenceBand> bands() {
    if (bands.equals(List.of(NONE))) {
      return List.of();
    }
    List<ReferenceBand> all = new ArrayList<>();
    for (String word : bands) {
      ReferenceBand band = null;
      for (ReferenceBand each : ReferenceBand.values()) {
        band = Choices.word(each).equalsIgnoreCase(word) ? each : band;
      }
      if (band == null) {
        throw new UsageException(
            "--band must be some of lucia, fontainebleau, or none alone: --band="
                + String.join(",", bands));
      }
      if (!all.contains(band)) {
        all.add(band);
      }
    }
    return all;
  }

  /** The points of all files. */
  List<GivenPoint> points() throws ImageFileException {
    List<GivenPoint> all = new ArrayList<>();
    for (Path file : points == null ? List.<Path>of() : points) {
      all.addAll(GivenPoint.read(file));
    }
    return all;
  }

  List<Path> images() {
    return images == null ? List.of() : List.copyOf(images);
  }

  boolean porositySizes() {
    return porositySizes;
  }
}
