package org.hdispatch.app.particles;

import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.app.console.OutputOptions;
import org.hdispatch.app.console.StandardOptions;
import org.hdispatch.app.console.ThreadOptions;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Table;
import org.hdispatch.app.watch.GcReportOption;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.cases.PeriodicShear;
import org.hdispatch.sph.cases.SphRun;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code hdispatch sph periodic}: how fast particles in a periodic box are stepped. */
@Command(
    name = "periodic",
    description = {
      "Measure how fast the particles of one fluid are stepped: a shear flow in a periodic box, in"
          + " 3-D, quintic spline.",
    })
final class SphPeriodicCommand implements Callable<Integer> {
  private final Host host;

  @Option(
      names = "--particles",
      paramLabel = "N",
      defaultValue = "216000",
      description = "Particles in all: the cube of a number.")
  private int particles;

  @Option(
      names = "--support",
      paramLabel = "DX",
      defaultValue = "3.0",
      description = "Support radius of the smoothing kernel, in distances of particles.")
  private double support;

  @Option(
      names = "--steps",
      paramLabel = "M",
      defaultValue = "40",
      description = "Steps to measure.")
  private long steps;

  @Option(
      names = "--warm-up",
      paramLabel = "M",
      description =
          "Steps before those. Default: 20, more for few particles. Cells that fill up"
              + " still grow after that, more and more seldom.")
  private Long warmUp;

  @Mixin private final SphSchemeOptions options = new SphSchemeOptions();
  @Mixin private final ThreadOptions threadOptions = new ThreadOptions();
  @Mixin private final OutputOptions output = new OutputOptions();
  @Mixin private final GcReportOption gcReport = new GcReportOption();
  @Mixin private final StandardOptions standard = new StandardOptions();
  @Spec private CommandSpec spec;

  SphPeriodicCommand(Host host) {
    this.host = host;
  }

  @Override
  public Integer call() throws ImageFileException {
    output.folder();
    threadOptions.threads();
    PeriodicShear shear = shear(particles, support);
    SphRun run =
        UsageException.orRefused(
            () -> new SphRun(warmUp == null ? SphRun.warmUpFor(shear.count()) : warmUp, steps));
    SphSchemeBuilder settings = UsageException.orRefused(shear::settings);
    options.form(settings.kernel());
    gcReport.check();
    if (output.folder().isEmpty()) {
      measure(shear, settings, run, Optional.empty());
    } else {
      try (OutputFolder folder = OutputFolder.open(output.folder().get())) {
        measure(shear, settings, run, Optional.of(folder));
      }
    }
    return ExitCode.DONE.code();
  }

  private void measure(
      PeriodicShear shear, SphSchemeBuilder settings, SphRun run, Optional<OutputFolder> folder)
      throws ImageFileException {
    SphHeap.require(host, options.search(), 3, shear.count(), shear.support());
    SphScheme scheme = options.scheme(settings, 1, shear.particles());
    CommandConsole console = new CommandConsole(spec, host, output.quiet());
    SphStepper stepper = new SphStepper(console, options, threadOptions.threads());
    SphReport report = stepper.run("periodic", scheme, 1, run);
    FlatRow row = report.row();
    Table table =
        new Table()
            .line(
                "case",
                String.format(
                    Locale.ROOT,
                    "shear flow in a periodic box, %d particles (%d^3)",
                    shear.count(),
                    shear.edge()));
    report.putInto(table);
    console.print(output.form(row, table.toString()));
    if (folder.isPresent()) {
      new ParticleFiles(scheme, 1).write(folder.get());
      folder.get().write("sph.json", row.toJson());
    }
    gcReport.write(report.collector());
  }

  /**
   * The box of so many particles.
   *
   * @throws UsageException if they are not a cube, or too few
   */
  static PeriodicShear shear(int particles, double support) {
    int edge = (int) Math.round(Math.cbrt(particles));
    if (particles < 1 || (long) edge * edge * edge != particles) {
      throw new UsageException("particles must number a cube: particles=" + particles);
    }
    return UsageException.orRefused(() -> new PeriodicShear(edge, support));
  }
}
