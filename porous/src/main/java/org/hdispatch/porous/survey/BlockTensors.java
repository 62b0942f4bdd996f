package org.hdispatch.porous.survey;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import org.hdispatch.porous.image.Axis;

/**
 * Puts the rows of each block together: those of blocks that have a converged permeability, or none
 * for want of percolation, along each of the three axes. It holds the rows of one block at a time.
 */
public final class BlockTensors {
  private static final long NONE = -1;

  private final Map<Axis, SurveyRow> rows = new EnumMap<>(Axis.class);
  private long block = NONE; // that the rows are of

  /** Has heard of no row yet. */
  public BlockTensors() {}

  /**
   * Takes in a row; they come in the order of their jobs, block by block.
   *
   * @return the block that it completes
   */
  public Optional<BlockTensor> add(SurveyRow row) {
    if (row.job().block() != block) {
      rows.clear();
      block = row.job().block();
    }
    if (BlockTensor.isKnown(row)) {
      rows.put(row.job().axis(), row);
      if (rows.size() == Axis.values().length) {
        return Optional.of(new BlockTensor(block, row.job().box(), rows));
      }
    }
    return Optional.empty();
  }
}
