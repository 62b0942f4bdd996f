package org.hdispatch.app;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.zip.CRC32;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.porous.darcy.PhysicalFlow;
import org.hdispatch.porous.flow.FlowListener;
import org.hdispatch.porous.flow.SolidFractions;
import org.hdispatch.porous.flow.SteadyFlow;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.pore.Percolation;
import org.hdispatch.porous.survey.SurveyJob;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveyStatus;
import org.hdispatch.sph.BlownUpException;

/** Does the jobs of a survey one by one; of the image it holds one block at a time. */
final class BlockStudy {
  private final ImageSource source;
  private final ImageOptions image;
  private final FlowSettings settings;
  private final FlowChoice choice;
  private final PhysicalFlow fluid;
  private final int refine;
  private final boolean[] outsideLabels;
  private final Outside outside;
  private final Host host;
  private Optional<Block> last = Optional.empty(); // axes of one block follow each other

  /**
   * A block that has been read.
   *
   * @param box where it lies
   * @param outside share of its voxels outside the sample
   * @param rock its rock, in voxels as fine as asked for; empty if nothing is to be computed
   * @param inspected what can be said of it without a flow
   */
  record Block(VoxelBox box, double outside, Optional<Rock> rock, Map<String, String> inspected) {}

  /**
   * A job that has been done.
   *
   * @param row what was found
   * @param flow the flow, if there is one
   */
  record Done(SurveyRow row, Optional<SteadyFlow> flow) {}

  /**
   * Studies of the blocks of an image.
   *
   * @param source the image
   * @param image how it is read
   * @param settings how walls are made
   * @param choice how flows are computed
   * @param fluid fluid and drive
   * @param refine how many voxels an edge of one is cut into
   * @param survey which voxels lie outside, and what becomes of them
   * @param host what it runs in
   * @throws UsageException if a label lies outside and in the pores, or no block could be done so
   */
  BlockStudy(
      ImageSource source,
      ImageOptions image,
      FlowSettings settings,
      FlowChoice choice,
      PhysicalFlow fluid,
      int refine,
      SurveyOptions survey,
      Host host) {
    this.source = source;
    this.image = image;
    this.settings = settings;
    this.choice = choice;
    this.fluid = fluid;
    this.refine = refine;
    this.outside = survey.outside();
    this.outsideLabels =
        survey.outsideLabels(image.rule(), settings.solidFractionRange().isEmpty());
    this.host = host;
    if (refine > 1 && settings.walls() == Walls.IMB) {
      throw new UsageException(Rock.NOT_REFINED);
    }
    settings.solidFractionRange().ifPresent(BlockStudy::requireGrey);
  }

  private static void requireGrey(List<Integer> grey) {
    VoxelImage any = VoxelImage.of(1, 1, 1, new byte[1]);
    UsageException.orRefused(() -> SolidFractions.ofGrey(any, grey.get(0), grey.get(1)));
  }

  /**
   * Reads and inspects a block, if it is not the last one that was.
   *
   * @throws ImageFileException if it cannot be read
   * @throws HeapException if it does not fit
   */
  Block block(VoxelBox box) throws ImageFileException {
    if (last.isEmpty() || !last.get().box().equals(box)) {
      last = Optional.empty(); // to be collected before the next is read
      last = Optional.of(inspect(box));
    }
    return last.get();
  }

  private Block inspect(VoxelBox box) throws ImageFileException {
    VoxelImage voxels = Rock.read(source, box, host);
    long[] histogram = voxels.histogram();
    long beyond = 0;
    for (int label = 0; label < outsideLabels.length; label++) {
      beyond += outsideLabels[label] ? histogram[label] : 0;
    }
    double share = (double) beyond / box.voxels();
    Map<String, String> inspected = new LinkedHashMap<>();
    inspected.put("outside_fraction", Double.toString(share));
    if (beyond > 0 && (outside == Outside.FLAG || beyond == box.voxels())) {
      return new Block(box, share, Optional.empty(), inspected);
    }
    Rock rock =
        Rock.of(
            source,
            box,
            beyond > 0 ? withoutOutside(voxels) : voxels,
            image,
            settings.walls(),
            settings.solidFractionRange());
    for (Axis axis : Axis.values()) {
      Percolation found = Percolation.along(rock.space(), axis, Ends.OPEN, Ends.OPEN);
      inspected.put("percolates_" + Choices.word(axis), Boolean.toString(found.percolates()));
      inspected.put(
          "porosity_connected_" + Choices.word(axis),
          Double.toString(found.connectedPorosity() / (1 - share)));
    }
    return new Block(box, share, Optional.of(rock.refined(refine, host)), inspected);
  }

  /** The image with solid outside. In a segmented one it is solid anyway, being no pore. */
  private VoxelImage withoutOutside(VoxelImage voxels) {
    if (settings.solidFractionRange().isEmpty()) {
      return voxels;
    }
    byte solid = settings.solidFractionRange().get().get(1).byteValue();
    byte[] labels = voxels.toLabels();
    for (int n = 0; n < labels.length; n++) {
      if (outsideLabels[labels[n] & 0xff]) {
        labels[n] = solid;
      }
    }
    return VoxelImage.of(voxels.nx(), voxels.ny(), voxels.nz(), labels);
  }

  /**
   * Checksum (CRC-32) of the labels of some blocks, one after the other, as the file has them.
   *
   * @throws ImageFileException if one cannot be read
   * @throws HeapException if one does not fit
   */
  long checksum(List<VoxelBox> boxes) throws ImageFileException {
    last = Optional.empty(); // to be collected before others are read
    CRC32 sum = new CRC32();
    for (VoxelBox box : boxes) {
      VoxelImage voxels = Rock.read(source, box, host);
      byte[] row = new byte[voxels.nx()];
      for (int from = 0; from < voxels.voxels(); from += row.length) {
        for (int x = 0; x < row.length; x++) {
          row[x] = (byte) voxels.label(from + x);
        }
        sum.update(row);
      }
    }
    return sum.getValue();
  }

  /**
   * Does a job. Whatever is wrong with the block or its flow ends in its row.
   *
   * @param same what stands in every row
   * @throws java.util.concurrent.CancellationException if the caller is interrupted
   * @throws ImageFileException if the caller is interrupted while reading
   */
  Done run(Dispatcher dispatcher, SurveyJob job, Map<String, String> same, FlowListener listener)
      throws ImageFileException {
    Map<String, String> figures = new LinkedHashMap<>(same);
    try {
      Block block = block(job.box());
      figures.putAll(block.inspected());
      if (block.rock().isEmpty()) {
        return new Done(new SurveyRow(job, SurveyStatus.OUTSIDE, "", figures), Optional.empty());
      }
      FlowChoice along = choice.along(job.axis());
      Rock rock = block.rock().get();
      along.requireHeap(rock, host);
      SteadyFlow flow = along.solve(dispatcher, rock, listener);
      Outcome outcome =
          new Outcome(along.method(), rock, fluid, flow, dispatcher.workers(), Optional.empty());
      FlatRow found = OutcomeRow.of(outcome);
      SurveyColumns.COMPUTED.forEach(key -> figures.put(key, found.text(key)));
      figures.put("smoothing_length_voxel", found.text("smoothing_length_voxel"));
      double inside = 1 - block.outside();
      figures.put("porosity", Double.toString(flow.porosity() / inside));
      figures.put("porosity_connected", Double.toString(flow.connectedPorosity() / inside));
      return new Done(new SurveyRow(job, status(flow), "", figures), Optional.of(flow));
    } catch (ImageFileException | RuntimeException | OutOfMemoryError e) {
      // One bad block must not end hours of others: all but Ctrl-C becomes a row that says why.
      if (Faults.code(e) == ExitCode.INTERRUPTED) {
        throw e;
      }
      return new Done(new SurveyRow(job, SurveyStatus.FAILED, cause(e), figures), Optional.empty());
    }
  }

  private static SurveyStatus status(SteadyFlow flow) {
    if (!flow.percolation().percolates()) {
      return SurveyStatus.DOES_NOT_PERCOLATE;
    }
    return flow.converged() ? SurveyStatus.DONE : SurveyStatus.NOT_CONVERGED;
  }

  /** Why a job failed, the same whichever worker met it first. */
  static String cause(Throwable thrown) {
    Throwable root = thrown;
    while (root.getCause() != null && !(root instanceof ImageFileException)) {
      root = root.getCause();
    }
    if (root instanceof BlownUpException) {
      return "flow must not blow up";
    }
    if (root instanceof OutOfMemoryError) {
      return "heap must hold the computation (give more -Xmx)";
    }
    if (root instanceof HeapException heap) {
      return heap.need();
    }
    boolean known =
        Faults.code(thrown) != ExitCode.FAULT || root instanceof IllegalArgumentException;
    if (!known) {
      return "fault of H-Dispatch: " + root;
    }
    return root.getMessage() == null ? root.toString() : root.getMessage();
  }

  /** Heap that the flow of a block needs along an axis, bytes; empty if nothing is computed. */
  Optional<Double> estimatedBytes(Block block, Axis axis) {
    return block.rock().map(rock -> choice.along(axis).estimatedBytes(rock));
  }

  /** Times of a job, as {@link SurveyColumns#TIMES} names them. */
  static List<String> times(Done done, double seconds, int threads) {
    SurveyJob job = done.row().job();
    Optional<SteadyFlow.Work> work = done.flow().map(SteadyFlow::work);
    double pressure =
        done.flow()
            .flatMap(SteadyFlow::corrections)
            .map(SteadyFlow.Corrections::seconds)
            .orElse(0.0);
    return List.of(
        Integer.toString(job.number()),
        Double.toString(seconds),
        Double.toString(work.map(SteadyFlow.Work::secondsStepping).orElse(0.0)),
        Double.toString(pressure),
        Double.toString(work.map(SteadyFlow.Work::mflups).orElse(0.0)),
        Integer.toString(threads),
        Version.ofJava());
  }
}
