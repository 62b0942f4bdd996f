package org.hdispatch.app.particles;

import java.util.Locale;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.Version;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.app.text.Table;
import org.hdispatch.app.watch.CollectorReport;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphTimes;
import org.hdispatch.sph.cases.SphFigures;

/**
 * How fast particles were stepped, for programs (the keys stay as they are) and for people.
 *
 * @param figures what was measured
 * @param scheme what was stepped
 * @param options how it searched and summed
 * @param spacing distance of particles, in the unit of length
 * @param collector what was left for the garbage collector
 */
record SphReport(
    SphFigures figures,
    SphScheme scheme,
    SphSchemeOptions options,
    double spacing,
    CollectorReport collector) {
  private static final int FEW = 3;

  /** Speed, work, settings. */
  FlatRow row() {
    return putInto(new FlatRow());
  }

  /** Adds speed, work, settings. */
  FlatRow putInto(FlatRow row) {
    SphTimes seconds = figures.seconds();
    row.put("particle_steps_per_s", figures.particleStepsPerSecond())
        .put("neighbours_mean", figures.neighboursMean())
        .put("pairs_per_s", figures.pairsPerSecond())
        .put("bytes_per_particle", figures.bytesPerParticle())
        .put("bytes_per_step", CollectorReport.bytes(figures.stats()))
        .put("seconds_search", seconds.search())
        .put("seconds_density", seconds.density())
        .put("seconds_force", seconds.force())
        .put("rebuilds", figures.rebuilds())
        .put("seconds", figures.wallSeconds())
        .put("particles", figures.particles())
        .put("fluid_particles", figures.fluidParticles())
        .put("cells", figures.cells())
        .put("threads", figures.threads())
        .put("search", Choices.word(options.search()))
        .put("support", scheme.kernel().supportRadius() / spacing)
        .put("cell_edge", scheme.cellEdge() / spacing)
        .put("steps", figures.stats().steps())
        .put("warm_up_steps", figures.warmUpSteps())
        .put("form", Choices.word(options.form(scheme.kernel())));
    collector.putInto(row);
    return Host.describe(row);
  }

  /** Adds the lines on speed and settings. */
  void putInto(Table table) {
    table
        .line("kernel", scheme.kernel().toString())
        .line(
            "neighbours",
            String.format(
                Locale.ROOT,
                "%.1f within the support of %s dx, %s search, %d times in %d steps",
                figures.neighboursMean(),
                Numbers.significant(scheme.kernel().supportRadius() / spacing, FEW),
                Choices.word(options.search()),
                figures.rebuilds(),
                figures.stats().steps()))
        .line(
            "cells",
            String.format(
                Locale.ROOT,
                "%d of %s dx, %.1f particles in each",
                figures.cells(),
                Numbers.significant(scheme.cellEdge() / spacing, FEW),
                (double) figures.particles() / figures.cells()))
        .line(
            "speed",
            String.format(
                Locale.ROOT,
                "%s MPUPS, %s million pairs/s (%d steps in %.2f s, %s sums)",
                Numbers.significant(1e-6 * figures.particleStepsPerSecond(), FEW),
                Numbers.significant(1e-6 * figures.pairsPerSecond(), FEW),
                figures.stats().steps(),
                figures.wallSeconds(),
                Choices.word(options.form(scheme.kernel()))))
        .line("work", work())
        .line(
            "memory",
            String.format(Locale.ROOT, "%.0f bytes held a particle", figures.bytesPerParticle()))
        .line("threads", figures.threads() + ", Java " + Version.ofJava());
    collector.putInto(table);
  }

  private String work() {
    SphTimes seconds = figures.seconds();
    double rest = figures.wallSeconds() - seconds.search() - seconds.density() - seconds.force();
    return "search "
        + share(seconds.search())
        + ", densities "
        + share(seconds.density())
        + ", forces "
        + share(seconds.force())
        + ", rest "
        + share(rest)
        + " of the time";
  }

  private String share(double seconds) {
    return Numbers.percent(seconds / figures.wallSeconds());
  }
}
