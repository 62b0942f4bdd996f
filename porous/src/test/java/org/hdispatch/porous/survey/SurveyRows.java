package org.hdispatch.porous.survey;

import java.util.Map;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;

/** Rows to try things with. */
final class SurveyRows {
  private SurveyRows() {}

  /** A row of a cube at {@code x0}, with a porosity and a permeability in mD. */
  static SurveyRow row(
      int block, int x0, int edge, Axis axis, SurveyStatus status, double porosity, double k) {
    return new SurveyRow(
        new SurveyJob(block, block, new VoxelBox(x0, 0, 0, edge, edge, edge), axis),
        status,
        "",
        Map.of("porosity", Double.toString(porosity), "permeability_mD", Double.toString(k)));
  }

  static SurveyRow done(int block, int x0, int edge, Axis axis, double porosity, double k) {
    return row(block, x0, edge, axis, SurveyStatus.DONE, porosity, k);
  }
}
