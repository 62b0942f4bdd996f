package org.hdispatch.app;

import org.hdispatch.porous.image.Axis;
import picocli.CommandLine.Option;

/** The direction of the flow. */
final class AxisOption {
  @Option(
      names = "--axis",
      paramLabel = "AXIS",
      defaultValue = "z",
      completionCandidates = Choices.OfAxis.class,
      description = "Direction of the flow: ${COMPLETION-CANDIDATES}.")
  private Axis axis;

  Axis axis() {
    return axis;
  }
}
