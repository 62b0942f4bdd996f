package org.hdispatch.app.lattice;

import java.util.Locale;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Version;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.app.text.Table;
import org.hdispatch.app.watch.CollectorReport;
import org.hdispatch.lbm.BundleSize;
import org.hdispatch.lbm.duct.BandwidthProbe;
import org.hdispatch.lbm.duct.Duct;
import org.hdispatch.lbm.duct.DuctFigures;

/** The figures of one duct, for programs (the keys stay as they are) and for people. */
final class DuctReport {
  /** Bytes of a probe that the caches of a large processor may hold. */
  private static final long CACHED = 128L << 20;

  private static final int DIGITS = 5;
  private static final int FEW = 3;

  private DuctReport() {}

  /** Speed, bandwidth, flow and settings. */
  static FlatRow row(DuctFigures figures) {
    Duct duct = figures.duct();
    return new FlatRow()
        .put("mlups_median", figures.mlupsMedian())
        .put("mlups_best", figures.mlupsBest())
        .put("bandwidth_GBps", figures.gigabytesPerSecond().median())
        .put("bandwidth_fraction", figures.bandwidthFraction())
        .put("bytes_per_node", figures.bytesHeldPerNode())
        .put("bytes_moved_per_node", duct.bytesMovedPerNode())
        .put("seconds_per_step", figures.secondsPerStep().median())
        .put("k_over_w2", figures.kOverW2())
        .put("k_over_w2_series", Duct.K_OVER_W2)
        .put("steady", figures.steady())
        .put("start_up_left", figures.startUpLeft())
        .put("size", duct.side())
        .put("bundle", size(duct.bundle()))
        .put("bundles", figures.bundles())
        .put("threads", figures.threads())
        .put("lattice", duct.velocitySet().name())
        .put("storage", Choices.word(duct.storage()))
        .put("streaming", Choices.word(duct.streaming()))
        .put("kernel", Choices.word(duct.kernel()))
        .put("steps", figures.run().steps())
        .put("last_step", figures.lastStep())
        .put("bandwidth_least_GBps", figures.gigabytesPerSecond().least())
        .put("bandwidth_most_GBps", figures.gigabytesPerSecond().most());
  }

  private static String size(BundleSize bundle) {
    return bundle.nx() + "," + bundle.ny() + "," + bundle.nz();
  }

  /**
   * One duct as a table.
   *
   * @param origin who said which bundle
   */
  static String text(
      DuctFigures figures, String origin, BandwidthProbe probe, CollectorReport collector) {
    Table table = new Table();
    settings(table, figures, origin);
    speed(table, figures, probe);
    flow(table, figures);
    table.line("threads", figures.threads() + ", Java " + Version.ofJava());
    collector.putInto(table);
    return table.toString();
  }

  /** Over how much a bandwidth was measured. */
  static String over(long probeBytes) {
    String over = "over " + (probeBytes >> 20) + " MiB";
    return probeBytes < CACHED ? over + ": a CACHE may hold that, give more heap" : over;
  }

  private static void settings(Table table, DuctFigures figures, String origin) {
    Duct duct = figures.duct();
    BundleSize bundle = duct.bundle();
    table
        .line(
            "duct",
            String.format(
                "%d x %1$d x %1$d nodes, periodic along x, walls at y and z", duct.side()))
        .line(
            "bundle",
            String.format(
                "%d x %d x %d nodes (%s), %d of them",
                bundle.nx(), bundle.ny(), bundle.nz(), origin, figures.bundles()))
        .line(
            "method",
            "lattice Boltzmann, " + duct.velocitySet() + ", TRT, tau 1, quadratic equilibrium")
        .line(
            "streaming",
            String.format(
                "%s, %s, kernel %s",
                Choices.word(duct.streaming()),
                Choices.word(duct.storage()),
                Choices.word(duct.kernel())));
  }

  private static void speed(Table table, DuctFigures figures, BandwidthProbe probe) {
    Duct duct = figures.duct();
    table
        .line(
            "speed",
            String.format(
                Locale.ROOT,
                "%.1f MLUPS median, %.1f best (%d steps, two by two, %s s each)",
                figures.mlupsMedian(),
                figures.mlupsBest(),
                figures.run().steps(),
                Numbers.significant(figures.secondsPerStep().median(), FEW)))
        .line(
            "bandwidth",
            String.format(
                Locale.ROOT,
                "%.1f GB/s read plus written in place beside it (%.1f to %.1f, %s)",
                figures.gigabytesPerSecond().median(),
                figures.gigabytesPerSecond().least(),
                figures.gigabytesPerSecond().most(),
                over(probe.bytes())))
        .line(
            "of the bandwidth",
            Numbers.percent(figures.bandwidthFraction())
                + " ("
                + duct.bytesMovedPerNode()
                + " bytes to move a node and step)")
        .line(
            "memory",
            String.format(Locale.ROOT, "%.1f bytes held a node", figures.bytesHeldPerNode()));
  }

  private static void flow(Table table, DuctFigures figures) {
    String state =
        figures.steady()
            ? "steady, "
                + Numbers.percent(figures.kOverW2() / Duct.K_OVER_W2 - 1)
                + " from the series' "
            : "NOT STEADY, "
                + Numbers.percent(figures.startUpLeft())
                + " of the start-up left, series ";
    table.line(
        "k/W2",
        Numbers.significant(figures.kOverW2(), DIGITS)
            + " after "
            + figures.lastStep()
            + " steps ("
            + state
            + Duct.K_OVER_W2
            + ")");
  }
}
