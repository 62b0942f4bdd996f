package org.hdispatch.porous.survey;

import static org.hdispatch.porous.survey.SurveyRows.done;
import static org.hdispatch.porous.survey.SurveyRows.row;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import org.hdispatch.porous.image.Axis;
import org.junit.jupiter.api.Test;

class BlockScaleTest {
  private static final List<SurveyRow> ROWS =
      List.of(
          done(0, 0, 16, Axis.Z, 0.2, 300),
          done(0, 0, 8, Axis.X, 0.1, 50),
          done(0, 0, 8, Axis.Z, 0.1, 100),
          done(1, 8, 8, Axis.Z, 0.3, 500),
          row(2, 16, 8, Axis.Z, SurveyStatus.DOES_NOT_PERCOLATE, 0.05, 0),
          row(3, 24, 8, Axis.Z, SurveyStatus.NOT_CONVERGED, 0.15, 9999));

  @Test
  void blocksOfOneSizeAreOneScaleTheSmallestFirst() {
    List<BlockScale> scales = BlockScale.of(ROWS);
    assertEquals(List.of(8.0, 16.0), scales.stream().map(BlockScale::edge).toList());
    assertEquals(1, scales.get(1).porosity().count());
  }

  @Test
  void porosityCountsEachBlockOnceAndPermeabilityTheDeadOnesToo() {
    BlockScale small = BlockScale.of(ROWS).get(0);
    assertEquals(4, small.porosity().count()); // not 5, though block 0 has two rows
    assertEquals(0.15, small.porosity().arithmetic(), 1e-15);
    Spread along = small.permeability().get(Axis.Z);
    assertEquals(3, along.count()); // less the one that did not converge
    assertEquals(200, along.arithmetic(), 1e-12);
    assertEquals(Math.sqrt((1e4 + 9e4 + 4e4) / 2), along.deviation(), 1e-10);
    assertEquals(Map.of(Axis.X, 0, Axis.Z, 1), small.dead());
  }

  @Test
  void aRowThatComesTwiceCountsOnce() {
    List<SurveyRow> twice = List.of(ROWS.get(2), ROWS.get(2), ROWS.get(3));
    assertEquals(2, BlockScale.of(twice).get(0).permeability().get(Axis.Z).count());
  }
}
