package org.hdispatch.lbm;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.List;
import java.util.Objects;
import org.hdispatch.cell.CellMap;
import org.hdispatch.dispatch.Pass;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.Tick;

/**
 * The lattice Boltzmann method as a scheme: one pass, "stream-collide", over nodal bundles; before
 * it "faces", if there are any.
 *
 * <p>A new scheme is at rest: density 1, velocity 0. Every bit of the result is the same for any
 * number of workers, bundle size, {@link Streaming} and {@link KernelForm}. After a step that
 * failed the state is undefined: {@link #initialise} or {@link #restore} it.
 */
public final class LbmScheme implements Scheme<NodalBundle, LbmScheme.Scratch> {
  private final VelocitySet set;
  private final Relaxation relaxation;
  private BodyForce force; // of the next step
  private BodyForce acted; // in the last step
  private final Storage storage;
  private final Immersion immersion; // null: none
  private final CollisionCoefficients coefficients;
  private final CollisionKernels kernels;
  private final CellMap<NodalBundle> bundles;
  private final Faces faces;
  private final long nodes;
  private final Scratch scratch; // the caller's, between steps
  private final Phase phase;
  private final Moments moments;
  private final SavedState savedState;

  LbmScheme(LbmSchemeBuilder builder, SetUp setUp) {
    set = builder.set;
    relaxation = builder.relaxation;
    force = builder.force;
    storage = builder.storage;
    kernels = builder.form.kernels();
    immersion = builder.immersion;
    coefficients = new Collision(set, relaxation, builder.equilibrium, force).coefficients();
    faces =
        new Faces(
            builder.lattice, set, builder.equilibrium, builder.symmetric, builder.pressureAxis);
    faces.densities(builder.firstDensity, builder.lastDensity);
    bundles =
        BundleMap.of(builder.lattice, set, builder.bundleSize(), storage, builder.streaming, setUp);
    if (faces.any()) {
      faces.link(builder.lattice, builder.bundleSize(), bundles);
    }
    long sum = 0;
    for (int n = 0; n < bundles.size(); n++) {
      sum += bundles.cellAt(n).nodes();
    }
    nodes = sum;
    if (immersion != null) {
      immersion.placeIn(builder.lattice, set, relaxation, builder.equilibrium, bundles);
    }
    scratch = newScratch();
    phase = new Phase(builder.streaming);
    moments = new Moments(set, builder.equilibrium, phase);
    savedState = new SavedState(builder.lattice, set, bundles, phase);
    acted = force;
    setUp.pass(
        "rest", bundles, this::newScratch, (bundle, own) -> moments.rest(bundle, own, force));
  }

  /** Starts a scheme on a lattice: D3Q19, TRT at tau 1, quadratic equilibrium, no force. */
  public static LbmSchemeBuilder on(Lattice lattice) {
    return new LbmSchemeBuilder(lattice);
  }

  /** Sets the state of each fluid node before the first step. */
  @FunctionalInterface
  public interface InitialState {
    /**
     * Fills in the state of one node.
     *
     * @param state density 1 and velocity 0 on entry
     */
    void at(int x, int y, int z, NodeState state);
  }

  /** Density and velocity of one node, in lattice units. */
  public static final class NodeState {
    /** Density rho; mean 1. */
    public double density;

    /** Velocity, first component. */
    public double ux;

    /** Velocity, second component. */
    public double uy;

    /** Velocity, third component. */
    public double uz;

    NodeState() {}

    /** Checks what has been filled in for a node. */
    void check(int x, int y, int z) {
      if (!(density > 0 && Double.isFinite(density) && Double.isFinite(ux + uy + uz))) {
        throw new IllegalArgumentException(
            "initial density must be positive and velocity finite: node=("
                + x
                + ", "
                + y
                + ", "
                + z
                + "), density="
                + density
                + ", ux="
                + ux
                + ", uy="
                + uy
                + ", uz="
                + uz);
      }
    }
  }

  /**
   * Puts all nodes into equilibrium at the given state, which is the velocity halfway through the
   * force: "true rest" has momentum F/2 after collision.
   *
   * @throws IllegalArgumentException if a density is not positive, or anything not finite
   */
  public void initialise(InitialState initial) {
    acted = force;
    NodeState state = new NodeState();
    for (int n = 0; n < bundles.size(); n++) {
      moments.initialise(bundles.cellAt(n), scratch, force, state, initial);
    }
  }

  /** Says what to add to a fluid node. */
  @FunctionalInterface
  public interface NodeChange {
    /**
     * Fills in what to add to one node.
     *
     * @param change density 0 and velocity 0 on entry
     */
    void at(int x, int y, int z, NodeState change);
  }

  /**
   * Adds density d and velocity u (times mean density: momentum) to the fluid nodes of one bundle,
   * between two steps: w_i (d + 3 c_i.u) to each population, so that what is not in equilibrium
   * stays as it is. Bundles may be changed by different workers at the same time, each with a
   * scratch of its own.
   */
  public void add(NodalBundle bundle, Scratch scratch, NodeChange change) {
    moments.add(bundle, scratch, change);
  }

  @Override
  public CellMap<NodalBundle> cells() {
    return bundles;
  }

  @Override
  public Scratch newScratch() {
    return new Scratch(
        kernels.kernel(coefficients),
        storage,
        set.size(),
        immersion == null ? null : immersion.newWorker());
  }

  @Override
  public List<Pass<NodalBundle, Scratch>> passes() {
    Pass<NodalBundle, Scratch> streamCollide = new Pass<>("stream-collide", this::streamCollide);
    return faces.any()
        ? List.of(new Pass<>("faces", this::exchange), streamCollide)
        : List.of(streamCollide);
  }

  /** What a worker needs to step: a kernel, and the rows of one chunk of nodes. */
  public static final class Scratch {
    private final CollisionKernel kernel;
    final ChunkCursor cursor = new ChunkCursor();
    private final Rows in;
    private final Rows out;
    final ChunkRows chunk;
    final ChunkRows arriving; // for fluxes
    final NodeRows nodes = new NodeRows(); // those of the chunk
    private final Immersion.Worker immersed; // null: nothing is
    private final int[] numbers = new int[ChunkRows.NODES]; // of the chunk's nodes

    private Scratch(
        CollisionKernel kernel, Storage storage, int velocities, Immersion.Worker immersed) {
      this.kernel = kernel;
      this.immersed = immersed;
      in = Rows.of(storage, velocities);
      out = Rows.of(storage, velocities);
      chunk = ChunkRows.of(storage, velocities);
      arriving = ChunkRows.of(storage, velocities);
    }
  }

  private void exchange(NodalBundle bundle, Scratch scratch, Tick tick) {
    bundle.faceLinks().exchange(phase.previous());
  }

  private void streamCollide(NodalBundle bundle, Scratch scratch, Tick tick) {
    boolean readsNeighbours = phase.readsNeighbours();
    boolean writesNeighbours = phase.writesNeighbours();
    int previous = phase.previous();
    int current = phase.current();
    StreamPlan plan = bundle.plan();
    if (scratch.immersed != null && scratch.immersed.enter(bundle)) {
      immersed(plan, scratch, previous, current, readsNeighbours, writesNeighbours);
      return;
    }
    if (!readsNeighbours && !writesNeighbours) {
      scratch.in.pointAtOwn(bundle.populations(previous), 0);
      scratch.in.collide(scratch.kernel, scratch.in, bundle.nodes(), 1, 0);
      return;
    }
    for (int segment = 0; segment < plan.segments; segment++) {
      int at = segment * plan.segmentLength();
      plan.pointAtSegment(scratch.in, at, previous, readsNeighbours);
      Rows out = scratch.in;
      if (current != previous) {
        out = scratch.out;
        plan.pointAtSegment(out, at, current, writesNeighbours);
      }
      scratch.in.collide(
          scratch.kernel, out, plan.code[at + 1], plan.code[at + 2], plan.code[at + 3]);
    }
    ChunkCursor cursor = scratch.cursor;
    cursor.beginBatches(plan);
    while (cursor.next()) {
      cursor.read(previous, readsNeighbours, scratch.chunk);
      scratch.chunk.collide(scratch.kernel, cursor.nodes());
      cursor.write(current, writesNeighbours, scratch.chunk);
    }
  }

  /** Steps a bundle in which something may be immersed: all of its nodes through scratch. */
  private void immersed(
      StreamPlan plan,
      Scratch scratch,
      int previous,
      int current,
      boolean readsNeighbours,
      boolean writesNeighbours) {
    ChunkCursor cursor = scratch.cursor;
    ChunkRows chunk = scratch.chunk;
    cursor.begin(plan);
    while (cursor.next()) {
      int n = cursor.nodes();
      cursor.read(previous, readsNeighbours, chunk);
      chunk.widen(n);
      for (int k = 0; k < n; k++) {
        scratch.numbers[k] = cursor.node(k);
      }
      boolean covered = scratch.immersed.keep(chunk.wide, scratch.numbers, n) > 0;
      chunk.collide(scratch.kernel, n);
      if (covered) {
        chunk.widen(n);
        scratch.immersed.blend(chunk.wide);
        chunk.narrow(n);
      }
      cursor.write(current, writesNeighbours, chunk);
    }
  }

  @Override
  public void afterStep(Tick tick) {
    phase.advance();
    acted = force;
    if (immersion != null) {
      immersion.afterStep();
    }
  }

  /** Receives density and momentum of a node. */
  @FunctionalInterface
  public interface NodeVisitor {
    /**
     * Visits one fluid node.
     *
     * @param density rho
     * @param ux momentum over mean density (the velocity, but for the small changes of density that
     *     the quadratic equilibrium sees), first component
     * @param uy second component
     * @param uz third component
     */
    void visit(int x, int y, int z, double density, double ux, double uy, double uz);
  }

  /** Visits every fluid node, bundle by bundle in the order of hand-out, between two steps. */
  public void forEachNode(NodeVisitor visitor) {
    for (int n = 0; n < bundles.size(); n++) {
      forEachNode(bundles.cellAt(n), scratch, visitor);
    }
  }

  /**
   * Visits the fluid nodes of one bundle, between two steps. The velocity of stored populations,
   * which are those after collision, is their momentum less half the force of the step that made
   * them.
   */
  public void forEachNode(NodalBundle bundle, Scratch scratch, NodeVisitor visitor) {
    moments.forEachNode(bundle, scratch, acted, visitor);
  }

  /**
   * Visits the fluid nodes of one bundle, between two steps, with the mass flux through each: the
   * mean of its momentum after the last collision and before the next. In a steady flow the sum
   * over a cross-section is the same for every section, exactly, whatever walls, force and immersed
   * bodies there are; away from those it is the momentum of {@link #forEachNode}.
   */
  public void forEachFlux(NodalBundle bundle, Scratch scratch, NodeVisitor visitor) {
    moments.forEachFlux(bundle, scratch, visitor);
  }

  /**
   * Writes the state, from which {@link #restore} goes on with the same bits: a number that tells
   * what it is the state of, then the populations after collision, as big-endian doubles in an
   * order that belongs to the nodes, the lattice and the bundles.
   *
   * @throws IOException if the stream does
   * @throws IllegalStateException if something is immersed, whose state is not known here
   */
  public void save(DataOutput out) throws IOException {
    savedState.write(immersion, scratch, out);
  }

  /**
   * Reads a state that a scheme of the same nodes, lattice and bundles has saved; streaming,
   * storage and kernel may differ. It is taken for one made under the force that is set here, which
   * counts for the velocities until the next step.
   *
   * @throws IOException if the stream does, or if it ends too early
   * @throws IllegalArgumentException if the state is of other nodes, another lattice or other
   *     bundles
   */
  public void restore(DataInput in) throws IOException {
    savedState.read(scratch, in);
    acted = force;
  }

  /** Number of fluid nodes. */
  public long nodes() {
    return nodes;
  }

  /** Bytes held for the nodes: populations, streaming plans, links through faces, places. */
  public long bytes() {
    long sum = 0;
    for (int n = 0; n < bundles.size(); n++) {
      sum += bundles.cellAt(n).bytes();
    }
    return sum;
  }

  /** The lattice's velocities. */
  public VelocitySet velocitySet() {
    return set;
  }

  /** The relaxation rates. */
  public Relaxation relaxation() {
    return relaxation;
  }

  /** The body force of the next step. */
  public BodyForce force() {
    return force;
  }

  /**
   * Changes the densities at the pressure faces, between two steps; allocates nothing.
   *
   * @throws IllegalArgumentException if one is not a positive number
   * @throws IllegalStateException if there are no pressure faces
   */
  public void pressureFaces(double first, double last) {
    if (faces.pressureAxis() < 0) {
      throw new IllegalStateException("scheme must have pressure faces");
    }
    faces.densities(first, last);
  }

  /** Changes the body force, between two steps; allocates nothing. */
  public void drive(BodyForce bodyForce) {
    force = Objects.requireNonNull(bodyForce, "bodyForce");
    coefficients.drive(bodyForce);
  }
}
