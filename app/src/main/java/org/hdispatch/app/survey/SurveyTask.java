package org.hdispatch.app.survey;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Faults;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.app.rock.ImageSource;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.porous.block.BlockColumns;
import org.hdispatch.porous.block.BlockStudy;
import org.hdispatch.porous.block.HeapException;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.survey.Shard;
import org.hdispatch.porous.survey.SurveyFiles;
import org.hdispatch.porous.survey.SurveyJob;
import org.hdispatch.porous.survey.SurveyPlan;
import org.hdispatch.porous.survey.SurveySettings;

/**
 * What a survey, or a shard of it, is to do.
 *
 * @param source the image
 * @param plan its blocks and axes
 * @param which in words, by their names, which blocks those are
 * @param left blocks left out as the image ends within them
 * @param shard which of the blocks
 * @param study does the jobs
 * @param heapBytes the most heap there is
 */
record SurveyTask(
    ImageSource source,
    SurveyPlan plan,
    Map<String, String> which,
    long left,
    Shard shard,
    BlockStudy study,
    long heapBytes) {
  private static final double MIB = 1 << 20;

  /** Jobs of this shard. */
  int jobs() {
    return plan.jobs(shard);
  }

  /** What the rows depend on. */
  SurveySettings settings() throws ImageFileException {
    return study.settings(plan, which);
  }

  /**
   * The files of its rows.
   *
   * @param settings what the rows depend on
   * @throws UsageException if the folder holds a survey with other settings
   */
  SurveyFiles open(Path folder, SurveySettings settings) throws ImageFileException {
    try {
      return SurveyFiles.open(folder, shard, settings, BlockColumns.FIGURES, BlockColumns.TIMES);
    } catch (IllegalArgumentException e) {
      throw new UsageException(e.getMessage());
    }
  }

  /** What heap the first block needs, in words; that it is bad does not matter here. */
  String heapOfFirst() throws ImageFileException {
    SurveyJob job = plan.job(0);
    try {
      BlockStudy.Block block = study.block(job.box());
      try {
        return study
            .estimatedBytes(block, job.axis())
            .map(SurveyTask::mebibytes)
            .orElse("unknown (it lies outside)");
      } catch (IllegalArgumentException e) {
        return "unknown (" + e.getMessage() + ")";
      }
    } catch (ImageFileException | HeapException e) {
      if (Faults.code(e) == ExitCode.INTERRUPTED) {
        throw e;
      }
      return "unknown (" + e.getMessage() + ")";
    }
  }

  String heapGiven() {
    return mebibytes((double) heapBytes);
  }

  private static String mebibytes(double bytes) {
    return String.format(Locale.ROOT, "%.0f MiB", bytes / MIB);
  }

  /** The task as a row, for a dry run. */
  FlatRow planned() throws ImageFileException {
    VoxelBox whole = source.whole();
    return new FlatRow()
        .put("image", source.name())
        .put("size", whole.nx() + "," + whole.ny() + "," + whole.nz())
        .put("block", which.get("block"))
        .put("blocks", plan.blocks().size())
        .put("partial_blocks_left_out", left)
        .put("axes", String.join(",", plan.axes().stream().map(Choices::word).toList()))
        .put("jobs", plan.jobs())
        .put("shard", shard.toString())
        .put("jobs_of_shard", jobs())
        .put("heap_of_first_block", heapOfFirst())
        .put("heap_given", heapGiven());
  }
}
