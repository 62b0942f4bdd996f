package org.hdispatch.app.survey;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.app.text.Table;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.survey.Spread;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveyStatus;

/**
 * What the rows of a survey come to. Permeabilities are those of the blocks that percolate and
 * converged; how many do not percolate is said beside them.
 */
final class SurveySummary {
  private static final int DIGITS = 4;
  private static final long NONE = -1;

  private final int jobs;
  private final SurveyTensors tensors = new SurveyTensors();
  private final Map<SurveyStatus, Integer> statuses = new EnumMap<>(SurveyStatus.class);
  private final Map<Axis, List<Double>> permeabilities = new EnumMap<>(Axis.class); // mD
  private final List<Double> porosities = new ArrayList<>(); // of each block once
  private int rows;
  private int blocks;
  private long block = NONE; // of the last row
  private long porous = NONE; // the last block of which there is a porosity

  /**
   * The summary of no row yet.
   *
   * @param jobs all jobs of the survey
   */
  SurveySummary(int jobs) {
    this.jobs = jobs;
  }

  /** Takes in a row; they come in the order of their jobs, block by block. */
  void add(SurveyRow row) {
    rows++;
    tensors.add(row);
    long of = row.job().block();
    blocks += of == block ? 0 : 1;
    block = of;
    statuses.merge(row.status(), 1, Integer::sum);
    List<Double> along =
        permeabilities.computeIfAbsent(row.job().axis(), axis -> new ArrayList<>());
    if (row.status() == SurveyStatus.DONE) {
      row.number("permeability_mD").ifPresent(along::add);
    }
    if (of != porous) {
      row.number("porosity")
          .ifPresent(
              found -> {
                porosities.add(found);
                porous = of;
              });
    }
  }

  /** How many blocks have a permeability along all three axes. */
  int tensors() {
    return tensors.blocks();
  }

  int count(SurveyStatus status) {
    return statuses.getOrDefault(status, 0);
  }

  /** The spread of the permeabilities along an axis, mD. */
  private Spread permeability(Axis axis) {
    return spread(permeabilities.get(axis).stream());
  }

  private Spread porosity() {
    return spread(porosities.stream());
  }

  private static Spread spread(Stream<Double> values) {
    return Spread.of(values.mapToDouble(Double::doubleValue).toArray());
  }

  private Set<Axis> axes() {
    return permeabilities.keySet();
  }

  /** For programs. */
  FlatRow row() {
    FlatRow row = new FlatRow().put("jobs", jobs).put("blocks", blocks).put("rows", rows);
    for (SurveyStatus status : SurveyStatus.values()) {
      row.put(status.word().replace('-', '_'), count(status));
    }
    put(row, "porosity", "", porosity());
    put(row, "permeability_mD", "", spread(permeabilities.values().stream().flatMap(List::stream)));
    for (Axis axis : axes()) {
      put(row, "permeability_mD", "_" + Choices.word(axis), permeability(axis));
    }
    tensors.putInto(row);
    return row;
  }

  private static void put(FlatRow row, String what, String of, Spread spread) {
    row.put(what + "_count" + of, spread.count())
        .put(what + "_least" + of, spread.least())
        .put(what + "_median" + of, spread.median())
        .put(what + "_greatest" + of, spread.greatest())
        .put(what + "_arithmetic" + of, spread.arithmetic())
        .put(what + "_geometric" + of, spread.geometric())
        .put(what + "_harmonic" + of, spread.harmonic());
  }

  /** For people, less the files. */
  Table table() {
    Table table = new Table();
    table.line("jobs", rows + " of " + jobs + " have a row");
    table.line("done", count(SurveyStatus.DONE) + " percolate and have a permeability");
    for (SurveyStatus status :
        List.of(
            SurveyStatus.DOES_NOT_PERCOLATE,
            SurveyStatus.NOT_CONVERGED,
            SurveyStatus.OUTSIDE,
            SurveyStatus.FAILED)) {
      if (count(status) > 0) {
        table.line(status.word().replace('-', ' '), Integer.toString(count(status)));
      }
    }
    Spread porosity = porosity();
    if (porosity.count() > 0) {
      table.line(
          "porosity",
          "median "
              + Numbers.significant(porosity.median(), DIGITS)
              + ", "
              + Numbers.significant(porosity.least(), DIGITS)
              + " to "
              + Numbers.significant(porosity.greatest(), DIGITS));
    }
    for (Axis axis : axes()) {
      Spread found = permeability(axis);
      if (found.count() > 0) {
        table
            .line(
                "along " + Choices.word(axis),
                "median "
                    + Numbers.significant(found.median(), DIGITS)
                    + " mD, "
                    + Numbers.significant(found.least(), DIGITS)
                    + " to "
                    + Numbers.significant(found.greatest(), DIGITS)
                    + " mD in "
                    + found.count()
                    + " blocks")
            .line(
                "",
                "means: arithmetic "
                    + Numbers.significant(found.arithmetic(), DIGITS)
                    + ", geometric "
                    + Numbers.significant(found.geometric(), DIGITS)
                    + ", harmonic "
                    + Numbers.significant(found.harmonic(), DIGITS)
                    + " mD");
      }
    }
    tensors.putInto(table);
    return table;
  }
}
