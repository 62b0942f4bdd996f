package org.hdispatch.app.steady;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.Version;
import org.hdispatch.app.text.Columns;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.app.text.Table;

/** A study of steady states for programs (the keys stay as they are) and for people. */
final class SteadyReport {
  private SteadyReport() {}

  /** One row for each rock and approach. */
  static List<FlatRow> rows(SteadyResult result) {
    List<FlatRow> rows = new ArrayList<>();
    for (SteadyComparison each : result.rocks()) {
      each.courses().forEach(course -> rows.add(row(result, each, course)));
    }
    return rows;
  }

  private static FlatRow row(SteadyResult result, SteadyComparison each, SteadyCourse course) {
    FlatRow row =
        new FlatRow()
            .put("rock", each.rock().name())
            .put("porosity", each.porosity())
            .put("approach", Choices.word(course.approach()))
            .put("permeability_voxel2", each.reference().permeability())
            .put("permeability_mD", each.permeability().milliDarcy());
    for (double share : SteadyResult.SHARES) {
      String key = share == 1e-2 ? "_to_1_percent" : "_to_0_1_percent";
      Optional<SteadyCourse.Point> point = course.within(share);
      row.put("steps" + key, point.map(SteadyCourse.Point::step).orElse(null))
          .put("seconds" + key, point.map(SteadyCourse.Point::seconds).orElse(null))
          .put("steps_ratio" + key, each.stepsRatio(course, share))
          .put("seconds_ratio" + key, each.secondsRatio(course, share));
    }
    Optional<SteadyCourse.Point> stop = course.stop();
    row.put("stopped", stop.isPresent())
        .put("steps_at_stop", stop.map(SteadyCourse.Point::step).orElse(null))
        .put("seconds_at_stop", stop.map(SteadyCourse.Point::seconds).orElse(null))
        .put("seconds_pressure_at_stop", stop.map(SteadyCourse.Point::secondsPressure).orElse(null))
        .put("k_error_estimate_at_stop", stop.map(SteadyCourse.Point::errorEstimate).orElse(null))
        .put("k_error_at_stop", stop.map(course::error).orElse(null))
        .put("steps_run", course.last().step())
        .put("k_error_at_end", course.error(course.last()))
        .put("tau", course.relaxationTime())
        .put("steps_between_measurements", course.interval())
        .put("reference_converged", each.reference().converged())
        .put("reference_error_estimate", each.reference().errorEstimate())
        .put("reference_steps", each.reference().steps())
        .put("porosity_connected", each.reference().connectedPorosity())
        .put("fluid_nodes", each.reference().fluidNodes())
        .put("inlet_layers", each.reference().inletLayers())
        .put("nx", each.rock().space().nx())
        .put("ny", each.rock().space().ny())
        .put("nz", each.rock().space().nz())
        .put("axis", Choices.word(result.options().axis()))
        .put("tolerance", result.options().tolerance())
        .put("max_steps", result.options().maxSteps())
        .put("threads", result.threads())
        .putAll(each.rock().origin());
    return Host.describe(row);
  }

  /** One row for each measurement. */
  static List<FlatRow> curves(SteadyResult result) {
    List<FlatRow> rows = new ArrayList<>();
    for (SteadyComparison each : result.rocks()) {
      for (SteadyCourse course : each.courses()) {
        for (SteadyCourse.Point point : course.points()) {
          rows.add(
              new FlatRow()
                  .put("rock", each.rock().name())
                  .put("porosity", each.porosity())
                  .put("approach", Choices.word(course.approach()))
                  .put("step", point.step())
                  .put("seconds", point.seconds())
                  .put("seconds_pressure", point.secondsPressure())
                  .put("permeability_voxel2", point.permeability())
                  .put("k_error", course.error(point))
                  .put("k_error_estimate", point.errorEstimate()));
        }
      }
    }
    return rows;
  }

  /** Headings of the columns of {@link #arrivals}. */
  static final List<String> ARRIVALS =
      List.of("porosity", "k, voxel2", "approach", "to 1 %", "s", "to 0.1 %", "s");

  /** For each rock both approaches and their ratio: steps and seconds until k stays that close. */
  static List<List<String>> arrivals(SteadyResult result) {
    List<List<String>> lines = new ArrayList<>();
    for (SteadyComparison each : result.rocks()) {
      String porosity = Numbers.plain(each.porosity(), 3);
      String k = Numbers.significant(each.reference().permeability(), 4);
      for (SteadyCourse course : each.courses()) {
        List<String> line = new ArrayList<>(List.of(porosity, k, Choices.word(course.approach())));
        for (double share : SteadyResult.SHARES) {
          line.add(steps(course.within(share)));
          line.add(seconds(course.within(share)));
        }
        lines.add(line);
        porosity = "";
        k = "";
      }
      List<String> ratios = new ArrayList<>(List.of("", "", "ratio"));
      for (double share : SteadyResult.SHARES) {
        ratios.add(times(each.stepsRatio(each.plain(), share)));
        ratios.add(times(each.secondsRatio(each.plain(), share)));
      }
      lines.add(ratios);
    }
    return lines;
  }

  /** Headings of the columns of {@link #stops}. */
  static final List<String> STOPS =
      List.of("porosity", "approach", "stopped after", "s", "estimate", "true error");

  /** For each rock and approach what the stop rule said, and when. */
  static List<List<String>> stops(SteadyResult result) {
    List<List<String>> lines = new ArrayList<>();
    for (SteadyComparison each : result.rocks()) {
      String porosity = Numbers.plain(each.porosity(), 3);
      for (SteadyCourse course : each.courses()) {
        Optional<SteadyCourse.Point> stop = course.stop();
        lines.add(
            List.of(
                porosity,
                Choices.word(course.approach()),
                steps(stop),
                seconds(stop),
                stop.map(point -> percent(point.errorEstimate())).orElse("-"),
                stop.map(point -> percent(course.error(point))).orElse("-")));
        porosity = "";
      }
    }
    return lines;
  }

  /** All of it as text. */
  static String text(SteadyResult result) {
    Table table = new Table();
    for (SteadyComparison each : result.rocks()) {
      table.line("porosity " + Numbers.plain(each.porosity(), 3), rock(each));
    }
    table.line(
        "steps, s",
        "until k stays that close to its steady value; s with pressure, without measuring k");
    table.line(
        "stopped",
        "where the stop rule found the flow steady at "
            + Numbers.plainPercent(result.options().tolerance()));
    table.line("threads", result.threads() + ", Java " + Version.ofJava());
    StringBuilder verdict = new StringBuilder();
    for (String sentence : new SteadyVerdict(result).sentences()) {
      verdict.append(sentence).append(System.lineSeparator());
    }
    String blank = System.lineSeparator();
    return columns(ARRIVALS, arrivals(result))
        + blank
        + columns(STOPS, stops(result))
        + blank
        + table
        + blank
        + verdict;
  }

  /** A rock and how it was computed, in a line. */
  static String rock(SteadyComparison each) {
    OptionalDouble milliDarcy = each.permeability().milliDarcy();
    return each.rock().name()
        + (each.rock().origin().containsKey("box") ? " " + each.rock().origin().get("box") : "")
        + ", connected "
        + Numbers.significant(each.reference().connectedPorosity(), 3)
        + ", k "
        + Numbers.significant(each.reference().permeability(), 5)
        + " voxel2"
        + (milliDarcy.isPresent()
            ? " = " + Numbers.significant(milliDarcy.getAsDouble(), 5) + " mD"
            : "")
        + ", "
        + each.reference().fluidNodes()
        + " fluid nodes, tau "
        + Numbers.significant(each.corrected().relaxationTime(), 3)
        + " corrected, "
        + Numbers.significant(each.plain().relaxationTime(), 3)
        + " plain";
  }

  private static Columns columns(List<String> head, List<List<String>> lines) {
    Columns columns = new Columns().line(head.toArray(String[]::new));
    lines.forEach(line -> columns.line(line.toArray(String[]::new)));
    return columns;
  }

  private static String steps(Optional<SteadyCourse.Point> point) {
    return point.map(each -> Long.toString(each.step())).orElse("-");
  }

  private static String seconds(Optional<SteadyCourse.Point> point) {
    return point.map(each -> String.format(Locale.ROOT, "%.2f", each.seconds())).orElse("-");
  }

  private static String times(OptionalDouble ratio) {
    return ratio.isPresent() ? Numbers.plain(ratio.getAsDouble(), 2) + " x" : "-";
  }

  private static String percent(double share) {
    return Numbers.plain(100 * share, 2) + " %";
  }
}
