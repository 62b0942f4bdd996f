package org.hdispatch.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class StudyScopeTest {
  private static final List<Jdk> JDKS =
      List.of(new Jdk(Path.of("a"), "17.0.15"), new Jdk(Path.of("b"), "25.0.3"));
  private static final int COLLECTORS = Collector.values().length;

  @Test
  void quickComparesTwoPoliciesOnEveryCollector() {
    List<GcCase> cases = StudyScope.QUICK.cases(JDKS);
    int epsilon = JDKS.size() * 2; // the tight heap, in which what the set-up leaves stays
    assertEquals(JDKS.size() * COLLECTORS * 2 * 2 - epsilon, cases.size());
    assertEquals(
        Set.of(ScratchPolicy.ENDURING, ScratchPolicy.PER_CELL),
        cases.stream().map(GcCase::policy).collect(Collectors.toSet()));
    for (int n = 0; n < cases.size(); n += 2) { // compared, so neighbours in time
      assertEquals(cases.get(n).collector(), cases.get(n + 1).collector());
      assertEquals(cases.get(n).heapFactor(), cases.get(n + 1).heapFactor());
    }
  }

  @Test
  void eachScopeHoldsTheSmallerOne() {
    Set<GcCase> usual = new HashSet<>(StudyScope.USUAL.cases(JDKS));
    assertTrue(usual.containsAll(StudyScope.QUICK.cases(JDKS)));
    assertTrue(new HashSet<>(StudyScope.FULL.cases(JDKS)).containsAll(usual));
    Set<ScratchPolicy> policies = usual.stream().map(GcCase::policy).collect(Collectors.toSet());
    assertEquals(EnumSet.allOf(ScratchPolicy.class), policies);
    Set<Workload> workloads = usual.stream().map(GcCase::workload).collect(Collectors.toSet());
    assertEquals(EnumSet.allOf(Workload.class), workloads);
    // 4 to 5 s each, so that two Javas need less than 15 minutes
    assertTrue(usual.size() <= 120, () -> "cases=" + usual.size());
  }

  @Test
  void virtualThreadsAreLeftToJavasThatHaveThem() {
    for (GcCase each : StudyScope.FULL.cases(JDKS)) {
      assertFalse(
          each.policy() == ScratchPolicy.THREAD_LOCAL_VIRTUAL && each.java().startsWith("17"));
    }
  }
}
