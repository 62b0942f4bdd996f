package org.hdispatch.sph;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import org.hdispatch.cell.CellMap;
import org.hdispatch.dispatch.Pass;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.Tick;

/**
 * Smoothed particle hydrodynamics in the form of number densities (Tartakovsky, Meakin 2005; Hu,
 * Adams 2006) as a scheme of three passes:
 *
 * <ol>
 *   <li>"rehash": particles go to the cells that they are in; only where neighbours are searched
 *       for;
 *   <li>"density": n, from it the pressure;
 *   <li>"force": forces, and the leapfrog.
 * </ol>
 *
 * <p>Cells of the box without particles do not exist. Every bit is the same for any number of
 * workers and any form of the sums; search modes and edges of cells change the order in which
 * neighbours are added.
 *
 * <p>One loop may step it. A step that fails cannot be repeated.
 */
public final class SphScheme implements Scheme<ParticleCell, SphScratch> {
  private final SmoothingKernel kernel;
  private final Phase[] phases;
  private final SearchMode mode;
  private final double skin;
  private final ParticleGrid grid;
  private final CellMap<ParticleCell> cells;
  private final Supplier<PairSums> sums;
  private final PairForces pairs; // null: none
  private final Surroundings surroundings;
  private final Rehash rehash;
  private final List<Pass<ParticleCell, SphScratch>> passes;
  private final StepPlan plan = new StepPlan();
  private final SavedState savedState;
  private int written; // buffer that holds the state
  private boolean listed; // whether lists are good for the next step
  private boolean fresh = true; // no step has been made
  private boolean linked; // whether cells know those around them as they were in the last step
  private double travelled; // at most, by a particle since lists were made
  private double fastest;
  private long rebuilds;
  private long searchNanos;
  private long densityNanos;
  private long forceNanos;

  SphScheme(SphSchemeBuilder settings, Particles particles) {
    kernel = settings.kernel;
    phases = settings.phases.toArray(Phase[]::new);
    mode = settings.mode;
    double reach = settings.reach();
    skin = reach - kernel.supportRadius();
    grid = settings.grid();
    sums = settings.form().of(settings.model());
    pairs = settings.pairs;
    plan.timeStep = settings.timeStep;
    drive(settings.gx, settings.gy, settings.gz);
    cells = Filling.of(grid, particles);
    savedState = new SavedState(grid, settings, particles.count(), cells);
    boolean[] solid = new boolean[phases.length];
    double[] viscosities = new double[phases.length];
    for (int phase = 0; phase < solid.length; phase++) {
      solid[phase] = phases[phase].solid();
      viscosities[phase] = settings.model().plane(phases[phase].viscosity());
    }
    double spacing = settings.spacing();
    rehash = new Rehash(cells, grid, plan, solid, settings.walls, spacing);
    surroundings = new Surroundings(grid, settings.model(), viscosities, pairs != null);
    passes =
        List.of(
            new Pass<>("rehash", rehash),
            new Pass<>("density", new DensityPass(surroundings, plan, mode, reach, phases)),
            new Pass<>(
                "force",
                new ForcePass(
                    surroundings,
                    grid,
                    plan,
                    mode,
                    reach,
                    phases,
                    settings.walls,
                    spacing / 4,
                    settings.field)));
  }

  /**
   * Writes the state, from which {@link #restore} goes on with the same bits: a number that tells
   * what it is the state of, then all particles, as big-endian numbers in an order that belongs to
   * the scheme. Between steps. The next step searches for neighbours anew, in {@link
   * SearchMode#VERLET} too: so it will after the state is restored.
   *
   * @throws IOException if the stream does
   */
  public void save(DataOutput out) throws IOException {
    savedState.write(written, fresh, fastest, out);
    listed = false;
  }

  /**
   * Reads a state that a scheme has saved of the same box, cells, kernel and time step, with as
   * many phases and particles. What phases, body force and pairwise forces are is not part of it.
   * If it fails after the first number the state is undefined.
   *
   * @throws IOException if the stream does, or if it ends too early
   * @throws IllegalArgumentException if the state is of another scheme
   */
  public void restore(DataInput in) throws IOException {
    savedState.check(in);
    fresh = in.readBoolean();
    fastest = in.readDouble();
    written = 0;
    savedState.read(written, in);
    listed = false;
    linked = false;
  }

  /** A builder with defaults for a box and a kernel. */
  public static SphSchemeBuilder builder(ParticleBox box, SmoothingKernel kernel) {
    return new SphSchemeBuilder(box, kernel);
  }

  @Override
  public CellMap<ParticleCell> cells() {
    return cells;
  }

  @Override
  public SphScratch newScratch() {
    return new SphScratch(
        sums.get(),
        pairs == null ? null : new PairForceSums(pairs, kernel.supportRadius()),
        rehash.bins());
  }

  @Override
  public List<Pass<ParticleCell, SphScratch>> passes() {
    return passes;
  }

  /**
   * Sets the body force from the next step on.
   *
   * @param gx acceleration of all fluid along x
   * @param gy along y
   * @param gz along z
   * @throws IllegalArgumentException if it is not finite
   */
  public void drive(double gx, double gy, double gz) {
    SetupCheck.bodyForce(gx, gy, gz);
    plan.gx = gx;
    plan.gy = gy;
    plan.gz = gz;
  }

  @Override
  public void beforeStep(Tick tick) {
    boolean anew = mode != SearchMode.VERLET || !listed || 2 * travelled > skin;
    plan.begin(written, anew);
    plan.kick = fresh ? plan.timeStep / 2 : plan.timeStep;
    if (anew) {
      travelled = 0;
      rebuilds++;
    }
  }

  @Override
  public void afterStep(Tick tick) {
    double square = 0;
    for (int n = 0; n < cells.size(); n++) {
      ParticleCell cell = cells.cellAt(n);
      square = Math.max(square, cell.fastestSquare);
      searchNanos += cell.searchNanos;
      densityNanos += cell.densityNanos;
      forceNanos += cell.forceNanos;
      cell.searchNanos = 0;
      cell.densityNanos = 0;
      cell.forceNanos = 0;
    }
    fastest = Math.sqrt(square);
    travelled += fastest * plan.timeStep;
    written = plan.to;
    listed = true;
    linked = true;
    fresh = false;
  }

  /** Speed of the fastest particle in the last step. */
  public double fastest() {
    return fastest;
  }

  /** How often neighbours were searched for in all cells. */
  public long rebuilds() {
    return rebuilds;
  }

  /** Time step. */
  public double timeStep() {
    return plan.timeStep;
  }

  /** The smoothing kernel. */
  public SmoothingKernel kernel() {
    return kernel;
  }

  /** Shortest edge of a cell, in the unit of length. */
  public double cellEdge() {
    return grid.leastEdge();
  }

  /** What the particles are made of, by number of the phase. */
  public List<Phase> phases() {
    return List.of(phases);
  }

  /** Number of particles, those of solids included. */
  public int particles() {
    int sum = 0;
    for (int n = 0; n < cells.size(); n++) {
      sum += cells.cellAt(n).count;
    }
    return sum;
  }

  /** Number of particles that move. */
  public int fluidParticles() {
    int sum = 0;
    for (int n = 0; n < cells.size(); n++) {
      ParticleCell cell = cells.cellAt(n);
      byte[] phase = cell.buffers[written].phase;
      for (int particle = 0; particle < cell.count; particle++) {
        sum += phases[phase[particle]].solid() ? 0 : 1;
      }
    }
    return sum;
  }

  /**
   * Mean number of neighbours that a fluid particle had in the last step: particles closer than the
   * support radius, but for itself. NaN before the first step, and before the first that follows
   * {@link #restore}. Counted anew, on the caller's thread.
   */
  public double neighboursMean() {
    if (!linked) {
      return Double.NaN;
    }
    return new NeighbourCount(surroundings, kernel.supportRadius()).mean(cells, plan.at);
  }

  /**
   * Bytes held for the particles: what all cells hold, with the room that their arrays have to grow
   * and 16 bytes a header. The scratch of the workers comes on top.
   */
  public long bytes() {
    long sum = 0;
    for (int n = 0; n < cells.size(); n++) {
      sum += cells.cellAt(n).bytes();
    }
    return sum;
  }

  /** Shows all particles, cell by cell, in an order that does not depend on workers. */
  public void forEachParticle(ParticleVisitor visitor) {
    for (int index = 0; index < cells.size(); index++) {
      ParticleCell cell = cells.cellAt(index);
      ParticleArrays from = cell.buffers[written];
      for (int n = 0; n < cell.count; n++) {
        double volume = fresh ? Double.NaN : cell.volume[n];
        visitor.visit(
            from.id[n],
            from.phase[n],
            from.x[n],
            from.y[n],
            from.z[n],
            from.ux[n],
            from.uy[n],
            from.uz[n],
            1 / volume,
            fresh ? Double.NaN : pressure(cell, n));
      }
    }
  }

  /** Of the density, and of pairwise forces: (1/2 d) n_i sum_j F_i&lt;-j . (r_i - r_j). */
  private double pressure(ParticleCell cell, int n) {
    double volume = cell.volume[n];
    double ofDensity = cell.pressure[n] / (volume * volume);
    return pairs == null || n >= cell.fluids
        ? ofDensity
        : ofDensity + cell.virial[n] / (2 * kernel.dimensions() * volume);
  }

  /** Least and greatest density over rest density in a fluid, in the last step. */
  public double[] compression() {
    double least = Double.POSITIVE_INFINITY;
    double most = 0;
    for (int n = 0; n < cells.size(); n++) {
      ParticleCell cell = cells.cellAt(n);
      if (cell.fluids > 0) {
        least = Math.min(least, cell.leastCompression);
        most = Math.max(most, cell.mostCompression);
      }
    }
    return new double[] {least, most};
  }

  /** Wall time that all workers together have spent, by kind of work, since this was made. */
  public SphTimes times() {
    return new SphTimes(1e-9 * searchNanos, 1e-9 * densityNanos, 1e-9 * forceNanos);
  }

  @Override
  public String toString() {
    return "SPH, "
        + kernel
        + ", "
        + Arrays.toString(phases)
        + ", "
        + mode
        + ", cells "
        + grid.cells().nx()
        + " x "
        + grid.cells().ny()
        + " x "
        + grid.cells().nz();
  }
}
