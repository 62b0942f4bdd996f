package org.hdispatch.app.particles;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.app.console.OutputOptions;
import org.hdispatch.app.console.StandardOptions;
import org.hdispatch.app.console.StatusLine;
import org.hdispatch.app.console.ThreadOptions;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.app.rock.ImageOptions;
import org.hdispatch.app.rock.ImageSource;
import org.hdispatch.app.rock.Rock;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.pore.PoreSpace;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.QuinticSpline;
import org.hdispatch.sph.SearchMode;
import org.hdispatch.sph.SumForm;
import org.hdispatch.sph.cases.PeriodicShear;
import org.hdispatch.sph.cases.SphRun;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code hdispatch search-study}: single against double search of neighbours. */
@Command(
    name = "search-study",
    description = {
      "Compare searches of neighbours on fluid in rock: double, single and Verlet lists, with"
          + " several edges of cells and 1 to N threads (Leonardi et al. 2011, figure 3).",
      "Without IMAGE: the bundled sample of Berea sandstone."
    })
public final class SearchStudyCommand implements Callable<Integer> {
  private static final int MOST_ROUNDS = 1000;
  private static final double SUPPORT = 3;
  private static final int VOXEL_BYTES = 13; // of walls, while they are made, and of the pores

  private final Host host;

  @Mixin private final ImageOptions imageOptions = new ImageOptions();

  @Option(
      names = "--particles",
      paramLabel = "N",
      description =
          "Continue the rock by its mirror images until it has about so many particles at least;"
              + " the paper has 1400000. Default: none, the rock alone.")
  private Long wanted;

  @Option(
      names = "--periodic",
      paramLabel = "N",
      description =
          "Not rock, but a shear flow in a periodic box of so many particles, a cube. Default:"
              + " none, rock.")
  private Integer periodic;

  @Option(
      names = "--cell-edges",
      paramLabel = "DX",
      split = ",",
      hideParamSyntax = true,
      defaultValue = "3.3,4.5,6",
      description =
          "Edges of cells, in distances of particles, such as 3.3,6: what a worker takes at a time;"
              + " at least 3.3, the support and the skin.")
  private List<Double> edges;

  @Option(
      names = "--rounds",
      paramLabel = "R",
      defaultValue = "3",
      description = "How often all runs are made; medians count (1 to 1000).")
  private int rounds;

  @Option(
      names = "--steps",
      paramLabel = "M",
      defaultValue = "40",
      description = "Steps to measure in each run.")
  private long steps;

  @Option(
      names = "--warm-up",
      paramLabel = "M",
      description = "Steps before those. Default: 20, more for few particles.")
  private Long warmUp;

  @Mixin private final SumFormOption formOption = new SumFormOption();
  @Mixin private final ThreadOptions threadOptions = new ThreadOptions();
  @Mixin private final OutputOptions output = new OutputOptions();
  @Mixin private final StandardOptions standard = new StandardOptions();
  @Spec private CommandSpec spec;

  /**
   * Makes the command.
   *
   * @param host what it runs in
   */
  public SearchStudyCommand(Host host) {
    this.host = host;
  }

  @Override
  public Integer call() throws ImageFileException {
    output.folder();
    threadOptions.threads();
    checkNumbers();
    SumForm form = formOption.form(new QuinticSpline(SUPPORT / 3, 3));
    if (output.folder().isEmpty()) {
      study(form, Optional.empty());
    } else {
      try (OutputFolder folder = OutputFolder.open(output.folder().get())) {
        study(form, Optional.of(folder));
      }
    }
    return ExitCode.DONE.code();
  }

  private void checkNumbers() {
    if (rounds < 1 || rounds > MOST_ROUNDS) {
      throw new UsageException("rounds must number 1 to " + MOST_ROUNDS + ": rounds=" + rounds);
    }
    if (edges.isEmpty()) {
      throw new UsageException("cell edges must number at least 1: edges=0");
    }
    if (wanted != null && wanted < 1) {
      throw new UsageException("particles must number at least 1: particles=" + wanted);
    }
    if (periodic != null) {
      for (String each : ImageOptions.NAMES) {
        refuseBesidePeriodic(each);
      }
      refuseBesidePeriodic("--particles");
      if (imageOptions.image().isPresent()) {
        throw new UsageException("--periodic must come without an IMAGE: --periodic=" + periodic);
      }
    }
  }

  private void refuseBesidePeriodic(String option) {
    if (spec.commandLine().getParseResult().hasMatchedOption(option)) {
      throw new UsageException(option + " must come without --periodic");
    }
  }

  private void study(SumForm form, Optional<OutputFolder> folder) throws ImageFileException {
    UsageException.orRefused(() -> new SphRun(warmUp == null ? 1 : warmUp, steps));
    SearchFlow flow = periodic == null ? rock() : box();
    int count = flow.particles().count();
    SphRun run = new SphRun(warmUp == null ? SphRun.warmUpFor(count) : warmUp, steps);
    int[] threads = ThreadOptions.upTo(threadOptions.threads());
    SearchStudy study =
        new SearchStudy(flow, form, run, edges.stream().distinct().toList(), threads, rounds);
    UsageException.orRefused(study::checked);
    CommandConsole console = new CommandConsole(spec, host, output.quiet());
    SearchResult result;
    try (StatusLine status = new StatusLine(console.err())) {
      result =
          study.result(
              (what, number, all) -> {
                if (console.isWatched()) {
                  status.show("run " + number + " of " + all + "  " + what);
                }
              });
    }
    List<FlatRow> rows = SearchReport.rows(result);
    console.print(output.form(rows, SearchReport.text(result)));
    if (folder.isPresent()) {
      folder.get().write("search.csv", FlatRow.toCsv(rows));
      folder.get().write("search.json", FlatRow.toJson(rows));
      folder.get().write("speed-up.svg", SearchPlots.speedUp(result));
      folder.get().write("cell-edge.svg", SearchPlots.speedByEdge(result));
    }
  }

  private SearchFlow box() {
    PeriodicShear shear = SphPeriodicCommand.shear(periodic, SUPPORT);
    SphHeap.require(host, SearchMode.VERLET, 3, shear.count(), SUPPORT);
    return new SearchFlow(
        String.format(Locale.ROOT, "shear flow in a periodic box of %d^3 particles", shear.edge()),
        shear::settings,
        shear.particles());
  }

  private SearchFlow rock() throws ImageFileException {
    ImageSource source = ImageSource.of(imageOptions);
    VoxelImage image = Rock.read(source, Rock.boxOf(source, imageOptions.box()), host);
    PoreSpace space = PoreSpace.of(image, imageOptions.rule());
    if (space.poreVoxels() == 0) {
      throw new ImageFileException(
          "image must have pore voxels (--pore-value says which are pore): file=" + source.name());
    }
    int[] repeats = {1, 1, 1};
    RockFlow flow = rock(space, repeats);
    Particles particles = flow.particles();
    if (wanted != null && wanted > particles.count()) {
      repeats = RockFlow.repeats(particles.count(), wanted);
      double all = (double) repeats[0] * repeats[1] * repeats[2];
      SphHeap.require(host, SearchMode.VERLET, 3, all * particles.count(), SUPPORT);
      host.requireHeap("walls of " + all + " rocks", VOXEL_BYTES * all * space.voxels());
      flow = rock(space, repeats);
      particles = flow.particles();
    }
    SphHeap.require(host, SearchMode.VERLET, 3, particles.count(), SUPPORT);
    String name =
        String.format(
            Locale.ROOT,
            "%s, %d x %d x %d voxels, %d x %d x %d times",
            source.name(),
            space.nx(),
            space.ny(),
            space.nz(),
            repeats[0],
            repeats[1],
            repeats[2]);
    return new SearchFlow(name, flow::settings, particles);
  }

  private static RockFlow rock(PoreSpace space, int[] repeats) {
    return UsageException.orRefused(() -> new RockFlow(space, repeats));
  }
}
