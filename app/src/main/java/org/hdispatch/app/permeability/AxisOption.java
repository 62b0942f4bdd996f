package org.hdispatch.app.permeability;

import java.util.List;
import org.hdispatch.app.console.Choices;
import org.hdispatch.porous.image.Axis;
import picocli.CommandLine.Option;

/** The direction of the flow. */
final class AxisOption {
  @Option(
      names = "--axis",
      paramLabel = "AXIS",
      defaultValue = "z",
      completionCandidates = Words.class,
      description =
          "Direction of the flow: ${COMPLETION-CANDIDATES}. With all, one flow along each axis, and"
              + " the permeability tensor; what flows across an axis needs --sides periodic.")
  private Direction direction;

  /** Words for directions of the flow. */
  static final class Words extends Choices {
    Words() {
      super(Direction.values());
    }
  }

  /** The axes, one after the other. */
  List<Axis> axes() {
    return direction.axes();
  }
}
