package org.hdispatch.porous.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class ReferenceBandTest {
  private static ReferenceBand.Curve curve(ReferenceBand band, String name) {
    return band.curves().stream()
        .filter(each -> each.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  /** At L = 1 all terms in log L vanish; the others were worked out by hand from the formula. */
  @Test
  void luciaFollowsTheGlobalTransform() {
    assertEquals(
        Math.pow(10, 9.7982 - 8.6711), // mD
        curve(ReferenceBand.LUCIA, "L = 1").permeability(0.1),
        1e-9);
    ReferenceBand.Curve four = curve(ReferenceBand.LUCIA, "L = 4");
    assertEquals(0.070, four.permeability(0.10), 5e-4);
    assertEquals(0.90, four.permeability(0.20), 5e-3);
    assertEquals(3.99, four.permeability(0.30), 5e-3);
    assertEquals(
        List.of("L = 1", "L = 2", "L = 3", "L = 4"),
        ReferenceBand.LUCIA.curves().stream().map(ReferenceBand.Curve::name).toList());
  }

  @Test
  void fontainebleauHasTwoLawsThatMeetWhereTheyCross() {
    ReferenceBand.Curve trend = curve(ReferenceBand.FONTAINEBLEAU, "Fontainebleau");
    assertEquals(0.303 * Math.pow(20, 3.05), trend.permeability(0.20), 1e-6); // mD
    assertEquals(2.75e-5 * Math.pow(5, 7.33), trend.permeability(0.05), 1e-9);
    double cross = Math.pow(0.303 / 2.75e-5, 1 / (7.33 - 3.05)); // percent
    assertEquals(8.8, cross, 0.01);
    assertEquals(0.303 * Math.pow(cross, 3.05), trend.permeability(cross / 100), 1e-6);
    assertTrue(trend.reaches(0.02) && trend.reaches(0.30));
    assertFalse(trend.reaches(0.019) || trend.reaches(0.31));
  }

  @Test
  void everyBandSaysWhereItComesFrom() {
    assertTrue(ReferenceBand.LUCIA.source().contains("Jennings & Lucia 2003"));
    assertTrue(ReferenceBand.FONTAINEBLEAU.source().contains("Bourbie & Zinszner 1985"));
  }
}
