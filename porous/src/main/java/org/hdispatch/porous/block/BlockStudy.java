package org.hdispatch.porous.block;

import java.nio.channels.ClosedByInterruptException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import java.util.zip.CRC32;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.lbm.immersed.LostBodyException;
import org.hdispatch.porous.flow.DivergedException;
import org.hdispatch.porous.flow.FlowListener;
import org.hdispatch.porous.flow.SteadyFlow;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.io.ImageFile;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.pore.Percolation;
import org.hdispatch.porous.survey.SurveyJob;
import org.hdispatch.porous.survey.SurveyPlan;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveySettings;
import org.hdispatch.porous.survey.SurveyStatus;
import org.hdispatch.sph.BlownUpException;

/**
 * Does the jobs of a survey one by one; of the image it holds one block at a time. What it finds
 * depends on the image and the settings, and on nothing else.
 */
public final class BlockStudy {
  private final ImageFile image;
  private final String name;
  private final BlockSettings settings;
  private final HeapLimit heap;
  private final boolean[] outsideLabels = new boolean[VoxelImage.LABELS];
  private final Map<String, String> same; // what stands in every row
  private Optional<Block> last = Optional.empty(); // axes of one block follow each other

  /**
   * A block that has been read.
   *
   * @param box where it lies
   * @param outside share of its voxels outside the sample
   * @param pores its pores, in voxels as fine as asked for; empty if nothing is to be computed
   * @param inspected what can be said of it without a flow
   */
  public record Block(
      VoxelBox box, double outside, Optional<Pores> pores, Map<String, String> inspected) {}

  /**
   * A job that has been done.
   *
   * @param row what was found
   * @param flow the flow, if there is one
   */
  public record Done(SurveyRow row, Optional<SteadyFlow> flow) {}

  /**
   * Studies of the blocks of an image.
   *
   * @param image the image
   * @param name what rows call it, the same on all machines
   * @param settings what is computed
   * @param heap what there is
   */
  public BlockStudy(ImageFile image, String name, BlockSettings settings, HeapLimit heap) {
    this.image = image;
    this.name = name;
    this.settings = settings;
    this.heap = heap;
    settings.outsideLabels().forEach(label -> outsideLabels[label] = true);
    Map<String, String> values = settings.values();
    values.put("image", name);
    values.put("voxel_edge_m", Double.toString(edge())); // that k is in
    same = new LinkedHashMap<>();
    BlockColumns.SETTINGS.forEach(key -> same.put(key, values.getOrDefault(key, "")));
  }

  /** The name of an image less the folder of its file, which may differ between machines. */
  public static String nameOf(ImageFile image, Path file) {
    return image.name().replace(file.toString(), file.getFileName().toString());
  }

  /** The edge of a voxel of the flow, m. */
  private double edge() {
    return settings.voxelEdge() / settings.refine();
  }

  /**
   * What the rows of a survey depend on. Two surveys that agree in it have the same rows.
   *
   * @param plan the blocks and axes
   * @param which in words, by their names, which blocks those are
   * @throws ImageFileException if the caller is interrupted while the image is read
   */
  public SurveySettings settings(SurveyPlan plan, Map<String, String> which)
      throws ImageFileException {
    VoxelBox whole = image.whole();
    Map<String, String> values = new LinkedHashMap<>();
    values.put(SurveySettings.JOBS, Integer.toString(plan.jobs()));
    values.put("image", name);
    values.put("image_size", whole.nx() + "," + whole.ny() + "," + whole.nz());
    values.putAll(which);
    values.put("axes", String.join(",", plan.axes().stream().map(BlockSettings::word).toList()));
    values.putAll(settings.values());
    check(plan).ifPresent(sum -> values.put(SurveySettings.BLOCKS_CRC, Long.toHexString(sum)));
    return new SurveySettings(values);
  }

  /**
   * Checksum of the first, the middle and the last block: of a round core, the corners are all
   * outside. Empty if one of them cannot be read, which its row will say.
   */
  private Optional<Long> check(SurveyPlan plan) throws ImageFileException {
    List<SurveyPlan.Block> blocks = plan.blocks();
    List<VoxelBox> some =
        IntStream.of(0, blocks.size() / 2, blocks.size() - 1)
            .distinct()
            .mapToObj(n -> blocks.get(n).box())
            .toList();
    try {
      return Optional.of(checksum(some));
    } catch (ImageFileException | HeapException e) {
      if (isInterruption(e)) {
        throw e;
      }
      return Optional.empty();
    }
  }

  /**
   * Reads and inspects a block, if it is not the last one that was.
   *
   * @throws ImageFileException if it cannot be read
   * @throws HeapException if it does not fit
   */
  public Block block(VoxelBox box) throws ImageFileException {
    if (last.isEmpty() || !last.get().box().equals(box)) {
      last = Optional.empty(); // to be collected before the next is read
      last = Optional.of(inspect(box));
    }
    return last.get();
  }

  private Block inspect(VoxelBox box) throws ImageFileException {
    VoxelImage voxels = read(box);
    long[] histogram = voxels.histogram();
    long beyond = 0;
    for (int label : settings.outsideLabels().stream().distinct().toList()) {
      beyond += histogram[label];
    }
    double share = (double) beyond / box.voxels();
    Map<String, String> inspected = new LinkedHashMap<>();
    inspected.put("outside_fraction", Double.toString(share));
    if (beyond > 0 && (settings.outside() == Outside.FLAG || beyond == box.voxels())) {
      return new Block(box, share, Optional.empty(), inspected);
    }
    Pores pores =
        Pores.of(
            beyond > 0 ? withoutOutside(voxels) : voxels,
            settings.rule(),
            settings.walls(),
            settings.grey());
    for (Axis axis : Axis.values()) {
      Percolation found = Percolation.along(pores.space(), axis, Ends.OPEN, Ends.OPEN);
      inspected.put("percolates_" + BlockSettings.word(axis), Boolean.toString(found.percolates()));
      inspected.put(
          "porosity_connected_" + BlockSettings.word(axis),
          Double.toString(found.connectedPorosity() / (1 - share)));
    }
    return new Block(box, share, Optional.of(pores.refined(settings.refine(), heap)), inspected);
  }

  private VoxelImage read(VoxelBox box) throws ImageFileException {
    heap.require(
        "an image of " + box.voxels() + " voxels", (double) Pores.BYTES_PER_VOXEL * box.voxels());
    return image.read(box);
  }

  /** The image with solid outside. In a segmented one it is solid anyway, being no pore. */
  private VoxelImage withoutOutside(VoxelImage voxels) {
    if (settings.grey().isEmpty()) {
      return voxels;
    }
    byte solid = settings.grey().get(1).byteValue();
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
  private long checksum(List<VoxelBox> boxes) throws ImageFileException {
    last = Optional.empty(); // to be collected before others are read
    CRC32 sum = new CRC32();
    for (VoxelBox box : boxes) {
      VoxelImage voxels = read(box);
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
   * @throws CancellationException if the caller is interrupted
   * @throws ImageFileException if the caller is interrupted while reading
   */
  public Done run(Dispatcher dispatcher, SurveyJob job, FlowListener listener)
      throws ImageFileException {
    Map<String, String> figures = new LinkedHashMap<>(same);
    try {
      Block block = block(job.box());
      figures.putAll(block.inspected());
      if (block.pores().isEmpty()) {
        return new Done(new SurveyRow(job, SurveyStatus.OUTSIDE, "", figures), Optional.empty());
      }
      FlowChoice along = settings.choice().along(job.axis());
      Pores pores = block.pores().get();
      along.requireHeap(pores, heap);
      SteadyFlow flow = along.solve(dispatcher, pores, listener);
      Map<String, Object> found =
          new FlowFigures(flow, OptionalDouble.of(edge()), settings.fluid()).values(pores.space());
      BlockColumns.COMPUTED.forEach(key -> figures.put(key, text(found.get(key))));
      figures.put("smoothing_length_voxel", text(found.get("smoothing_length_voxel")));
      double inside = 1 - block.outside();
      figures.put("porosity", Double.toString(flow.porosity() / inside));
      figures.put("porosity_connected", Double.toString(flow.connectedPorosity() / inside));
      return new Done(new SurveyRow(job, status(flow), "", figures), Optional.of(flow));
    } catch (ImageFileException | RuntimeException | OutOfMemoryError e) {
      // One bad block must not end hours of others: all but Ctrl-C becomes a row that says why.
      if (isInterruption(e)) {
        throw e;
      }
      return new Done(new SurveyRow(job, SurveyStatus.FAILED, cause(e), figures), Optional.empty());
    }
  }

  private static String text(Object value) {
    return value == null ? "" : value.toString();
  }

  /** Whether the caller was interrupted, whatever could not go on because of that. */
  private static boolean isInterruption(Throwable thrown) {
    boolean found = Thread.currentThread().isInterrupted();
    for (Throwable each = thrown; each != null; each = each.getCause()) {
      found |= each instanceof CancellationException || each instanceof ClosedByInterruptException;
    }
    return found;
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
        thrown instanceof ImageFileException
            || thrown instanceof DivergedException
            || thrown instanceof LostBodyException
            || root instanceof IllegalArgumentException;
    if (!known) {
      return "fault of H-Dispatch: " + root;
    }
    return root.getMessage() == null ? root.toString() : root.getMessage();
  }

  /**
   * Heap that the flow of a block needs along an axis, bytes; empty if nothing is computed.
   *
   * @throws IllegalArgumentException if it cannot be computed
   */
  public Optional<Double> estimatedBytes(Block block, Axis axis) {
    return block.pores().map(pores -> settings.choice().along(axis).estimatedBytes(pores));
  }

  /**
   * Times of a job, as {@link BlockColumns#TIMES} names them.
   *
   * @param seconds that it took in all
   * @param threads that did it
   */
  public static List<String> times(Done done, double seconds, int threads) {
    Optional<SteadyFlow.Work> work = done.flow().map(SteadyFlow::work);
    double pressure =
        done.flow()
            .flatMap(SteadyFlow::corrections)
            .map(SteadyFlow.Corrections::seconds)
            .orElse(0.0);
    return List.of(
        Integer.toString(done.row().job().number()),
        Double.toString(seconds),
        Double.toString(work.map(SteadyFlow.Work::secondsStepping).orElse(0.0)),
        Double.toString(pressure),
        Double.toString(work.map(SteadyFlow.Work::mflups).orElse(0.0)),
        Integer.toString(threads),
        System.getProperty("java.version"));
  }
}
