package org.hdispatch.app.survey;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hdispatch.app.console.Given;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.app.rock.FlowChoices;
import org.hdispatch.app.rock.FlowSettings;
import org.hdispatch.app.rock.FluidOptions;
import org.hdispatch.app.rock.ImageOptions;
import org.hdispatch.app.rock.ImageSource;
import org.hdispatch.app.rock.MethodOptions;
import org.hdispatch.app.rock.Rock;
import org.hdispatch.porous.block.BlockSettings;
import org.hdispatch.porous.block.BlockStudy;
import org.hdispatch.porous.block.FlowChoice;
import org.hdispatch.porous.block.HeapException;
import org.hdispatch.porous.block.Pores;
import org.hdispatch.porous.darcy.PhysicalFlow;
import org.hdispatch.porous.flow.Inlet;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.survey.BlockGrid;
import org.hdispatch.porous.survey.Shard;
import org.hdispatch.porous.survey.SurveyPlan;

/**
 * From the options of a survey to what is to be done.
 *
 * @param image which image
 * @param survey which blocks
 * @param method by which method
 * @param flow with which settings
 * @param fluid of which fluid
 * @param host in which process
 */
record SurveyPlanner(
    ImageOptions image,
    SurveyOptions survey,
    MethodOptions method,
    FlowSettings flow,
    FluidOptions fluid,
    Host host) {

  /**
   * What is to be done.
   *
   * @throws UsageException if options do not go together, or one is out of its bounds
   * @throws ImageFileException if the image is not what it should be
   * @throws HeapException if not even a block fits
   */
  SurveyTask task(Given given) throws ImageFileException {
    survey.check(given);
    FlowChoice choice = FlowChoices.of(method, flow, given);
    if (choice.options().inlet() != Inlet.SLAB) {
      given.refuse("--inlet-layers", "--inlet slab");
    }
    PhysicalFlow physical = fluid.fluid();
    Shard shard = survey.shard();
    int refine = method.refine();
    ImageSource source = ImageSource.of(image);
    double edge = Rock.edgeOf(source, image).getAsDouble();
    VoxelBox whole = source.whole();
    VoxelBox region = // may be too large for one image, as it is not read as such
        UsageException.orRefused(
            () -> image.box().orElse(whole).within(whole.nx(), whole.ny(), whole.nz()));
    Optional<BlockGrid> grid = survey.grid(region);
    SurveyPlan plan = survey.plan(whole, grid);
    if (plan.jobs(shard) < 1) {
      throw new UsageException(
          "shards must be at most as many as blocks: shards="
              + shard.count()
              + ", blocks="
              + plan.blocks().size());
    }
    double voxels = plan.blocks().get(0).box().voxels();
    host.requireHeap("a block of " + (long) voxels + " voxels", Pores.BYTES_PER_VOXEL * voxels);
    BlockSettings settings =
        UsageException.orRefused(
            () ->
                new BlockSettings(
                    image.rule(),
                    edge,
                    refine,
                    flow.walls(),
                    flow.solidFractionRange().orElse(List.of()),
                    survey.outsideLabels(),
                    survey.outside(),
                    choice,
                    physical));
    BlockStudy study = new BlockStudy(source, nameOf(source), settings, host.heap());
    return new SurveyTask(
        source,
        plan,
        which(plan),
        grid.map(BlockGrid::partialBlocks).orElse(0L),
        shard,
        study,
        host.heapBytes());
  }

  private String nameOf(ImageSource source) {
    Optional<Path> file = image.image();
    return file.map(each -> BlockStudy.nameOf(source, each)).orElse(source.name());
  }

  /** Which blocks, in words. */
  private Map<String, String> which(SurveyPlan plan) {
    Map<String, String> words = new LinkedHashMap<>();
    words.put("box", image.box().map(VoxelBox::toString).orElse(""));
    words.put("block", survey.block().toString());
    words.put("stride", survey.strideWords());
    words.put("blocks", survey.choiceWords(plan));
    return words;
  }
}
