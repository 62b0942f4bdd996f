package org.hdispatch.lbm;

import java.util.List;
import java.util.Objects;
import org.hdispatch.cell.CellMap;
import org.hdispatch.dispatch.Pass;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.Tick;

/**
 * The lattice Boltzmann method as a scheme: one pass, "stream-collide", over nodal bundles; two
 * copies of the populations, pull order.
 *
 * <p>A new scheme is at rest: density 1, velocity 0. Every bit of the result is the same for any
 * number of workers and any bundle size.
 */
public final class LbmScheme implements Scheme<NodalBundle, LbmScheme.Scratch> {
  private final VelocitySet set;
  private final Relaxation relaxation;
  private final Equilibrium equilibrium;
  private final BodyForce force;
  private final Collision collision;
  private final CellMap<NodalBundle> bundles;
  private final long nodes;

  private LbmScheme(Builder builder) {
    set = builder.set;
    relaxation = builder.relaxation;
    equilibrium = builder.equilibrium;
    force = builder.force;
    collision = new Collision(set, relaxation, equilibrium, force);
    bundles = BundleMap.of(builder.lattice, set, builder.size);
    long sum = 0;
    for (int n = 0; n < bundles.size(); n++) {
      sum += bundles.cellAt(n).nodes();
    }
    nodes = sum;
    initialise((x, y, z, state) -> {});
  }

  /** Starts a scheme on a lattice: D3Q19, TRT at tau 1, quadratic equilibrium, no force. */
  public static Builder on(Lattice lattice) {
    return new Builder(lattice);
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

    private NodeState() {}
  }

  /**
   * Puts both copies into equilibrium at the given state, which is the velocity halfway through the
   * force: "true rest" has momentum F/2 after collision.
   */
  public void initialise(InitialState initial) {
    NodeState state = new NodeState();
    for (int n = 0; n < bundles.size(); n++) {
      NodalBundle bundle = bundles.cellAt(n);
      for (int node = 0; node < bundle.nodes(); node++) {
        state.density = 1;
        state.ux = 0;
        state.uy = 0;
        state.uz = 0;
        initial.at(bundle.x(node), bundle.y(node), bundle.z(node), state);
        for (int i = 0; i < set.size(); i++) {
          double along = set.cx(i) * force.x() + set.cy(i) * force.y() + set.cz(i) * force.z();
          double f =
              equilibrium.deviation(set, i, state.density, state.ux, state.uy, state.uz)
                  + set.weight(i) * 3 * along / 2;
          bundle.populations(0)[i * bundle.stride() + node] = f;
          bundle.populations(1)[i * bundle.stride() + node] = f;
        }
      }
    }
  }

  @Override
  public CellMap<NodalBundle> cells() {
    return bundles;
  }

  @Override
  public Scratch newScratch() {
    return new Scratch(set);
  }

  @Override
  public List<Pass<NodalBundle, Scratch>> passes() {
    return List.of(new Pass<>("stream-collide", this::streamCollide));
  }

  /** The rows of one chunk of nodes, populations and moments. */
  public static final class Scratch {
    private final double[][] populations;
    private final MomentRows moments = new MomentRows();

    private Scratch(VelocitySet set) {
      populations = new double[set.size()][NodalBundle.paddedLength(StreamPlan.CHUNK)];
    }
  }

  private void streamCollide(NodalBundle bundle, Scratch scratch, Tick tick) {
    StreamPlan plan = bundle.plan();
    double[][] rows = scratch.populations;
    double[] current = bundle.populations(tick.current());
    int at = 0;
    for (int first = 0; first < bundle.nodes(); first += StreamPlan.CHUNK) {
      int n = Math.min(StreamPlan.CHUNK, bundle.nodes() - first);
      at = plan.gather(tick.previous(), at, n, rows);
      collision.collide(rows, scratch.moments, n);
      for (int i = 0; i < rows.length; i++) {
        System.arraycopy(rows[i], 0, current, i * bundle.stride() + first, n);
      }
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

  /**
   * Visits every fluid node, bundle by bundle in the order of hand-out, between two steps.
   *
   * @param tick clock of the loop that runs this scheme
   */
  public void forEachNode(Tick tick, NodeVisitor visitor) {
    Scratch scratch = newScratch();
    for (int n = 0; n < bundles.size(); n++) {
      forEachNode(bundles.cellAt(n), scratch, tick, visitor);
    }
  }

  /**
   * Visits the fluid nodes of one bundle, between two steps. The velocity of stored populations,
   * which are those after collision, is their momentum less half the force.
   */
  public void forEachNode(NodalBundle bundle, Scratch scratch, Tick tick, NodeVisitor visitor) {
    MomentRows m = scratch.moments;
    double[][] rows = scratch.populations;
    for (int first = 0; first < bundle.nodes(); first += StreamPlan.CHUNK) {
      int n = Math.min(StreamPlan.CHUNK, bundle.nodes() - first);
      for (int i = 0; i < set.size(); i++) {
        System.arraycopy(
            bundle.populations(tick.previous()), i * bundle.stride() + first, rows[i], 0, n);
      }
      m.sum(set, rows, n);
      m.addToMomentum(-force.x() / 2, -force.y() / 2, -force.z() / 2, n);
      for (int k = 0; k < n; k++) {
        int node = first + k;
        visitor.visit(
            bundle.x(node),
            bundle.y(node),
            bundle.z(node),
            1 + m.density[k],
            m.x[k],
            m.y[k],
            m.z[k]);
      }
    }
  }

  /** Number of fluid nodes. */
  public long nodes() {
    return nodes;
  }

  /** The lattice's velocities. */
  public VelocitySet velocitySet() {
    return set;
  }

  /** The relaxation rates. */
  public Relaxation relaxation() {
    return relaxation;
  }

  /** The body force. */
  public BodyForce force() {
    return force;
  }

  /** Settings of a scheme; all but the lattice have a default. */
  public static final class Builder {
    private final Lattice lattice;
    private VelocitySet set = VelocitySet.D3Q19;
    private Relaxation relaxation = Relaxation.trt(1);
    private Equilibrium equilibrium = Equilibrium.QUADRATIC;
    private BodyForce force = BodyForce.NONE;
    private BundleSize size = BundleSize.DEFAULT;

    private Builder(Lattice lattice) {
      this.lattice = Objects.requireNonNull(lattice, "lattice");
    }

    /** Sets the velocity set. Default: D3Q19. */
    public Builder velocitySet(VelocitySet velocitySet) {
      set = Objects.requireNonNull(velocitySet, "velocitySet");
      return this;
    }

    /** Sets the relaxation rates. Default: TRT with magic number 3/16 at tau 1. */
    public Builder relaxation(Relaxation rates) {
      relaxation = Objects.requireNonNull(rates, "rates");
      return this;
    }

    /** Sets the equilibrium. Default: quadratic. */
    public Builder equilibrium(Equilibrium form) {
      equilibrium = Objects.requireNonNull(form, "form");
      return this;
    }

    /** Sets the body force. Default: none. */
    public Builder force(BodyForce bodyForce) {
      force = Objects.requireNonNull(bodyForce, "bodyForce");
      return this;
    }

    /** Sets the size of the bundles. Default: {@link BundleSize#DEFAULT}. */
    public Builder bundleSize(BundleSize bundleSize) {
      size = Objects.requireNonNull(bundleSize, "bundleSize");
      return this;
    }

    /** Cuts the lattice into bundles and puts them at rest. */
    public LbmScheme build() {
      return new LbmScheme(this);
    }
  }
}
