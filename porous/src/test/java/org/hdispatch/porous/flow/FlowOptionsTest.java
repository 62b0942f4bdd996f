package org.hdispatch.porous.flow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.porous.image.Axis;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FlowOptionsTest {
  @ParameterizedTest
  @ValueSource(doubles = {0, -1e-3, 1, Double.NaN})
  void refusesATolerancesThatNothingCanMeet(double tolerance) {
    IllegalArgumentException e =
        assertThrows(
            IllegalArgumentException.class, () -> FlowOptions.DEFAULT.withTolerance(tolerance));
    assertEquals("tolerance must lie between 0 and 1: tolerance=" + tolerance, e.getMessage());
  }

  @Test
  void eachCopyChangesItsSettingAlone() {
    FlowOptions from = FlowOptions.DEFAULT;
    Map<FlowOptions, Set<String>> copies =
        Map.of(
            from.withAxis(Axis.X), Set.of("axis"),
            from.withVelocitySet(VelocitySet.D3Q15), Set.of("velocitySet"),
            from.withStorage(Storage.SINGLE), Set.of("storage"),
            from.withCollision(CollisionModel.BGK), Set.of("collision"),
            from.withRelaxationTime(2), Set.of("relaxationTime"),
            from.withBoundaries(Sides.MIRROR, Inlet.PRESSURE), Set.of("sides", "inlet"),
            from.withInletLayers(3), Set.of("inletLayers"),
            from.withApproach(Approach.PLAIN), Set.of("approach"),
            from.withTolerance(0.5), Set.of("tolerance"),
            from.withMaxSteps(7), Set.of("maxSteps"));
    copies.forEach((copy, changed) -> assertEquals(changed, differences(from, copy)));
    long settings = copies.values().stream().mapToLong(Set::size).sum();
    assertEquals(FlowOptions.class.getRecordComponents().length, settings);
  }

  private static Set<String> differences(FlowOptions a, FlowOptions b) {
    return Arrays.stream(FlowOptions.class.getRecordComponents())
        .filter(setting -> !value(setting, a).equals(value(setting, b)))
        .map(RecordComponent::getName)
        .collect(Collectors.toSet());
  }

  private static Object value(RecordComponent setting, FlowOptions of) {
    try {
      return setting.getAccessor().invoke(of);
    } catch (ReflectiveOperationException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void refusesTauWithoutViscosity() {
    assertThrows(IllegalArgumentException.class, () -> FlowOptions.DEFAULT.withRelaxationTime(0.5));
  }

  @Test
  void refusesNoStepsAndNoLayers() {
    assertThrows(IllegalArgumentException.class, () -> FlowOptions.DEFAULT.withMaxSteps(0));
    assertThrows(IllegalArgumentException.class, () -> FlowOptions.DEFAULT.withInletLayers(0));
  }
}
