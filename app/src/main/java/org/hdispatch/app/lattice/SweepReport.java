package org.hdispatch.app.lattice;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.Version;
import org.hdispatch.app.text.Columns;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.app.text.Table;
import org.hdispatch.app.watch.CollectorReport;
import org.hdispatch.lbm.duct.DuctFigures;
import org.hdispatch.lbm.duct.Spread;

/** A sweep for programs (the keys stay as they are) and for people. */
final class SweepReport {
  /** Ratio of bandwidths from which on runs differ by more than what they compare. */
  private static final double DISTURBED = 1.25;

  private SweepReport() {}

  /** One row a run. */
  static List<FlatRow> rows(SweepResult result) {
    return result.points().stream().map(point -> row(result, point)).toList();
  }

  private static FlatRow row(SweepResult result, SweepResult.Point point) {
    FlatRow row =
        DuctReport.row(point.figures())
            .put("probe_bytes", result.probeBytes())
            .put("bytes_per_step", CollectorReport.bytes(point.figures().stats()))
            .put("warm_up_steps", point.figures().run().warmUpSteps())
            .put("shape", point.label())
            .put("control", point.what().isControl())
            .put("speed_up", result.speedUp(point))
            .put("efficiency", result.efficiency(point))
            .put("bandwidth_speed_up", result.bandwidthSpeedUp(point.threads()))
            .put("ideal_mlups", result.idealMlups(point))
            .put("ideal_fraction", result.idealFraction(point))
            .put("recommended", result.recommended().filter(point::equals).isPresent());
    return Host.describe(row);
  }

  /**
   * The runs as a table, and what follows from them.
   *
   * @param stored what became of the recommendation
   */
  static String text(SweepResult result, String stored) {
    Columns columns =
        new Columns()
            .line(
                "bundle",
                "size",
                "threads",
                "MLUPS",
                "best",
                "GB/s",
                "of GB/s",
                "bytes/step",
                "speed-up",
                "efficiency",
                "ideal",
                "of ideal");
    for (String label : result.labels()) {
      for (SweepResult.Point point : result.points()) {
        if (point.label().equals(label)) {
          columns.line(cells(result, point));
        }
      }
    }
    Table table = new Table();
    table.line("stepped", result.settings() + ", Java " + Version.ofJava());
    result.points().stream().findFirst().ifPresent(any -> explain(table, result, any.figures()));
    result.recommended().ifPresent(best -> recommend(table, result, best, stored));
    return columns + System.lineSeparator() + table;
  }

  /** What the columns are; what they take from a run is the same for all. */
  private static void explain(Table table, SweepResult result, DuctFigures any) {
    table
        .line(
            "MLUPS, best",
            "10^6 node updates/s by the median of "
                + any.run().steps()
                + " steps, two by two; by the fastest two")
        .line(
            "GB/s",
            "read plus written in place beside each run, "
                + DuctReport.over(result.probeBytes())
                + "; a node and step need "
                + any.duct().bytesMovedPerNode()
                + " bytes")
        .line("efficiency", "speed-up over one thread, per thread")
        .line(
            "ideal",
            "MLUPS: threads times one thread's, or as many as GB/s let through, whichever is less");
  }

  private static String[] cells(SweepResult result, SweepResult.Point point) {
    var figures = point.figures();
    Long bytes = CollectorReport.bytes(figures.stats());
    return new String[] {
      point.label(),
      Integer.toString(point.side()),
      Integer.toString(point.threads()),
      fixed(figures.mlupsMedian()),
      fixed(figures.mlupsBest()),
      fixed(figures.gigabytesPerSecond().median()),
      percent(OptionalDouble.of(figures.bandwidthFraction())),
      bytes == null ? "unknown" : bytes.toString(),
      times(result.speedUp(point)),
      percent(result.efficiency(point)),
      fixed(result.idealMlups(point)),
      percent(result.idealFraction(point))
    };
  }

  private static void recommend(
      Table table, SweepResult result, SweepResult.Point best, String stored) {
    table.line(
        "recommended",
        String.format(
            Locale.ROOT,
            "%s: %.1f MLUPS with %s at %d^3, %s of the bandwidth",
            best.label(),
            best.mlups(),
            Numbers.threads(best.threads()),
            best.side(),
            percent(OptionalDouble.of(best.figures().bandwidthFraction()))));
    result
        .at(best.side(), SweepResult.CONTROL, best.threads())
        .ifPresent(
            block ->
                table.line(
                    "cost of bundles",
                    cost(best.mlups() / block.mlups())
                        + " one block a thread ("
                        + fixed(block.mlups())
                        + " MLUPS)"));
    if (best.threads() > 1 && result.speedUp(best).isPresent()) {
      table.line(
          "speed-up",
          times(result.speedUp(best))
              + ", efficiency "
              + percent(result.efficiency(best))
              + "; "
              + percent(result.idealFraction(best))
              + " of the ideal; the bandwidth's own speed-up: "
              + times(result.bandwidthSpeedUp(best.threads())));
    }
    for (int side : result.sides()) {
      if (side != best.side()) {
        transfer(table, result, best, side);
      }
    }
    result.bandwidth(best.threads()).ifPresent(spread -> disturbed(table, best, spread));
    table.line("stored", stored);
  }

  /** Speeds measured while the bandwidth was not the same cannot be compared. */
  private static void disturbed(Table table, SweepResult.Point best, Spread bandwidth) {
    if (bandwidth.most() > DISTURBED * bandwidth.least()) {
      table.line(
          "DISTURBED",
          "the bandwidth with "
              + Numbers.threads(best.threads())
              + " was between "
              + fixed(bandwidth.least())
              + " and "
              + fixed(bandwidth.most())
              + " GB/s: give more --rounds, or a quieter machine");
    }
  }

  private static String cost(double ratio) {
    return ratio < 1
        ? Numbers.percent(1 - ratio) + " against"
        : "none, " + Numbers.percent(ratio - 1) + " faster than";
  }

  /** Whether what is best at one size is good at another (the claim of the paper). */
  private static void transfer(Table table, SweepResult result, SweepResult.Point best, int side) {
    Optional<SweepResult.Point> there = result.at(side, best.label(), best.threads());
    Optional<SweepResult.Point> bestThere = result.best(side);
    if (there.isPresent() && bestThere.isPresent()) {
      table.line(
          "at " + side + "^3",
          fixed(there.get().mlups())
              + " MLUPS, "
              + (there.equals(bestThere)
                  ? "the best there too"
                  : Numbers.percent(1 - there.get().mlups() / bestThere.get().mlups())
                      + " behind the best there ("
                      + bestThere.get().label()
                      + ")"));
    }
  }

  private static String fixed(double value) {
    return String.format(Locale.ROOT, "%.1f", value);
  }

  private static String fixed(OptionalDouble value) {
    return value.isPresent() ? fixed(value.getAsDouble()) : "-";
  }

  private static String times(OptionalDouble value) {
    return value.isPresent() ? String.format(Locale.ROOT, "%.2f", value.getAsDouble()) : "-";
  }

  private static String percent(OptionalDouble share) {
    return share.isPresent()
        ? String.format(Locale.ROOT, "%.1f %%", 100 * share.getAsDouble())
        : "-";
  }
}
