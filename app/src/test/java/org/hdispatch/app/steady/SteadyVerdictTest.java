package org.hdispatch.app.steady;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.hdispatch.porous.flow.Approach;
import org.hdispatch.porous.flow.FlowOptions;
import org.junit.jupiter.api.Test;

class SteadyVerdictTest {
  private static final SteadyCourse FAST =
      SteadyCourses.course(Approach.CORRECTED, 1, 0.1, 5e-4, 1e-5, 1e-5);
  private static final SteadyCourse SLOW =
      SteadyCourses.course(Approach.PLAIN, 4, 0.5, 0.4, 0.3, 0.1, 3e-3, 5e-4, 1e-5);
  private static final SteadyCourse NEVER =
      SteadyCourses.course(Approach.PLAIN, -1, 0.5, 0.4, 0.3, 0.2);

  private static SteadyVerdict verdict(SteadyComparison... rocks) {
    return new SteadyVerdict(
        new SteadyResult(FlowOptions.DEFAULT.withMaxSteps(70), 2, List.of(rocks)));
  }

  @Test
  void numbersAreThoseOfTheCourses() {
    SteadyVerdict verdict =
        verdict(SteadyCourses.rock(2, FAST, SLOW), SteadyCourses.rock(5, FAST, NEVER));
    assertEquals(2, verdict.arrivals(Approach.CORRECTED).size());
    assertEquals(20, verdict.arrivals(Approach.CORRECTED).get(0).step());
    assertEquals(1, verdict.arrivals(Approach.PLAIN).size());
    assertEquals(60, verdict.arrivals(Approach.PLAIN).get(0).step());
    assertArrayEquals(new double[] {3}, verdict.stepsRatios(), 1e-12);
    assertArrayEquals(new double[] {3}, verdict.secondsRatios(), 1e-12);
    assertEquals(1, verdict.stops(Approach.PLAIN).size());
    assertArrayEquals(new double[] {3e-3}, verdict.errorsAtStop(Approach.PLAIN), 1e-12);
    assertEquals(1, verdict.stopsTooSoon()); // 3e-3 at a tolerance of 1e-3
  }

  @Test
  void sentencesSayWhatTheNumbersSay() {
    List<String> said =
        verdict(SteadyCourses.rock(2, FAST, SLOW), SteadyCourses.rock(5, FAST, NEVER)).sentences();
    assertEquals(
        "Until k stays within 0.1 % of its steady value, the corrected approach takes 20 steps and"
            + " 0.2 s; plain stepping takes 60 steps and 0.6 s (in 1 of 2 rocks it is not there"
            + " after 70 steps).",
        said.get(0));
    assertTrue(said.get(1).contains("takes 3 times the steps"), said.get(1));
    assertEquals(
        "The tightest rock, of porosity 0.2, takes 20 steps corrected and 60 plain; the most open"
            + " one, of 0.5, 20 steps corrected and more than 40 plain.",
        said.get(2));
    assertTrue(said.get(3).contains("pressure takes 50 %"), said.get(3));
    assertTrue(said.get(4).contains("plain stepping after 50 steps and 0.5 s"), said.get(4));
    assertTrue(said.get(4).contains("when k is really 0.3 % off"), said.get(4));
    assertTrue(said.get(5).startsWith("It stopped too soon in 1 of the 3 runs"), said.get(5));
    assertTrue(said.get(6).endsWith("of the same value in 1 of 2 rocks."), said.get(6));
  }

  @Test
  void sentencesSayWhereTheCorrectedApproachLoses() {
    SteadyCourse late = SteadyCourses.course(Approach.CORRECTED, 2, 0.1, 0.1, 1e-5);
    SteadyCourse soon = SteadyCourses.course(Approach.PLAIN, 1, 0.1, 1e-5);
    List<String> said = verdict(SteadyCourses.rock(2, late, soon)).sentences();
    assertTrue(said.get(1).contains("takes 0.67 times the steps"), said.get(1));
    assertTrue(said.get(1).endsWith("; in the rock it is there sooner."), said.get(1));
    String all = String.join("\n", said);
    assertTrue(all.contains("It never stopped too soon: in all 2 runs"), all);
  }

  @Test
  void sentencesDoWithoutArrivals() {
    SteadyCourse not = SteadyCourses.course(Approach.CORRECTED, -1, 0.1, 0.1);
    List<String> said = verdict(SteadyCourses.rock(2, not, NEVER)).sentences();
    assertTrue(
        said.get(0).contains("more than it was given: in the rock it is not there after 70 steps"),
        said.get(0));
    String all = String.join("\n", said);
    assertTrue(all.contains("ends the corrected approach in no rock"), all);
    assertTrue(!all.contains("times the steps") && !all.contains("pressure takes"), all);
  }
}
