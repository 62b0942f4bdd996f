package org.hdispatch.app.particles;

import java.util.ArrayList;
import java.util.List;
import org.hdispatch.app.console.Choices;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.sph.SearchMode;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;
import org.hdispatch.sph.SumForm;
import org.hdispatch.sph.cases.SphFigures;
import org.hdispatch.sph.cases.SphRun;

/**
 * Each search of neighbours with each edge of cells on each number of threads (Leonardi et al.
 * 2011, figure 3), in several rounds: all runs once, then all again, so that what disturbs the
 * machine for a while disturbs all of them alike.
 *
 * @param flow what is stepped
 * @param form of the sums
 * @param run how long
 * @param edges of cells, in distances of particles
 * @param threads numbers of workers
 * @param rounds how often
 */
record SearchStudy(
    SearchFlow flow, SumForm form, SphRun run, List<Double> edges, int[] threads, int rounds) {
  /** In the order of the paper: double and single search; and lists that last. */
  private static final List<SearchMode> MODES =
      List.of(SearchMode.DOUBLE, SearchMode.SINGLE, SearchMode.VERLET);

  /** Hears how a study goes on. */
  @FunctionalInterface
  interface Listener {
    /**
     * A run begins.
     *
     * @param what it is, in words
     * @param number its number, from 1
     * @param count how many runs there are
     */
    void begins(String what, int number, int count);
  }

  private record Case(SearchMode mode, double edge, int threads) {
    @Override
    public String toString() {
      return Choices.word(mode) + "  cells " + edge + "  threads " + threads;
    }
  }

  /**
   * This study, if each of its cells may have its edge.
   *
   * @throws IllegalArgumentException if an edge is too short
   */
  SearchStudy checked() {
    for (double edge : edges) {
      scheme(new Case(SearchMode.VERLET, edge, 1)); // needs the longest cells
    }
    return this;
  }

  /** Runs it. */
  SearchResult result(Listener listener) {
    List<Case> cases = cases();
    List<List<SphFigures>> figures = new ArrayList<>();
    double[] fitting = new double[cases.size()];
    cases.forEach(each -> figures.add(new ArrayList<>()));
    for (int n = 0; n < rounds * cases.size(); n++) {
      int at = n % cases.size();
      Case each = cases.get(at);
      listener.begins(each.toString(), n + 1, rounds * cases.size());
      SphScheme scheme = scheme(each);
      fitting[at] = scheme.cellEdge();
      try (Dispatcher dispatcher = Dispatcher.withWorkers(each.threads())) {
        figures.get(at).add(run.measure(dispatcher, scheme, SphRun.Listener.NONE));
      }
    }
    List<SearchResult.Point> points = new ArrayList<>();
    for (int n = 0; n < fitting.length; n++) {
      Case each = cases.get(n);
      points.add(
          new SearchResult.Point(
              each.mode(), each.threads(), each.edge(), fitting[n], figures.get(n)));
    }
    return new SearchResult(flow.name(), form, points);
  }

  private List<Case> cases() {
    List<Case> cases = new ArrayList<>();
    for (double edge : edges) {
      for (SearchMode mode : MODES) {
        for (int workers : threads) {
          cases.add(new Case(mode, edge, workers));
        }
      }
    }
    return cases;
  }

  private SphScheme scheme(Case of) {
    SphSchemeBuilder settings = flow.settings().get();
    return settings.search(of.mode()).cellEdge(of.edge()).form(form).build(flow.particles());
  }
}
