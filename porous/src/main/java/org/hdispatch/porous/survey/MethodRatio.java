package org.hdispatch.porous.survey;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** How permeabilities of the same boxes and axes compare that two surveys found. */
public final class MethodRatio {
  private MethodRatio() {}

  /**
   * Permeabilities of some rows over those of others, where both have one that converged.
   *
   * @param rows the rows
   * @param others what they are compared with, of the same image
   */
  public static Spread of(List<SurveyRow> rows, List<SurveyRow> others) {
    Map<String, Double> known = new HashMap<>();
    for (SurveyRow row : others) {
      if (row.status() == SurveyStatus.DONE) {
        row.number("permeability_mD").ifPresent(k -> known.put(place(row), k));
      }
    }
    List<Double> ratios = new ArrayList<>();
    for (SurveyRow row : rows) {
      if (row.status() == SurveyStatus.DONE && known.containsKey(place(row))) {
        row.number("permeability_mD").ifPresent(k -> ratios.add(k / known.get(place(row))));
      }
    }
    return Spread.of(ratios.stream().mapToDouble(Double::doubleValue).toArray());
  }

  private static String place(SurveyRow row) {
    return row.job().box() + "," + row.job().axis();
  }
}
