package org.hdispatch.app;

import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.app.text.Table;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.survey.Spread;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveyStatus;

/**
 * What the rows of a survey come to. Permeabilities are those of the blocks that percolate and
 * converged; how many do not percolate is said beside them.
 *
 * @param jobs all jobs of the survey
 * @param rows those that are there
 */
record SurveySummary(int jobs, List<SurveyRow> rows) {
  private static final int DIGITS = 4;

  int count(SurveyStatus status) {
    return (int) rows.stream().filter(row -> row.status() == status).count();
  }

  /** The spread of the permeabilities along an axis, mD, or along all. */
  private Spread permeability(Optional<Axis> axis) {
    return spread(
        "permeability_mD",
        row ->
            row.status() == SurveyStatus.DONE
                && (axis.isEmpty() || row.job().axis() == axis.get()));
  }

  /** The spread of the porosities of the blocks, each block once. */
  private Spread porosity() {
    TreeMap<Long, Double> porosities = new TreeMap<>();
    for (SurveyRow row : rows) {
      row.number("porosity").ifPresent(each -> porosities.put(row.job().block(), each));
    }
    return Spread.of(porosities.values().stream().mapToDouble(Double::doubleValue).toArray());
  }

  private Spread spread(String column, Predicate<SurveyRow> wanted) {
    return Spread.of(
        rows.stream().filter(wanted).flatMapToDouble(row -> row.number(column).stream()).toArray());
  }

  private List<Axis> axes() {
    return rows.stream().map(row -> row.job().axis()).distinct().sorted().toList();
  }

  /** For programs. */
  FlatRow row() {
    FlatRow row =
        new FlatRow()
            .put("jobs", jobs)
            .put("blocks", rows.stream().map(each -> each.job().block()).distinct().count())
            .put("rows", rows.size());
    for (SurveyStatus status : SurveyStatus.values()) {
      row.put(status.word().replace('-', '_'), count(status));
    }
    put(row, "porosity", "", porosity());
    put(row, "permeability_mD", "", permeability(Optional.empty()));
    for (Axis axis : axes()) {
      put(row, "permeability_mD", "_" + Choices.word(axis), permeability(Optional.of(axis)));
    }
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
    table.line("jobs", rows.size() + " of " + jobs + " have a row");
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
      Spread found = permeability(Optional.of(axis));
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
    return table;
  }
}
