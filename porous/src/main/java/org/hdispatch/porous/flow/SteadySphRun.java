package org.hdispatch.porous.flow;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.porous.darcy.Darcy;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.Percolation;
import org.hdispatch.sph.EquationOfState;
import org.hdispatch.sph.LatticeSum;
import org.hdispatch.sph.Phase;
import org.hdispatch.sph.QuinticSpline;
import org.hdispatch.sph.SearchMode;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.TimeStep;

/**
 * One computation of a steady flow by particles. Lengths are in voxels, densities in that of the
 * fluid; the unit of time is such that the kinematic viscosity is 1.
 */
final class SteadySphRun implements Stepping.Flow {
  private static final double VISCOSITY = 1;

  /**
   * Smoothing lengths that sound crosses in a step. Pressures that alternate from one particle to
   * the next, and those of the walls, drive hardly any flow: they are found by diffusion, as fast
   * as the square of the speed of sound. Particles that stay on a lattice bear 2; the usual 0.25 is
   * for those that do not.
   */
  private static final double COURANT = 1.5;

  /**
   * Mean pore velocity aimed at, voxels per step. After a thousand steps of 1e-7 the strain changes
   * densities, by its square, as much as the pressure does.
   */
  private static final double PORE_VELOCITY = 1e-9;

  private static final double SKIN = 0.1;

  /** Steps over which the gain of density is measured. */
  private static final int GAIN_STEPS = 4;

  private static final int LEAST_INTERVAL = 20;
  private static final int WARM_UP_STEPS = 40;

  private final double porosity;
  private final FlowOptions options;
  private final Percolation percolation;
  private final FlowDomain domain;
  private final FlowListener listener;
  private final ParticleLayout layout;
  private final QuinticSpline kernel;
  private final TimeStep limits;
  private final double soundSpeed;
  private final double force;
  private final DarcyFlow darcy;
  private final double[] pressure; // by node: given so far, over density, beside the force's
  private final double[][] acceleration = new double[3][]; // by node: of force and pressure given
  private final double[] densities; // by fluid particle: noted last
  private final SphScheme scheme;
  private final TimeLoop loop;
  private final Stepping stepping;
  private final CorrectionShare correction = new CorrectionShare();
  private final ErrorOfSteadyState error;
  private final double[] sections; // flux through each layer of nodes
  private final double[] total = new double[3]; // velocities of the rock summed up, by axis
  private final double[] gains; // of volume in each layer, in a unit of time
  private long pressureNanos;
  private int corrections;
  private double permeability;
  private double imbalance = Double.POSITIVE_INFINITY;
  private double fastest;
  private final int count;

  SteadySphRun(
      Dispatcher dispatcher,
      double porosity,
      FlowOptions options,
      SphOptions settings,
      Percolation percolation,
      FlowDomain domain,
      FlowListener listener) {
    this.porosity = porosity;
    this.options = options;
    error = ErrorOfSteadyState.whereCreeping(options.tolerance());
    this.percolation = percolation;
    this.domain = domain;
    this.listener = listener;
    kernel = kernel(settings);
    double h = settings.smoothingLength();
    double viscousStep = TimeStep.VISCOUS * h * h / VISCOSITY;
    soundSpeed = COURANT * h / viscousStep;
    Phase fluid =
        Phase.fluid(
            "fluid",
            1 / LatticeSum.of(kernel, 1).numberDensity(),
            VISCOSITY,
            EquationOfState.linear(1, soundSpeed, 0));
    force =
        PORE_VELOCITY
            / viscousStep
            * domain.rock().porosity()
            * VISCOSITY
            / domain.guessedPermeability();
    limits = TimeStep.of(kernel, List.of(fluid), force, COURANT);
    layout = new ParticleLayout(domain, reach(settings));
    long begin = System.nanoTime();
    darcy = new DarcyFlow(dispatcher, domain, VISCOSITY);
    darcy.start(force);
    pressure = new double[darcy.field().length];
    for (Axis axis : Axis.values()) {
      acceleration[axis.ordinal()] = new double[pressure.length];
    }
    give(1);
    pressureNanos = System.nanoTime() - begin;
    var particles = layout.particles((x, y, z, axis) -> darcy.velocity(x, y, z, axis));
    count = particles.count();
    scheme =
        SphScheme.builder(layout.box(), kernel)
            .phase(fluid)
            .phase(Phase.wallOf(fluid))
            .search(SearchMode.VERLET)
            .skin(SKIN)
            .walls(layout.distance())
            .wallFactor(settings.wallFactor())
            .accelerationField(this::accelerate)
            .courantNumber(COURANT)
            .timeStep(limits.allowed())
            .build(particles);
    loop = dispatcher.loop(scheme);
    stepping = new Stepping(loop, options, listener, WARM_UP_STEPS);
    densities = new double[layout.nodes().length];
    gains = new double[sizeAlong()];
    sections = new double[sizeAlong()];
  }

  private static QuinticSpline kernel(SphOptions settings) {
    return new QuinticSpline(settings.smoothingLength(), 3);
  }

  /** How far a particle looks for others, voxels. */
  static double reach(SphOptions settings) {
    return kernel(settings).supportRadius() + SKIN;
  }

  private int sizeAlong() {
    return options
        .axis()
        .length(domain.lattice().nx(), domain.lattice().ny(), domain.lattice().nz());
  }

  private void accelerate(double x, double y, double z, double[] to) {
    int node = layout.nodeAt(x, y, z);
    to[0] = acceleration[0][node];
    to[1] = acceleration[1][node];
    to[2] = acceleration[2][node];
  }

  /** Adds a share of the pressure found last, and takes its gradient for an acceleration. */
  private void give(double share) {
    double[] field = darcy.field();
    for (int node : layout.nodes()) {
      pressure[node] += share * field[node];
    }
    for (Axis axis : Axis.values()) {
      double[] along = acceleration[axis.ordinal()];
      double body = axis == options.axis() ? force : 0;
      for (int node : layout.nodes()) {
        along[node] = body - slope(node, axis);
      }
    }
  }

  /** Slope of the pressure given: over the neighbours that are no wall. */
  private double slope(int node, Axis axis) {
    double sum = 0;
    int sides = 0;
    for (int step = -1; step <= 1; step += 2) {
      int beside = domain.neighbour(node, axis, step);
      if (beside >= 0) {
        sum += step * (pressure[beside] - pressure[node]);
        sides++;
      }
    }
    return sides == 0 ? 0 : sum / sides;
  }

  SteadyFlow toSteadyState() {
    listener.started(new FlowListener.Start(layout.nodes().length, Double.NaN));
    boolean converged = stepping.toSteadyState(this, interval());
    double[] compression = scheme.compression();
    return new SteadyFlow(
        options,
        porosity,
        domain.connectedPorosity(),
        percolation,
        permeability,
        domain.column(permeability, total),
        error.estimate(),
        error.lastChange(),
        imbalance,
        converged,
        fastest / soundSpeed,
        new SteadyFlow.Chosen(domain.hydraulicDiameter(), Double.NaN, domain.layers()),
        stepping.work(layout.nodes().length),
        Optional.of(
            new SteadyFlow.Corrections(corrections, correction.helpful(), pressureNanos * 1e-9)),
        Optional.of(
            new SteadyFlow.ParticleFigures(
                count,
                kernel.smoothingLength(),
                VISCOSITY * limits.allowed(),
                limits.rules(),
                compression[0],
                compression[1],
                scheme.rebuilds())),
        Optional.of(field()));
  }

  /** Steps after which momentum has followed a correction. */
  private int interval() {
    double radius = domain.hydraulicDiameter() / 2;
    double momentum = RelaxationChoice.momentumTime(radius, VISCOSITY * limits.allowed());
    return (int) Math.max(LEAST_INTERVAL, Math.ceil(momentum));
  }

  @Override
  public void advance(long steps) {
    boolean correct = correction.helpful() && steps > GAIN_STEPS;
    loop.run(correct ? steps - GAIN_STEPS : steps);
    if (correct) {
      scheme.forEachParticle(
          (id, phase, x, y, z, u, v, w, n, p) -> {
            if (phase == ParticleLayout.FLUID) {
              densities[id] = n;
            }
          });
      loop.run(GAIN_STEPS);
      gather();
    }
    measure();
    if (correct && error.estimate() > options.tolerance()) {
      long begin = System.nanoTime();
      correct();
      pressureNanos += System.nanoTime() - begin;
    }
  }

  @Override
  public double errorEstimate() {
    return error.estimate();
  }

  @Override
  public int corrections() {
    return corrections;
  }

  /**
   * Finds the rate at which density grows at each node since it was noted, and in each section:
   * what it grows by more than in the mean. Sums of number densities are not conserved, and what
   * all particles gain alike neither drives a flow nor is driven away by one.
   */
  private void gather() {
    double[] gain = darcy.field();
    double time = GAIN_STEPS * limits.allowed();
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) -> {
          if (phase == ParticleLayout.FLUID) {
            gain[layout.nodes()[id]] = (n / densities[id] - 1) / time;
          }
        });
    double sum = 0;
    for (int node : layout.nodes()) {
      sum += gain[node];
    }
    double mean = sum / layout.nodes().length;
    Arrays.fill(gains, 0);
    for (int node : layout.nodes()) {
      gain[node] -= mean;
      gains[layout.coordinate(node, options.axis())] += gain[node];
    }
  }

  /** Gives the pressure that drives away what gathers. */
  private void correct() {
    correction.judge(darcy.gather(darcy::pressure, section()));
    if (correction.helpful()) {
      darcy.correct();
      give(correction.share());
      corrections++;
    }
  }

  /** Mean flux through a section of the rock. */
  private double section() {
    double sum = 0;
    for (int n = 0; n < domain.length(); n++) {
      sum += sections[domain.layers() + n];
    }
    return sum / domain.length();
  }

  private void measure() {
    Arrays.fill(sections, 0);
    Arrays.fill(total, 0);
    double[] fastestSquare = new double[1];
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) -> {
          if (phase == ParticleLayout.FLUID) {
            Axis axis = options.axis();
            double along = axis == Axis.X ? u : axis == Axis.Y ? v : w;
            int section = layout.coordinate(layout.nodes()[id], axis);
            sections[section] += along;
            if (section >= domain.layers() && section < domain.layers() + domain.length()) {
              total[0] += u;
              total[1] += v;
              total[2] += w;
            }
            fastestSquare[0] = Math.max(fastestSquare[0], u * u + v * v + w * w);
          }
        });
    fastest = Math.sqrt(fastestSquare[0]);
    double mean = section();
    imbalance = imbalance(mean);
    permeability =
        Darcy.permeability(
            VISCOSITY,
            mean / domain.crossSection(),
            force,
            domain.length(),
            domain.layers(),
            domain.slabPermeability());
    error.add(
        permeability,
        imbalance,
        RelaxationChoice.momentumLeft(
            domain.hydraulicDiameter(), VISCOSITY * limits.allowed(), stepping.steps()));
    stepping.tell(this, permeability, pressureNanos * 1e-9, layout.nodes().length);
  }

  /**
   * How far the flux through a section of the rock is at most from the mean by what gathers on the
   * way. (The sums of velocities over the particles of a section differ by more, as they are not
   * quite the flux.)
   */
  private double imbalance(double mean) {
    double least = 0;
    double most = 0;
    double sum = 0;
    for (int n = 0; n < domain.length(); n++) {
      sum += gains[domain.layers() + n];
      least = Math.min(least, sum);
      most = Math.max(most, sum);
    }
    return (most - least) / 2 / Math.abs(mean);
  }

  private FlowField field() {
    double drive = VISCOSITY * section() / domain.crossSection() / permeability;
    return FlowField.of(
        domain,
        VISCOSITY,
        force,
        drive,
        visitor ->
            scheme.forEachParticle(
                (id, phase, x, y, z, u, v, w, n, p) -> {
                  if (phase == ParticleLayout.FLUID) {
                    int node = layout.nodes()[id];
                    visitor.visit(
                        layout.coordinate(node, Axis.X),
                        layout.coordinate(node, Axis.Y),
                        layout.coordinate(node, Axis.Z),
                        pressure[node] + p,
                        u,
                        v,
                        w);
                  }
                }));
  }
}
