package org.hdispatch.app.steady;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import org.hdispatch.app.rock.Rock;
import org.hdispatch.porous.darcy.Permeability;
import org.hdispatch.porous.flow.SteadyFlow;

/**
 * Both ways to the steady state of one rock.
 *
 * @param rock the rock
 * @param reference where its steady k is from
 * @param corrected pressure started and corrected
 * @param plain from rest, by stepping alone
 */
record SteadyComparison(
    Rock rock, Reference reference, SteadyCourse corrected, SteadyCourse plain) {

  /**
   * The steady k.
   *
   * @param connectedPorosity pore volume of the spanning clusters over that of the rock box
   * @param fluidNodes fluid nodes, slabs included
   * @param inletLayers layers of fluid at each end
   * @param permeability k, voxel²
   * @param errorEstimate its estimated relative error
   * @param converged whether that came below the tolerance
   * @param steps that it took
   */
  record Reference(
      double connectedPorosity,
      long fluidNodes,
      int inletLayers,
      double permeability,
      double errorEstimate,
      boolean converged,
      long steps) {

    static Reference of(SteadyFlow flow) {
      return new Reference(
          flow.connectedPorosity(),
          flow.work().fluidNodes(),
          flow.chosen().inletLayers(),
          flow.permeability(),
          flow.errorEstimate(),
          flow.converged(),
          flow.work().steps());
    }
  }

  double porosity() {
    return rock.space().porosity();
  }

  Permeability permeability() {
    return new Permeability(reference.permeability(), rock.voxelEdge());
  }

  List<SteadyCourse> courses() {
    return List.of(corrected, plain);
  }

  /** Steps of a course until k stays within this share, over those of the corrected one. */
  OptionalDouble stepsRatio(SteadyCourse course, double share) {
    return ratio(course, share, SteadyCourse.Point::step);
  }

  /** Seconds of a course until k stays within this share, over those of the corrected one. */
  OptionalDouble secondsRatio(SteadyCourse course, double share) {
    return ratio(course, share, SteadyCourse.Point::seconds);
  }

  private OptionalDouble ratio(
      SteadyCourse course, double share, ToDoubleFunction<SteadyCourse.Point> what) {
    Optional<SteadyCourse.Point> here = course.within(share);
    Optional<SteadyCourse.Point> there = corrected.within(share);
    return here.isPresent() && there.isPresent()
        ? OptionalDouble.of(what.applyAsDouble(here.get()) / what.applyAsDouble(there.get()))
        : OptionalDouble.empty();
  }
}
