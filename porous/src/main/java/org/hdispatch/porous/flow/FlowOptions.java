package org.hdispatch.porous.flow;

import java.io.Serializable;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.Consumer;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.porous.image.Axis;

/**
 * How a steady flow is computed; every setting has a default, and every {@code with} method returns
 * a changed copy.
 *
 * @param axis direction of the flow
 * @param velocitySet lattice
 * @param storage precision of the populations
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
    Storage storage,
    CollisionModel collision,
    OptionalDouble relaxationTime,
    Sides sides,
    Inlet inlet,
    OptionalInt inletLayers,
    Approach approach,
    double tolerance,
    long maxSteps)
    implements Serializable {

  /** Most layers of fluid at each end. */
  private static final int MOST = 10_000;

  /**
   * Flow along z on D3Q19 in double precision with TRT, walls at the sides, slabs at the ends, to
   * an estimated error of 0.1 %, at most 200 000 steps.
   */
  public static final FlowOptions DEFAULT =
      new FlowOptions(
          Axis.Z,
          VelocitySet.D3Q19,
          Storage.DOUBLE,
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
    Objects.requireNonNull(storage, "storage");
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

  /** What a stream holds in place of the options, as it takes no number that may be missing. */
  private record Written(
      Axis axis,
      VelocitySet velocitySet,
      Storage storage,
      CollisionModel collision,
      Double relaxationTime,
      Sides sides,
      Inlet inlet,
      Integer inletLayers,
      Approach approach,
      double tolerance,
      long maxSteps)
      implements Serializable {
    private Object readResolve() {
      return new FlowOptions(
          axis,
          velocitySet,
          storage,
          collision,
          relaxationTime == null ? OptionalDouble.empty() : OptionalDouble.of(relaxationTime),
          sides,
          inlet,
          inletLayers == null ? OptionalInt.empty() : OptionalInt.of(inletLayers),
          approach,
          tolerance,
          maxSteps);
    }
  }

  private Object writeReplace() {
    return new Written(
        axis,
        velocitySet,
        storage,
        collision,
        relaxationTime.isPresent() ? (Double) relaxationTime.getAsDouble() : null,
        sides,
        inlet,
        inletLayers.isPresent() ? (Integer) inletLayers.getAsInt() : null,
        approach,
        tolerance,
        maxSteps);
  }

  /** Settings on their way to a changed copy. */
  private static final class Draft {
    Axis axis;
    VelocitySet velocitySet;
    Storage storage;
    CollisionModel collision;
    OptionalDouble relaxationTime;
    Sides sides;
    Inlet inlet;
    OptionalInt inletLayers;
    Approach approach;
    double tolerance;
    long maxSteps;

    Draft(FlowOptions from) {
      axis = from.axis;
      velocitySet = from.velocitySet;
      storage = from.storage;
      collision = from.collision;
      relaxationTime = from.relaxationTime;
      sides = from.sides;
      inlet = from.inlet;
      inletLayers = from.inletLayers;
      approach = from.approach;
      tolerance = from.tolerance;
      maxSteps = from.maxSteps;
    }
  }

  private FlowOptions with(Consumer<Draft> change) {
    Draft to = new Draft(this);
    change.accept(to);
    return new FlowOptions(
        to.axis,
        to.velocitySet,
        to.storage,
        to.collision,
        to.relaxationTime,
        to.sides,
        to.inlet,
        to.inletLayers,
        to.approach,
        to.tolerance,
        to.maxSteps);
  }

  /** A copy with another direction of flow. */
  public FlowOptions withAxis(Axis direction) {
    return with(to -> to.axis = direction);
  }

  /** A copy with another lattice. */
  public FlowOptions withVelocitySet(VelocitySet set) {
    return with(to -> to.velocitySet = set);
  }

  /** A copy with populations in another precision. */
  public FlowOptions withStorage(Storage precision) {
    return with(to -> to.storage = precision);
  }

  /** A copy with another collision. */
  public FlowOptions withCollision(CollisionModel model) {
    return with(to -> to.collision = model);
  }

  /** A copy with a given relaxation time. */
  public FlowOptions withRelaxationTime(double tau) {
    return with(to -> to.relaxationTime = OptionalDouble.of(tau));
  }

  /** A copy with other boundaries. */
  public FlowOptions withBoundaries(Sides atSides, Inlet atEnds) {
    return with(
        to -> {
          to.sides = atSides;
          to.inlet = atEnds;
        });
  }

  /** A copy with another thickness of the slabs. */
  public FlowOptions withInletLayers(int layers) {
    return with(to -> to.inletLayers = OptionalInt.of(layers));
  }

  /** A copy with another way to the steady state. */
  public FlowOptions withApproach(Approach way) {
    return with(to -> to.approach = way);
  }

  /** A copy with another tolerance. */
  public FlowOptions withTolerance(double relativeError) {
    return with(to -> to.tolerance = relativeError);
  }

  /** A copy with another limit of steps. */
  public FlowOptions withMaxSteps(long steps) {
    return with(to -> to.maxSteps = steps);
  }
}
