package org.hdispatch.sph;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/** Settings of a scheme; each has a default but the phases and the time step. */
public final class SphSchemeBuilder {
  private static final double WALL_FACTOR = 4;
  private static final double SKIN = 0.1; // of the support radius
  private static final double MOST_COURANT = 2;

  final ParticleBox box;
  final SmoothingKernel kernel;
  final List<Phase> phases = new ArrayList<>();
  SearchMode mode = SearchMode.VERLET;
  WallDistance walls;
  AccelerationField field;
  PairForces pairs;
  double timeStep = Double.NaN;
  double gx;
  double gy;
  double gz;
  private double skin = Double.NaN;
  private double edge;
  private ViscosityMean mean = ViscosityMean.ARITHMETIC;
  private double wallFactor = WALL_FACTOR;
  private double courantNumber = TimeStep.COURANT;
  private SumForm form;

  SphSchemeBuilder(ParticleBox box, SmoothingKernel kernel) {
    this.box = Objects.requireNonNull(box, "box");
    this.kernel = Objects.requireNonNull(kernel, "kernel");
    if (box.dimensions() != kernel.dimensions()) {
      throw new IllegalArgumentException(
          "kernel must have the dimensions of the box: kernel="
              + kernel.dimensions()
              + ", box="
              + box.dimensions());
    }
  }

  /** The smoothing kernel. */
  public SmoothingKernel kernel() {
    return kernel;
  }

  /** Adds a phase; phases are numbered from 0 in this order. */
  public SphSchemeBuilder phase(Phase phase) {
    phases.add(Objects.requireNonNull(phase, "phase"));
    return this;
  }

  /** Sets when neighbours are searched for. Default: {@link SearchMode#VERLET}. */
  public SphSchemeBuilder search(SearchMode search) {
    mode = Objects.requireNonNull(search, "search");
    return this;
  }

  /**
   * Sets how far beyond the support {@link SearchMode#VERLET} lists neighbours. Default: a tenth of
   * the support radius.
   *
   * @throws IllegalArgumentException if it is not positive
   */
  public SphSchemeBuilder skin(double length) {
    Checks.positive("skin", "skin", length);
    skin = length;
    return this;
  }

  /**
   * Sets the edge of a cell, which is made to fit the box: what a worker takes at a time, and so
   * how much of its cache it needs. Default: as short as may be.
   *
   * @param length at least the support radius, and the skin where there is one; so short that a
   *     cell and those around it hold 262144 particles at most
   * @throws IllegalArgumentException if it is not positive
   */
  public SphSchemeBuilder cellEdge(double length) {
    Checks.positive("cell edge", "edge", length);
    edge = length;
    return this;
  }

  /** Sets the viscosity of unlike pairs. Default: {@link ViscosityMean#ARITHMETIC}. */
  public SphSchemeBuilder viscosityMean(ViscosityMean of) {
    mean = Objects.requireNonNull(of, "mean");
    return this;
  }

  /**
   * Sets where the walls are. Needed where there are solid particles.
   *
   * @param distance of a place from the nearest wall
   */
  public SphSchemeBuilder walls(WallDistance distance) {
    walls = Objects.requireNonNull(distance, "distance");
    return this;
  }

  /**
   * Sets beta_max, how many times its own velocity a fluid particle may differ from the wall's in
   * the viscous force (Morris et al. 1997: 1.5). Default: 4, which errs least: no pair of a lattice
   * h apart asks for more.
   */
  public SphSchemeBuilder wallFactor(double most) {
    wallFactor = most;
    return this;
  }

  /**
   * Sets the body force, an acceleration of all fluid. Default: none.
   *
   * @throws IllegalArgumentException if it is not finite
   */
  public SphSchemeBuilder bodyForce(double x, double y, double z) {
    SetupCheck.bodyForce(x, y, z);
    gx = x;
    gy = y;
    gz = z;
    return this;
  }

  /** Sets an acceleration beside the body force. Default: none. */
  public SphSchemeBuilder accelerationField(AccelerationField accelerations) {
    field = Objects.requireNonNull(accelerations, "accelerations");
    return this;
  }

  /**
   * Sets forces between pairs of particles: surface tension and wetting. Default: none.
   *
   * @param forces strengths by phase, in the order of the scheme's phases
   */
  public SphSchemeBuilder pairForces(PairForces forces) {
    pairs = Objects.requireNonNull(forces, "forces");
    return this;
  }

  /**
   * Sets the time step; {@link TimeStep} tells what is allowed.
   *
   * @throws IllegalArgumentException if it is not positive
   */
  public SphSchemeBuilder timeStep(double dt) {
    Checks.positive("time step", "dt", dt);
    timeStep = dt;
    return this;
  }

  /**
   * Sets how many smoothing lengths sound may cross in a time step. Default: 0.25 (Morris, Fox, Zhu
   * 1997). Particles that hardly leave a cubic lattice bear more: the quintic spline's sums know no
   * sound there of an angular frequency above 0.88 c/h, and the leapfrog bears 2/dt, or 1.8/dt
   * where viscosity limits the step too.
   *
   * @throws IllegalArgumentException if it is not positive, or above 2
   */
  public SphSchemeBuilder courantNumber(double most) {
    if (!(most > 0 && most <= MOST_COURANT)) {
      throw new IllegalArgumentException(
          "Courant number must be positive and at most 2, where waves on a lattice grow: C="
              + most);
    }
    courantNumber = most;
    return this;
  }

  /** Sets the form of the sums. Default: the fastest that this JVM has. */
  public SphSchemeBuilder form(SumForm sums) {
    form = Objects.requireNonNull(sums, "sums");
    return this;
  }

  SumForm form() {
    return form == null ? SumForm.fastest(kernel) : form;
  }

  PairModel model() {
    double viscosity = phases.get(0).viscosity();
    boolean alike = phases.stream().allMatch(phase -> phase.viscosity() == viscosity);
    return new PairModel(kernel, mean, alike ? viscosity : Double.NaN, walls != null, wallFactor);
  }

  /** Least distance of particles at rest. */
  double spacing() {
    double least = Double.POSITIVE_INFINITY;
    for (Phase phase : phases) {
      least = Math.min(least, phase.spacing(box.dimensions()));
    }
    return least;
  }

  /** How many particles at rest fill the box: there are hardly ever more. */
  public double sites() {
    return box.volume() / Math.pow(spacing(), box.dimensions());
  }

  /** How far particles are looked for. */
  double reach() {
    return kernel.supportRadius() + usedSkin();
  }

  private double usedSkin() {
    if (mode != SearchMode.VERLET) {
      return 0;
    }
    return Double.isNaN(skin) ? SKIN * kernel.supportRadius() : skin;
  }

  ParticleGrid grid() {
    double reach = reach();
    if (edge != 0 && edge < reach) {
      throw new IllegalArgumentException(
          "cell edge must be at least the support radius and the skin: edge="
              + edge
              + ", support="
              + kernel.supportRadius()
              + ", skin="
              + usedSkin());
    }
    return new ParticleGrid(box, edge == 0 ? reach : edge);
  }

  /**
   * The scheme.
   *
   * @throws IllegalArgumentException if the smoothing length is too small for the particles, the
   *     support too large for the box, cells are shorter than the support or hold too many
   *     particles, the time step is above its limits, the body force drives the flow faster than a
   *     tenth of the speed of sound, there is no phase, a phase has no particles, a particle is of
   *     no phase, lies outside the box or in a wall or has no finite velocity, solids have no
   *     walls, or pairwise forces are not those of the phases or too strong for the time step
   * @throws IllegalStateException if the time step is not set, or this JVM lacks the form of sums
   */
  public SphScheme build(Particles particles) {
    if (Double.isNaN(timeStep)) {
      throw new IllegalStateException("time step must be set");
    }
    check(particles);
    return new SphScheme(this, particles);
  }

  private void check(Particles particles) {
    if (phases.isEmpty()) {
      throw new IllegalArgumentException("there must be a phase: phases=0");
    }
    double force = Math.sqrt(gx * gx + gy * gy + gz * gz);
    SetupCheck set = new SetupCheck(box, kernel, phases);
    set.spacing();
    set.box(reach());
    set.cells(grid(), spacing());
    set.timeStep(timeStep, force, courantNumber);
    double widest = 0; // distance from a wall
    int[] ofPhase = new int[phases.size()];
    for (int n = 0; n < particles.count(); n++) {
      int phase = particles.phase(n);
      if (phase < 0 || phase >= phases.size()) {
        throw new IllegalArgumentException(
            "phase of a particle must be one of the scheme's: particle=" + n + ", phase=" + phase);
      }
      ofPhase[phase]++;
      widest = Math.max(widest, checkPlace(particles, n, phases.get(phase)));
    }
    for (int phase = 0; phase < ofPhase.length; phase++) {
      if (ofPhase[phase] == 0) {
        throw new IllegalArgumentException(
            "phase must have particles: phase=" + phases.get(phase).name());
      }
      if (phases.get(phase).solid() && walls == null) {
        throw new IllegalArgumentException(
            "walls must be set where there is a solid: phase=" + phases.get(phase).name());
      }
    }
    set.machNumber(gx, gy, gz, widest);
    if (pairs != null) {
      checkPairs();
    }
  }

  private void checkPairs() {
    if (pairs.phases() != phases.size()) {
      throw new IllegalArgumentException(
          "pair strengths must be given for the scheme's phases: strengths="
              + pairs.phases()
              + ", phases="
              + phases.size());
    }
    TimeStep limits = TimeStep.of(kernel, phases, 0, pairs);
    double most = Math.min(limits.pair(), limits.capillary());
    if (timeStep > most) {
      throw new IllegalArgumentException(
          "time step must resolve pairwise forces and capillary waves: dt="
              + timeStep
              + ", allowed="
              + most
              + ", sigma="
              + MeanField.greatestTension(kernel, phases, pairs));
    }
  }

  /** Distance of a fluid particle from the walls, 0 if there are none. */
  private double checkPlace(Particles particles, int n, Phase phase) {
    double x = particles.x(n);
    double y = particles.y(n);
    double z = particles.z(n);
    boolean inside =
        x >= 0
            && x < box.lx()
            && y >= 0
            && y < box.ly()
            && (box.dimensions() == 2 ? z == 0 : z >= 0 && z < box.lz());
    if (!inside) {
      throw new IllegalArgumentException(
          "particle must lie in the box: particle=" + n + ", x=" + x + ", y=" + y + ", z=" + z);
    }
    double u = particles.u(n);
    double v = particles.v(n);
    double w = particles.w(n);
    if (!Double.isFinite(u + v + w)) {
      throw new IllegalArgumentException(
          "velocity of a particle must be finite: particle="
              + n
              + ", u="
              + u
              + ", v="
              + v
              + ", w="
              + w);
    }
    if (phase.solid() || walls == null) {
      return 0;
    }
    double distance = walls.at(x, y, z);
    if (!(distance > 0)) {
      throw new IllegalArgumentException(
          "fluid particle must not lie in a wall: particle=" + n + ", distance=" + distance);
    }
    return distance;
  }
}
