package org.hdispatch.app.survey.page;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.porous.io.CsvLine;
import org.hdispatch.porous.io.ImageFileException;

/**
 * Some columns of a table that lies beside the rows of a survey, as other commands write them.
 *
 * @param title what it holds
 * @param head names of the columns
 * @param rows values, a text for each column
 */
record TableBeside(String title, List<String> head, List<List<String>> rows) {
  private static final int DIGITS = 3;

  /** Which tables there may be: file, what it holds, columns. */
  private enum Known {
    TENSOR(
        "survey-tensor.csv",
        "Permeability tensors of the blocks (off the diagonal only with periodic sides)",
        "block",
        "permeability_xx_voxel2",
        "permeability_yy_voxel2",
        "permeability_zz_voxel2",
        "permeability_xy_voxel2",
        "permeability_xz_voxel2",
        "permeability_yz_voxel2",
        "asymmetry",
        "principal_1_mD",
        "principal_2_mD",
        "principal_3_mD",
        "anisotropy",
        "diagonal_ratio"),
    UPSCALED(
        "upscale.csv",
        "Permeability of the whole, by Darcy's law between the blocks, and its bounds",
        "axis",
        "permeability_mD",
        "columns_mD",
        "layers_mD",
        "harmonic_mD",
        "arithmetic_mD",
        "blocks",
        "left_out",
        "does_not_percolate",
        "not_converged");

    final String file;
    final String title;
    final List<String> columns;

    Known(String file, String title, String... columns) {
      this.file = file;
      this.title = title;
      this.columns = List.of(columns);
    }
  }

  /**
   * All tables that lie in a folder.
   *
   * @throws ImageFileException if one cannot be read, or is something else
   */
  static List<TableBeside> of(Path folder) throws ImageFileException {
    List<TableBeside> found = new ArrayList<>();
    for (Known each : Known.values()) {
      Path file = folder.resolve(each.file);
      if (Files.isRegularFile(file)) {
        read(file, each).ifPresent(found::add);
      }
    }
    return found;
  }

  private static Optional<TableBeside> read(Path file, Known known) throws ImageFileException {
    List<List<String>> all = new ArrayList<>();
    try {
      for (String line : Files.readAllLines(file)) {
        all.add(CsvLine.parse(line));
      }
    } catch (IllegalArgumentException | IOException e) {
      throw new ImageFileException("table must be readable: file=" + file + ", cause=" + e, e);
    }
    List<String> head = all.isEmpty() ? List.of() : all.get(0);
    List<List<String>> lines = all.isEmpty() ? List.of() : all.subList(1, all.size());
    if (lines.stream().anyMatch(line -> line.size() != head.size())) {
      throw new ImageFileException("lines must have as many values as the header: file=" + file);
    }
    List<Integer> shown =
        known.columns.stream()
            .map(head::indexOf)
            .filter(at -> at >= 0 && lines.stream().anyMatch(line -> !line.get(at).isEmpty()))
            .toList();
    if (shown.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new TableBeside(
            known.title,
            shown.stream().map(at -> words(head.get(at))).toList(),
            lines.stream()
                .map(line -> shown.stream().map(at -> value(line.get(at))).toList())
                .toList()));
  }

  /** {@code permeability_xx_voxel2} as {@code k xx, voxel²}. */
  private static String words(String column) {
    return column
        .replace("permeability", "k")
        .replaceFirst("_mD$", ", mD")
        .replaceFirst("_voxel2$", ", voxel\u00b2")
        .replace('_', ' ');
  }

  private static String value(String text) {
    return text.matches("-?\\d+\\.\\d+(E-?\\d+)?")
        ? Numbers.significant(Double.parseDouble(text), DIGITS)
        : text;
  }
}
