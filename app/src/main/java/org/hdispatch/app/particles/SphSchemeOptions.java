package org.hdispatch.app.particles;

import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.SearchMode;
import org.hdispatch.sph.SmoothingKernel;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.SumForm;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** How particles find and sum over their neighbours: what changes the speed and not the flow. */
final class SphSchemeOptions {
  @Option(
      names = "--search",
      paramLabel = "MODE",
      defaultValue = "verlet",
      completionCandidates = Choices.OfSearch.class,
      description =
          "When neighbours are searched for: ${COMPLETION-CANDIDATES}. Verlet lists last until a"
              + " particle may have moved half of a skin; single searches once a step, double once"
              + " for densities and once for forces.")
  private SearchMode search;

  @Option(
      names = "--cell-edge",
      paramLabel = "DX",
      description =
          "Edge of a cell, in distances of particles: what a worker takes at a time. At least the"
              + " support (verlet: and the skin). Default: as short as may be.")
  private Double cellEdge;

  @Mixin private final SumFormOption formOption = new SumFormOption();

  SearchMode search() {
    return search;
  }

  /**
   * The form of the sums.
   *
   * @throws UsageException if this Java does not run the one that was given
   */
  SumForm form(SmoothingKernel kernel) {
    return formOption.form(kernel);
  }

  /**
   * A scheme.
   *
   * @param spacing distance of particles, in the unit of length
   * @throws UsageException if the options do not fit the settings
   */
  SphScheme scheme(SphSchemeBuilder settings, double spacing, Particles particles) {
    settings.search(search).form(form(settings.kernel()));
    return UsageException.orRefused(
        () -> {
          if (cellEdge != null) {
            settings.cellEdge(cellEdge * spacing);
          }
          return settings.build(particles);
        });
  }
}
