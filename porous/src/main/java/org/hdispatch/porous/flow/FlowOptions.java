package org.hdispatch.porous.flow;

import java.util.Objects;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.porous.image.Axis;

/**
 * How a steady flow is computed; every setting has a default, and every {@code with} method returns
 * a changed copy.
 *
 * @param axis direction of the flow
 * @param velocitySet lattice
 * @param collision how populations relax
 * @param relaxationTime tau, in steps; empty to have it chosen from the pore space
 * @param sides what bounds the rock at the sides
 * @param inlet what bounds the rock at the ends
 * @param inletLayers layers of fluid at each end, if the inlet is a slab; empty to have them chosen
 *     from the width of the pores
 * @param approach how the flow gets to its steady state
 * @param tolerance estimated relative error of k at which to stop
 * @param maxSteps steps after which to give up
 */
public record FlowOptions(
    Axis axis,
    VelocitySet velocitySet,
    CollisionModel collision,
    OptionalDouble relaxationTime,
    Sides sides,
    Inlet inlet,
    OptionalInt inletLayers,
    Approach approach,
    double tolerance,
    long maxSteps) {

  /** Most layers of fluid at each end. */
  private static final int MOST = 10_000;

  /**
   * Flow along z on D3Q19 with TRT, walls at the sides, slabs at the ends, to an estimated error of
   * 0.1 %, at most 200 000 steps.
   */
  public static final FlowOptions DEFAULT =
      new FlowOptions(
          Axis.Z,
          VelocitySet.D3Q19,
          CollisionModel.TRT,
          OptionalDouble.empty(),
          Sides.WALL,
          Inlet.SLAB,
          OptionalInt.empty(),
          Approach.CORRECTED,
          1e-3,
          200_000);

  /**
   * What immersed boundaries ask for: D3Q15 with BGK, at tau 0.6 if none is given. The rest as in
   * {@link #DEFAULT}.
   */
  public static final FlowOptions IMMERSED =
      DEFAULT.withVelocitySet(VelocitySet.D3Q15).withCollision(CollisionModel.BGK);

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if tau is not above 1/2, the layers are not 1 to 10 000, the
   *     tolerance is not between 0 and 1, or the steps are less than 1
   */
  public FlowOptions {
    Objects.requireNonNull(axis, "axis");
    Objects.requireNonNull(velocitySet, "velocitySet");
    Objects.requireNonNull(collision, "collision");
    Objects.requireNonNull(sides, "sides");
    Objects.requireNonNull(inlet, "inlet");
    Objects.requireNonNull(approach, "approach");
    if (relaxationTime.isPresent()) {
      collision.at(relaxationTime.getAsDouble());
    }
    if (inletLayers.isPresent() && (inletLayers.getAsInt() < 1 || inletLayers.getAsInt() > MOST)) {
      throw new IllegalArgumentException(
          "inlet layers must number 1 to " + MOST + ": layers=" + inletLayers.getAsInt());
    }
    if (!(tolerance > 0 && tolerance < 1)) {
      throw new IllegalArgumentException(
          "tolerance must lie between 0 and 1: tolerance=" + tolerance);
    }
    if (maxSteps < 1) {
      throw new IllegalArgumentException("steps must number at least 1: steps=" + maxSteps);
    }
  }

  /** A copy with another direction of flow. */
  public FlowOptions withAxis(Axis direction) {
    return new FlowOptions(
        direction,
        velocitySet,
        collision,
        relaxationTime,
        sides,
        inlet,
        inletLayers,
        approach,
        tolerance,
        maxSteps);
  }

  /** A copy with another lattice. */
  public FlowOptions withVelocitySet(VelocitySet set) {
    return new FlowOptions(
        axis,
        set,
        collision,
        relaxationTime,
        sides,
        inlet,
        inletLayers,
        approach,
        tolerance,
        maxSteps);
  }

  /** A copy with another collision. */
  public FlowOptions withCollision(CollisionModel model) {
    return new FlowOptions(
        axis,
        velocitySet,
        model,
        relaxationTime,
        sides,
        inlet,
        inletLayers,
        approach,
        tolerance,
        maxSteps);
  }

  /** A copy with a given relaxation time. */
  public FlowOptions withRelaxationTime(double tau) {
    return new FlowOptions(
        axis,
        velocitySet,
        collision,
        OptionalDouble.of(tau),
        sides,
        inlet,
        inletLayers,
        approach,
        tolerance,
        maxSteps);
  }

  /** A copy with other boundaries. */
  public FlowOptions withBoundaries(Sides atSides, Inlet atEnds) {
    return new FlowOptions(
        axis,
        velocitySet,
        collision,
        relaxationTime,
        atSides,
        atEnds,
        inletLayers,
        approach,
        tolerance,
        maxSteps);
  }

  /** A copy with another thickness of the slabs. */
  public FlowOptions withInletLayers(int layers) {
    return new FlowOptions(
        axis,
        velocitySet,
        collision,
        relaxationTime,
        sides,
        inlet,
        OptionalInt.of(layers),
        approach,
        tolerance,
        maxSteps);
  }

  /** A copy with another way to the steady state. */
  public FlowOptions withApproach(Approach way) {
    return new FlowOptions(
        axis,
        velocitySet,
        collision,
        relaxationTime,
        sides,
        inlet,
        inletLayers,
        way,
        tolerance,
        maxSteps);
  }

  /** A copy with another tolerance. */
  public FlowOptions withTolerance(double relativeError) {
    return new FlowOptions(
        axis,
        velocitySet,
        collision,
        relaxationTime,
        sides,
        inlet,
        inletLayers,
        approach,
        relativeError,
        maxSteps);
  }

  /** A copy with another limit of steps. */
  public FlowOptions withMaxSteps(long steps) {
    return new FlowOptions(
        axis,
        velocitySet,
        collision,
        relaxationTime,
        sides,
        inlet,
        inletLayers,
        approach,
        tolerance,
        steps);
  }
}
