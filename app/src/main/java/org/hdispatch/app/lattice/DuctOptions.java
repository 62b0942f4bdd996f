package org.hdispatch.app.lattice;

import java.util.List;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.Streaming;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.lbm.duct.Duct;
import org.hdispatch.lbm.duct.DuctRun;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;

/** What is stepped, and for how long. */
final class DuctOptions {
  private static final int MOST_ROUNDS = 1000;

  @Option(
      names = "--size",
      paramLabel = "W",
      description = "Nodes along each axis, of one duct. Default: none, a sweep is run.")
  private Integer size;

  @Option(
      names = "--sizes",
      paramLabel = "W",
      split = ",",
      hideParamSyntax = true,
      defaultValue = "200",
      description =
          "Of a sweep: nodes along each axis, such as 200,300,400. The best bundle is that of the"
              + " first.")
  private List<Integer> sizes;

  @Option(
      names = "--bundle",
      paramLabel = "N|NX,NY,NZ",
      converter = BundleShape.Converter.class,
      description = {
        "Nodes of a bundle: of a cube, or along each axis; a number or all. Default: what a sweep"
            + " has stored for this machine and these settings, or else all,10,10.",
        "Of a sweep: may be given several times, and nothing is stored. Default: cubes of 10, 16,"
            + " 20, 25, 32, 40, 50 and shapes long in x."
      })
  private List<BundleShape> bundles; // null: none given

  @Option(
      names = "--lattice",
      paramLabel = "LATTICE",
      defaultValue = "D3Q15",
      description = "Velocity set: ${COMPLETION-CANDIDATES}.")
  private VelocitySet lattice;

  @Option(
      names = "--storage",
      paramLabel = "PRECISION",
      defaultValue = "double",
      completionCandidates = Choices.OfStorage.class,
      description = "Precision of the populations: ${COMPLETION-CANDIDATES}.")
  private Storage storage;

  @Option(
      names = "--streaming",
      paramLabel = "HOW",
      defaultValue = "in-place",
      converter = StreamingConverter.class,
      completionCandidates = Choices.OfStreaming.class,
      description =
          "How populations move: ${COMPLETION-CANDIDATES}. In place there is one copy of them.")
  private Streaming streaming;

  @Option(
      names = "--kernel",
      paramLabel = "FORM",
      completionCandidates = Choices.OfKernel.class,
      description =
          "Form of the kernel: ${COMPLETION-CANDIDATES}. Default: the fastest that this Java runs.")
  private KernelForm kernel;

  @Option(
      names = "--steps",
      paramLabel = "N",
      defaultValue = "48",
      description = "Steps to measure, two by two: an odd number is raised by one.")
  private long steps;

  @Option(
      names = "--warm-up",
      paramLabel = "N",
      description = "Steps before those. Default: 24, more for small ducts.")
  private Long warmUp;

  @Option(
      names = "--steady",
      description = "Of one duct: step on until the flow is steady, unmeasured.")
  private boolean steady;

  @Option(
      names = "--rounds",
      paramLabel = "R",
      defaultValue = "1",
      description =
          "Of a sweep: go through it so often, and keep of each run the one with the most usual"
              + " bandwidth beside it (1 to 1000).")
  private int rounds;

  @Option(
      names = "--no-store",
      description =
          "Of a sweep: do not store the best shape as the default of --bundle. Ducts below 100 nodes"
              + " a side store nothing anyway.")
  private boolean noStore;

  /** Reads a way of streaming: picocli knows no hyphens in enumerations. */
  static final class StreamingConverter implements ITypeConverter<Streaming> {
    @Override
    public Streaming convert(String text) {
      return Choices.value(Streaming.values(), text);
    }
  }

  boolean isSweep() {
    return size == null;
  }

  int size() {
    return size;
  }

  /**
   * Sizes of a sweep.
   *
   * @throws UsageException if there is none, or one is out of its bounds
   */
  List<Integer> sizes() {
    if (sizes.isEmpty()) {
      throw new UsageException("sizes must number at least 1: sizes=0");
    }
    BundleShape any = BundleShape.parse("1");
    sizes.forEach(each -> UsageException.orRefused(() -> settings().duct(each, any)));
    return sizes.stream().distinct().toList();
  }

  /** The bundles that were given. */
  List<BundleShape> bundles() {
    return bundles == null ? List.of() : bundles;
  }

  /**
   * Rounds of a sweep.
   *
   * @throws UsageException if there is none, or there are far too many
   */
  int rounds() {
    if (rounds < 1 || rounds > MOST_ROUNDS) {
      throw new UsageException("rounds must number 1 to " + MOST_ROUNDS + ": rounds=" + rounds);
    }
    return rounds;
  }

  boolean store() {
    return !noStore && bundles().isEmpty();
  }

  DuctSettings settings() {
    return new DuctSettings(
        lattice, streaming, storage, kernel == null ? KernelForm.fastest() : kernel);
  }

  /**
   * How long a duct is run.
   *
   * @throws UsageException if the steps are out of their bounds
   */
  DuctRun run(Duct duct) {
    if (steps < 1 || steps > DuctRun.MOST) { // before it is made even
      throw new UsageException("steps must number 1 to " + DuctRun.MOST + ": steps=" + steps);
    }
    long warmUpSteps = warmUp == null ? DuctRun.warmUpFor(duct) : warmUp;
    DuctRun.Ending ending = steady ? DuctRun.Ending.STEADY : DuctRun.Ending.MEASURED;
    return UsageException.orRefused(
        () -> new DuctRun(warmUpSteps, steps + Math.floorMod(steps, 2), ending));
  }
}
