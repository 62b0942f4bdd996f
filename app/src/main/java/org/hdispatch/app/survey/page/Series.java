package org.hdispatch.app.survey.page;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveyStatus;
import org.hdispatch.porous.survey.SurveyTable;

/**
 * A survey that is reported, and what it is called.
 *
 * @param rock what its image is called
 * @param table its rows
 */
public record Series(String rock, SurveyTable table) {
  private static final String SPH = "sph";

  /** What a setting says; empty if it says nothing. */
  String setting(String name) {
    return table.settings().values().getOrDefault(name, "");
  }

  /** The image as the survey calls it. */
  String image() {
    return setting("image");
  }

  /** Whether flows were computed by particles. */
  boolean isOfParticles() {
    return setting("method").equals(SPH);
  }

  /** Size of the blocks: {@code 128³}, or {@code 128 × 64 × 64}. */
  String blockWords() {
    List<String> lengths = List.of(setting("block").split(","));
    return lengths.stream().distinct().count() == 1
        ? lengths.get(0) + "\u00b3"
        : String.join(" \u00d7 ", lengths);
  }

  /** What it is called in legends. */
  String name() {
    return rock + ", " + blockWords() + ", " + setting("method").toUpperCase(Locale.ROOT);
  }

  /** Whether another survey is of the same rock. */
  boolean isOfRockOf(Series other) {
    return image().equals(other.image())
        && setting("image_size").equals(other.setting("image_size"));
  }

  /**
   * Whether another one is of the same rock and computed in the same way, so that only the blocks
   * may differ.
   */
  boolean isLike(Series other) {
    return isOfRockOf(other)
        && List.of("method", "sides", "inlet", "refine", "pore_values").stream()
            .allMatch(each -> setting(each).equals(other.setting(each)));
  }

  /** Rows that are drawn: with a permeability above 0. */
  List<SurveyRow> drawn() {
    return table.rows().stream().filter(row -> permeability(row) > 0 && porosity(row) > 0).toList();
  }

  /** Rows that are drawn and may be relied on. */
  List<SurveyRow> converged() {
    return drawn().stream().filter(row -> row.status() == SurveyStatus.DONE).toList();
  }

  /** Voxels of a block. */
  double blockVoxels() {
    return table.rows().stream().mapToDouble(row -> row.job().box().voxels()).max().orElse(0);
  }

  static double porosity(SurveyRow row) {
    return row.number("porosity").orElse(0);
  }

  /** Permeability, mD; 0 if there is none. */
  static double permeability(SurveyRow row) {
    return row.number("permeability_mD").orElse(0);
  }

  /** The settings in the order of the file. */
  Map<String, String> settings() {
    return table.settings().values();
  }
}
