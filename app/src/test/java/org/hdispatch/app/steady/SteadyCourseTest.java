package org.hdispatch.app.steady;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.porous.flow.Approach;
import org.hdispatch.porous.flow.FlowListener;
import org.junit.jupiter.api.Test;

class SteadyCourseTest {
  private static Optional<Long> arrival(double share, double... errors) {
    return SteadyCourses.course(Approach.PLAIN, -1, errors)
        .within(share)
        .map(SteadyCourse.Point::step);
  }

  @Test
  void isWithinFromWhereItStays() {
    assertEquals(Optional.of(30L), arrival(0.01, 0.5, 0.02, -0.009, 0.009, 0));
    assertEquals(Optional.of(40L), arrival(0.01, 0.5, 0.001, -0.02, 0.009, 0.001)); // not at 20
    assertEquals(Optional.of(10L), arrival(0.01, 0.001, 0.002));
  }

  @Test
  void isNotWithinIfItsLastErrorIsAbove() {
    assertEquals(Optional.empty(), arrival(0.01, 0.5, 0.001, 0.02));
    assertEquals(Optional.empty(), arrival(0.01, Double.NaN));
  }

  @Test
  void ratiosCompareArrivalsWithTheCorrectedOne() {
    SteadyCourse corrected = SteadyCourses.course(Approach.CORRECTED, 1, 0.1, 0.001, 0);
    SteadyCourse plain = SteadyCourses.course(Approach.PLAIN, -1, 0.5, 0.3, 0.2, 0.1, 0.005);
    SteadyComparison rock = SteadyCourses.rock(5, corrected, plain);
    assertEquals(OptionalDouble.of(2.5), rock.stepsRatio(plain, 1e-2)); // 50 : 20
    assertEquals(2.5, rock.secondsRatio(plain, 1e-2).getAsDouble(), 1e-12);
    assertEquals(OptionalDouble.of(1), rock.stepsRatio(corrected, 1e-2));
    assertEquals(OptionalDouble.empty(), rock.stepsRatio(plain, 1e-3));
  }

  /** A recorder at the fourth of a steady k of 1, close at 1e-4. */
  private static CourseRecorder recorder() {
    CourseRecorder recorder = new CourseRecorder(Approach.PLAIN, 1, 1e-4, 1e-3);
    recorder.started(new FlowListener.Start(100, 0.6));
    return recorder;
  }

  private static boolean enoughAfter(CourseRecorder recorder, double error, double estimate) {
    int n = recorder.course().points().size() + 1;
    recorder.progressed(
        new FlowListener.Progress(50L * n, 1000, 1 + error, estimate, 1e-9, 0, n, 0.5 * n, 9));
    return recorder.enough();
  }

  @Test
  void recorderHasEnoughOnceTheRuleIsMetAndKHasBeenThereForAWhile() {
    CourseRecorder recorder = recorder();
    assertFalse(enoughAfter(recorder, 0.1, Double.POSITIVE_INFINITY));
    assertFalse(enoughAfter(recorder, 1e-5, 1)); // k crosses its steady value
    assertFalse(enoughAfter(recorder, -0.1, 1));
    assertFalse(enoughAfter(recorder, 2e-4, 9e-4));
    assertFalse(enoughAfter(recorder, 9e-5, 8e-4)); // the rule is met
    assertFalse(enoughAfter(recorder, -9e-5, 7e-4));
    assertFalse(enoughAfter(recorder, 9e-5, 7e-4));
    assertTrue(enoughAfter(recorder, 9e-5, 7e-4));
    SteadyCourse course = recorder.course();
    assertEquals(0.6, course.relaxationTime());
    assertEquals(50, course.interval());
    assertEquals(250, course.stop().orElseThrow().step());
    assertEquals(7.5, course.stop().orElseThrow().seconds()); // 5 s of steps, 2.5 s of pressure
    assertEquals(2.5, course.stop().orElseThrow().secondsPressure());
    assertEquals(400, course.last().step());
  }

  @Test
  void recorderWaitsForTheRuleThoughKIsThere() {
    CourseRecorder recorder = recorder();
    for (int n = 0; n < 10; n++) {
      assertFalse(enoughAfter(recorder, 1e-5, 2e-3));
    }
    assertEquals(Optional.empty(), recorder.course().stop());
  }
}
