package org.hdispatch.app.permeability;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Version;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.app.text.Table;
import org.hdispatch.lbm.Storage;
import org.hdispatch.porous.block.Method;
import org.hdispatch.porous.darcy.Permeability;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.flow.SteadyFlow;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.PoreSpace;

/** A permeability as a table for people. */
final class OutcomeTable {
  private static final int DIGITS = 5;
  private static final int FEW = 3;

  private OutcomeTable() {}

  static String of(Outcome outcome) {
    Table table = new Table();
    rock(table, outcome);
    permeability(table, outcome);
    flow(table, outcome);
    computation(table, outcome);
    collector(table, outcome);
    String cite = "cite";
    for (String line : outcome.rock().citation()) {
      table.line(cite, line);
      cite = "";
    }
    return table.toString();
  }

  private static void rock(Table table, Outcome outcome) {
    PoreSpace space = outcome.rock().space();
    OptionalDouble edge = outcome.rock().voxelEdge();
    String axis = Choices.word(outcome.options().axis());
    table
        .line("rock", outcome.rock().name())
        .line(
            "size",
            String.format("%d x %d x %d voxels", space.nx(), space.ny(), space.nz())
                + (edge.isPresent() ? " of " + edge.getAsDouble() + " m" : ", edge unknown"))
        .line(
            "porosity",
            Numbers.significant(outcome.flow().porosity(), DIGITS)
                + ", connected along "
                + axis
                + " "
                + Numbers.significant(outcome.connectedPorosity(), DIGITS))
        .line(
            "percolates",
            outcome.percolates() ? "yes, along " + axis : "NO, nothing spans " + axis + ": k = 0");
  }

  private static void permeability(Table table, Outcome outcome) {
    SteadyFlow flow = outcome.flow();
    Permeability k = outcome.permeability();
    String voxel2 = Numbers.significant(k.voxel2(), DIGITS) + " voxel2";
    table.line(
        "permeability",
        k.milliDarcy().isPresent()
            ? Numbers.significant(k.milliDarcy().getAsDouble(), DIGITS)
                + " mD = "
                + Numbers.significant(k.squareMetres().getAsDouble(), DIGITS)
                + " m2 = "
                + voxel2
            : voxel2 + " (mD and m2 need --voxel-edge)");
    if (outcome.flow().column().isPresent()) {
      table.line("across the flow", across(outcome));
    }
    if (outcome.percolates()) {
      table.line(
          "error estimate",
          Numbers.percent(flow.errorEstimate())
              + (flow.converged() ? "" : " NOT CONVERGED")
              + " (tolerance "
              + Numbers.percent(outcome.options().tolerance())
              + ", last change "
              + Numbers.percent(flow.changeAtStop())
              + ", flux balanced to "
              + Numbers.percent(flow.fluxImbalance())
              + ")");
    }
  }

  /** The other two entries of the column of the permeability tensor. */
  private static String across(Outcome outcome) {
    List<String> entries = new ArrayList<>();
    for (Axis each : Axis.values()) {
      if (each != outcome.options().axis()) {
        double entry = outcome.figures().entry(each).getAsDouble();
        entries.add(
            "along " + Choices.word(each) + " " + Numbers.significant(entry, DIGITS) + " voxel2");
      }
    }
    return String.join(", ", entries);
  }

  private static void flow(Table table, Outcome outcome) {
    FlowOptions options = outcome.options();
    int layers = outcome.flow().chosen().inletLayers();
    String chosen = options.inletLayers().isPresent() ? " (given)" : " (chosen)";
    table.line(
        "boundaries",
        "sides "
            + Choices.word(options.sides())
            + ", inlet and outlet "
            + Choices.word(options.inlet())
            + (layers > 0 ? " of " + layers + " layers" + chosen : ""));
    if (outcome.superficialVelocity().isEmpty()) {
      return;
    }
    table
        .line(
            "velocity",
            Numbers.significant(outcome.superficialVelocity().getAsDouble(), FEW)
                + " m/s superficial, "
                + Numbers.significant(outcome.poreVelocity().getAsDouble(), FEW)
                + " m/s in the pores, at "
                + Numbers.significant(outcome.fluid().pressureGradient(), DIGITS)
                + " Pa/m")
        .line(
            "Reynolds number",
            Numbers.significant(outcome.reynolds().getAsDouble(), FEW)
                + " (nu "
                + Numbers.significant(outcome.fluid().viscosity(), FEW)
                + " m2/s, rho "
                + Numbers.significant(outcome.fluid().density(), FEW)
                + " kg/m3)");
  }

  private static void computation(Table table, Outcome outcome) {
    SteadyFlow flow = outcome.flow();
    table.line("method", outcome.method() == Method.LBM ? lattice(outcome) : particles(outcome));
    if (!outcome.percolates()) {
      return;
    }
    if (flow.particles().isPresent()) {
      timeStep(table, flow.particles().get(), flow.mach());
    } else {
      table.line(
          "tau",
          Numbers.significant(flow.chosen().relaxationTime(), DIGITS)
              + (outcome.options().relaxationTime().isPresent() ? " (given)" : " (chosen)")
              + ", highest Mach number "
              + Numbers.significant(flow.mach(), FEW));
    }
    table.line(
        "steps",
        String.format(
            Locale.ROOT,
            "%d in %.2f s, %.1f %s, %d fluid %s",
            flow.work().steps(),
            flow.work().secondsStepping(),
            flow.work().mflups(),
            outcome.method() == Method.LBM ? "MFLUPS" : "MPUPS (fluid)",
            flow.work().fluidNodes(),
            outcome.method() == Method.LBM ? "nodes" : "particles"));
    flow.corrections().ifPresent(corrections -> table.line("pressure", text(corrections)));
  }

  private static String lattice(Outcome outcome) {
    FlowOptions options = outcome.options();
    return "lattice Boltzmann, "
        + options.velocitySet()
        + (options.storage() == Storage.SINGLE ? ", single precision, " : ", ")
        + options.collision()
        + ", linear equilibrium, walls "
        + Choices.word(outcome.walls());
  }

  private static String particles(Outcome outcome) {
    return "smoothed particle hydrodynamics, quintic spline"
        + outcome
            .flow()
            .particles()
            .map(figures -> ", h " + figures.smoothingLength() + " voxel, " + figures.count())
            .map(text -> text + " particles, walls included")
            .orElse("");
  }

  private static void timeStep(Table table, SteadyFlow.ParticleFigures particles, double mach) {
    table.line(
        "time step",
        Numbers.significant(particles.timeStep(), FEW)
            + " voxel2/nu, limited by "
            + particles.limit()
            + ", highest Mach number "
            + Numbers.significant(mach, FEW)
            + String.format(
                Locale.ROOT,
                ", density %.4f to %.4f of that at rest",
                particles.leastCompression(),
                particles.mostCompression()));
  }

  private static String text(SteadyFlow.Corrections corrections) {
    return String.format(
        Locale.ROOT,
        "start and %d corrections in %.2f s%s",
        corrections.count(),
        corrections.seconds(),
        corrections.helpful() ? "" : ", given up as they did not help");
  }

  private static void collector(Table table, Outcome outcome) {
    table.line("threads", outcome.threads() + ", Java " + Version.ofJava());
    outcome.collectorReport().putInto(table);
  }
}
