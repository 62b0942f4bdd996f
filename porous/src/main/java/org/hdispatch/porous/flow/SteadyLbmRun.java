package org.hdispatch.porous.flow;

import java.util.Optional;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.lbm.BodyForce;
import org.hdispatch.lbm.Equilibrium;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.LbmSchemeBuilder;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.porous.darcy.Darcy;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.Percolation;

/** One computation of a steady flow by the lattice Boltzmann method. */
final class SteadyLbmRun implements Stepping.Flow {
  /** Least number of steps before what is counted "per step" is counted. */
  private static final int WARM_UP_STEPS = 90;

  /** Mean pore velocity aimed at, voxels per step; k does not depend on it. */
  private static final double PORE_VELOCITY = 1e-3;

  /** Steps over which the gain of mass is measured: even, so that what alternates is gone. */
  private static final int GAIN_STEPS = 2;

  /**
   * Change of k still to come, relative to k, over the imbalance of the fluxes where stepping alone
   * spreads the pressure: up to 1.24 in 27 blocks of Berea sandstone of 128³ voxels.
   */
  private static final double CHANGE_PER_IMBALANCE = 1.5;

  /** Steps between measurements without corrections. */
  private static final int PLAIN_INTERVAL = 50;

  private final double porosity;
  private final FlowOptions options;
  private final Percolation percolation;
  private final FlowDomain domain;
  private final FlowListener listener;
  private final double relaxationTime;
  private final int interval;
  private final double force;
  private final LbmScheme scheme;
  private final TimeLoop loop;
  private final Stepping stepping;
  private final SectionFlux flux;
  private final Optional<PressureSolver> pressure;
  private final ErrorOfSteadyState error;
  private double permeability;
  private long pressureNanos;
  private int corrections;

  SteadyLbmRun(
      Dispatcher dispatcher,
      double porosity,
      FlowOptions options,
      Percolation percolation,
      FlowDomain domain,
      FlowListener listener) {
    this.porosity = porosity;
    this.options = options;
    this.percolation = percolation;
    this.domain = domain;
    this.listener = listener;
    boolean corrected = options.approach() == Approach.CORRECTED && !domain.immersed();
    relaxationTime = RelaxationChoice.choose(options, domain);
    var relaxation = options.collision().at(relaxationTime);
    interval =
        corrected ? RelaxationChoice.stepsBetweenCorrections(domain, relaxation) : PLAIN_INTERVAL;
    error =
        corrected
            ? ErrorOfSteadyState.whereCorrected(options.tolerance())
            : ErrorOfSteadyState.wherePlain(options.tolerance());
    force =
        PORE_VELOCITY
            * domain.rock().porosity()
            * relaxation.viscosity()
            / domain.guessedPermeability();
    LbmSchemeBuilder builder =
        LbmScheme.on(domain.lattice())
            .velocitySet(options.velocitySet())
            .storage(options.storage())
            .relaxation(relaxation)
            .equilibrium(Equilibrium.LINEAR)
            .force(along(options.axis(), force));
    domain.bound(builder);
    domain.bodies().ifPresent(builder::immersion);
    scheme = builder.build(dispatcher);
    loop = dispatcher.loop(scheme);
    stepping = new Stepping(loop, options, listener, WARM_UP_STEPS);
    long begin = System.nanoTime();
    pressure =
        corrected ? Optional.of(new PressureSolver(dispatcher, domain, scheme)) : Optional.empty();
    pressureNanos = corrected ? System.nanoTime() - begin : 0;
    flux = new SectionFlux(dispatcher, domain, scheme, densitySeen());
  }

  /** Gives the densities that are met when fluxes are measured to where the pressure comes from. */
  private LbmScheme.NodeVisitor densitySeen() {
    if (pressure.isEmpty()) {
      return (x, y, z, rho, ux, uy, uz) -> {};
    }
    PressureSolver solver = pressure.get();
    return (x, y, z, rho, ux, uy, uz) -> solver.seeDensity(x, y, z, rho);
  }

  private static BodyForce along(Axis axis, double force) {
    return new BodyForce(
        axis == Axis.X ? force : 0, axis == Axis.Y ? force : 0, axis == Axis.Z ? force : 0);
  }

  SteadyFlow toSteadyState() {
    listener.started(new FlowListener.Start(scheme.nodes(), relaxationTime));
    pressure.ifPresent(solver -> timed(() -> solver.start(force)));
    boolean converged = stepping.toSteadyState(this, interval);
    return new SteadyFlow(
        options,
        porosity,
        domain.connectedPorosity(),
        percolation,
        permeability,
        domain.column(permeability, flux.meanVelocity()),
        error.estimate(),
        error.lastChange(),
        flux.imbalance(),
        converged,
        flux.highestSpeed() / Math.sqrt(VelocitySet.SOUND_SPEED_SQUARED),
        new SteadyFlow.Chosen(domain.hydraulicDiameter(), relaxationTime, domain.layers()),
        stepping.work(scheme.nodes()),
        pressure.map(
            solver ->
                new SteadyFlow.Corrections(corrections, solver.helpful(), pressureNanos * 1e-9)),
        Optional.empty(),
        Optional.of(FlowField.of(domain, scheme, force, drive())));
  }

  /** Steps, measures, and corrects the pressure where that helps and more steps follow. */
  @Override
  public void advance(long steps) {
    boolean correct = corrects() && steps > GAIN_STEPS;
    loop.run(correct ? steps - GAIN_STEPS : steps);
    if (correct) {
      timed(pressure.get()::noteDensity);
      loop.run(GAIN_STEPS);
    }
    measure();
    if (correct && error.estimate() > options.tolerance()) {
      timed(() -> pressure.get().correct(GAIN_STEPS, flux.section()));
      corrections++;
    }
  }

  /** Whether the pressure is corrected between measurements. */
  private boolean corrects() {
    return pressure.isPresent() && pressure.get().helpful();
  }

  @Override
  public double errorEstimate() {
    return error.estimate();
  }

  @Override
  public int corrections() {
    return corrections;
  }

  private void timed(Runnable work) {
    long begin = System.nanoTime();
    work.run();
    pressureNanos += System.nanoTime() - begin;
  }

  /** Pressure drop over the rock per length and density, nu q / k. */
  private double drive() {
    return scheme.relaxation().viscosity() * flux.superficialVelocity() / permeability;
  }

  private void measure() {
    flux.measure();
    permeability =
        Darcy.permeability(
            scheme.relaxation().viscosity(),
            flux.superficialVelocity(),
            force,
            domain.length(),
            domain.layers(),
            domain.slabPermeability());
    if (!Double.isFinite(permeability)) {
      throw new DivergedException(stepping.steps(), relaxationTime);
    }
    error.add(
        permeability,
        corrects() ? flux.unsettled(force) : CHANGE_PER_IMBALANCE * flux.imbalance(),
        RelaxationChoice.momentumLeft(
            domain.hydraulicDiameter(), scheme.relaxation().viscosity(), stepping.steps()));
    stepping.tell(this, permeability, pressureNanos * 1e-9, scheme.nodes());
  }
}
