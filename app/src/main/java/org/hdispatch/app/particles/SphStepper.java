package org.hdispatch.app.particles;

import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.StatusLine;
import org.hdispatch.app.watch.CollectorReport;
import org.hdispatch.app.watch.CollectorWatch;
import org.hdispatch.app.watch.RunListener;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.cases.SphFigures;
import org.hdispatch.sph.cases.SphRun;

/**
 * Steps particles and watches the collector and the user's patience meanwhile.
 *
 * @param console where progress is shown
 * @param options how neighbours are searched for and summed over
 * @param threads workers
 */
record SphStepper(CommandConsole console, SphSchemeOptions options, int threads) {
  /**
   * Runs a scheme.
   *
   * @param name of what is stepped
   * @param spacing distance of particles, in the unit of length
   */
  SphReport run(String name, SphScheme scheme, double spacing, SphRun run) {
    try (CollectorWatch collector = CollectorWatch.recording()) {
      SphFigures figures = measure(name, scheme, run, collector);
      var left =
          new CollectorReport(collector.figures(console), figures.stats(), figures.warmUpSteps());
      return new SphReport(figures, scheme, options, spacing, left);
    }
  }

  private SphFigures measure(String name, SphScheme scheme, SphRun run, CollectorWatch collector) {
    try (StatusLine status = new StatusLine(console.err());
        Dispatcher dispatcher = Dispatcher.withWorkers(threads)) {
      StatusLine shown = console.isWatched() ? status : null;
      return run.measure(dispatcher, scheme, new RunListener(collector, shown, name));
    }
  }
}
