package org.hdispatch.lbm.duct;

import java.util.Objects;
import org.hdispatch.cell.Ends;
import org.hdispatch.lbm.BodyForce;
import org.hdispatch.lbm.BundleSize;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.Relaxation;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.Streaming;
import org.hdispatch.lbm.VelocitySet;

/**
 * A square duct of W³ nodes: periodic along x, walls at the ends of y and z, driven from rest by a
 * body force along x; TRT at tau 1, quadratic equilibrium.
 *
 * @param side W, nodes along each axis
 * @param velocitySet lattice
 * @param bundle size of the bundles; cut short where the duct ends
 * @param streaming how populations move
 * @param storage precision of the populations
 * @param kernel form of the kernel
 */
public record Duct(
    int side,
    VelocitySet velocitySet,
    BundleSize bundle,
    Streaming streaming,
    Storage storage,
    KernelForm kernel) {
  /** k/W² of a square duct from the series solution (White, Viscous Fluid Flow, eq. 3-48). */
  public static final double K_OVER_W2 = 0.0351442537;

  /** Most nodes along an axis. */
  public static final int MOST = 4096;

  private static final Relaxation RELAXATION = Relaxation.trt(1);

  /** Bytes between the rows of a bundle, at most. */
  private static final double PADDING = 400;

  /** Bytes of plan for a row of nodes and a velocity, at most; nearly all at the row's ends. */
  private static final double PLAN_OF_ROW = 24;

  /** Mean velocity of the steady flow, in node spacings per step: far below the speed of sound. */
  private static final double MEAN_VELOCITY = 1e-3;

  /**
   * Checks the side.
   *
   * @throws IllegalArgumentException if the side is not 1 to {@link #MOST}
   */
  public Duct {
    if (side < 1 || side > MOST) {
      throw new IllegalArgumentException(
          "side of a duct must be 1 to " + MOST + " nodes: side=" + side);
    }
    Objects.requireNonNull(velocitySet, "velocitySet");
    Objects.requireNonNull(bundle, "bundle");
    Objects.requireNonNull(streaming, "streaming");
    Objects.requireNonNull(storage, "storage");
    Objects.requireNonNull(kernel, "kernel");
  }

  /** Number of nodes, all of them fluid. */
  public long nodes() {
    return (long) side * side * side;
  }

  /**
   * The duct, at rest.
   *
   * @throws IllegalStateException if this JVM cannot run the form of the kernel
   */
  public LbmScheme scheme() {
    return LbmScheme.on(Lattice.empty(side, side, side, Ends.PERIODIC, Ends.OPEN, Ends.OPEN))
        .velocitySet(velocitySet)
        .relaxation(RELAXATION)
        .force(new BodyForce(force(), 0, 0))
        .bundleSize(bundle)
        .streaming(streaming)
        .storage(storage)
        .kernel(kernel)
        .build();
  }

  private double force() {
    return MEAN_VELOCITY * RELAXATION.viscosity() / (K_OVER_W2 * side * side);
  }

  /**
   * Mean velocity of the flow as it is, times nu/(g W²): once the flow is steady, its permeability
   * over W².
   *
   * @param scheme of this duct
   */
  public double kOverW2(LbmScheme scheme) {
    double[] sum = new double[1];
    scheme.forEachNode((x, y, z, density, ux, uy, uz) -> sum[0] += ux);
    double mean = sum[0] / nodes();
    return mean * RELAXATION.viscosity() / (force() * side * side);
  }

  /**
   * Share of the steady flow that is still missing after some steps from rest, at most: that of the
   * slowest mode, exp(-2 pi² nu t/W²).
   */
  public double startUpLeft(long steps) {
    return Math.exp(-slowestDecay() * steps);
  }

  /** Steps from rest after which no more than this share of the steady flow is missing. */
  public long stepsUntil(double startUpLeft) {
    return (long) Math.ceil(-Math.log(startUpLeft) / slowestDecay());
  }

  private double slowestDecay() {
    return 2 * Math.PI * Math.PI * RELAXATION.viscosity() / ((double) side * side);
  }

  /**
   * Bytes that a step must move between memory and cores for a node: in place every population is
   * read and written; with two copies a third transfer fetches the cache line before it is written
   * (write-allocate).
   */
  public int bytesMovedPerNode() {
    int transfers = streaming == Streaming.IN_PLACE ? 2 : 3;
    return transfers * velocitySet.size() * storage.bytes();
  }

  /** Bytes of the largest arrays, which are most of what is held: a pair of velocities each. */
  public double arrayBytes() {
    double nx = Math.min(bundle.nx(), side);
    double inBundle = nx * Math.min(bundle.ny(), side) * Math.min(bundle.nz(), side);
    return 2 * (inBundle * storage.bytes() + PADDING);
  }

  /**
   * Heap that it takes to make and step this duct, in bytes: populations, plan, and the tables of
   * the set-up. An estimate from above, but for what a collector leaves empty at the end of its
   * regions.
   */
  public double estimatedBytes() {
    int velocities = velocitySet.size();
    double nx = Math.min(bundle.nx(), side);
    double inBundle = nx * Math.min(bundle.ny(), side) * Math.min(bundle.nz(), side);
    double rows = streaming.copies() * velocities * (storage.bytes() + PADDING / inBundle);
    double plan = velocities * PLAN_OF_ROW / nx;
    double tables = inBundle * (velocities + 3) * Integer.BYTES;
    return nodes() * (rows + plan) + tables;
  }
}
