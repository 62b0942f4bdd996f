package org.hdispatch.sph;

import java.util.List;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.Ends;

/** Refuses numbers that cannot give the flow wanted, whatever the particles do. */
final class SetupCheck {
  private static final double LEAST_SUPPORT = 1.98; // spacings, and what n0 is not 1/dx^D by
  private static final double VISCOSITY = 0.1; // share by which it may be wrong on a lattice
  private static final double MACH = 0.1;
  private static final double ROUND_OFF = 1 + 1e-9;

  private final ParticleBox box;
  private final SmoothingKernel kernel;
  private final List<Phase> phases;

  SetupCheck(ParticleBox box, SmoothingKernel kernel, List<Phase> phases) {
    this.box = box;
    this.kernel = kernel;
    this.phases = phases;
  }

  static void bodyForce(double x, double y, double z) {
    Checks.finite("body force", "gx", x);
    Checks.finite("body force", "gy", y);
    Checks.finite("body force", "gz", z);
  }

  /**
   * Neighbours enough to sum over. Cubic spline and Wendland's kernel bear 1 spacing, with a
   * viscosity wrong by 1 to 6 % on a lattice; the quintic spline bears 0.72.
   */
  void spacing() {
    for (Phase phase : phases) {
      double spacing = phase.spacing(box.dimensions());
      boolean wide = kernel.supportRadius() >= LEAST_SUPPORT * spacing;
      double factor = wide ? LatticeSum.of(kernel, spacing).laplacianFactor() : 0;
      if (!(Math.abs(factor - 1) <= VISCOSITY)) {
        throw new IllegalArgumentException(
            "smoothing length must be long enough for the kernel to find viscosities to 10 %: h="
                + kernel.smoothingLength()
                + ", dx="
                + spacing
                + " (m/rho0 of "
                + phase.name()
                + "), "
                + kernel);
      }
    }
  }

  /** Numbers of quads fit into the lists of neighbours. */
  void cells(ParticleGrid grid, double spacing) {
    CellGrid cells = grid.cells();
    double within =
        along(box.x(), cells.nx())
            * along(box.y(), cells.ny())
            * (box.dimensions() == 2 ? 1 : along(box.z(), cells.nz()));
    double volume = box.volume() / ((double) cells.nx() * cells.ny() * cells.nz());
    double particles = Math.floor(within * volume / Math.pow(spacing, box.dimensions()));
    if (particles > Neighbourhood.MOST) {
      throw new IllegalArgumentException(
          "cell and those around it must hold at most "
              + Neighbourhood.MOST
              + " particles: edge="
              + grid.leastEdge()
              + ", particles="
              + (long) particles);
    }
  }

  /** Cells seen along an axis, images included. */
  private static int along(Ends ends, int cells) {
    return ends == Ends.PERIODIC ? 3 : Math.min(3, cells);
  }

  /** No particle sees the same image of another twice. */
  void box(double reach) {
    box("lx", box.x(), box.lx(), reach);
    box("ly", box.y(), box.ly(), reach);
    if (box.dimensions() == 3) {
      box("lz", box.z(), box.lz(), reach);
    }
  }

  private static void box(String name, Ends ends, double length, double reach) {
    if (ends == Ends.PERIODIC && length * ROUND_OFF < reach) {
      throw new IllegalArgumentException(
          "periodic box must be at least as long as the support radius and the skin: "
              + name
              + "="
              + length
              + ", reach="
              + reach);
    }
  }

  /** The step's limits that hold without pairwise forces. */
  void timeStep(double timeStep, double force, double courantNumber) {
    TimeStep limits = TimeStep.of(kernel, phases, force, courantNumber);
    if (timeStep > limits.allowed() * ROUND_OFF) {
      throw new IllegalArgumentException(
          "time step must be within its limits (Morris et al. 1997): dt="
              + timeStep
              + ", allowed="
              + limits.allowed()
              + " by "
              + limits.rules());
    }
  }

  /**
   * Flow slower than sound by far: its mean velocity in a tube as wide as the widest place, F
   * d^2/(8 nu), d being the greatest distance from a wall, which hardly any pore exceeds. Along an
   * axis that ends somewhere pressure holds the fluid, and the force drives no such flow.
   */
  void machNumber(double gx, double gy, double gz, double widest) {
    double x = box.x() == Ends.PERIODIC ? gx : 0;
    double y = box.y() == Ends.PERIODIC ? gy : 0;
    double z = box.z() == Ends.PERIODIC ? gz : 0;
    double force = Math.sqrt(x * x + y * y + z * z);
    for (Phase phase : phases) {
      double c = phase.state().soundSpeed();
      double velocity = force * widest * widest / (8 * phase.kinematicViscosity());
      if (!phase.solid() && velocity > MACH * c) {
        throw new IllegalArgumentException(
            "body force must not drive the flow faster than 0.1 c: velocity="
                + velocity
                + ", c="
                + c
                + ", distance from walls="
                + widest
                + ", phase="
                + phase.name());
      }
    }
  }
}
