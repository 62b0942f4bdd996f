package org.hdispatch.app.permeability;

import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.app.rock.Rock;
import org.hdispatch.app.watch.CollectorReport;
import org.hdispatch.app.watch.CollectorWatch;
import org.hdispatch.porous.block.FlowFigures;
import org.hdispatch.porous.block.Method;
import org.hdispatch.porous.block.Walls;
import org.hdispatch.porous.darcy.Permeability;
import org.hdispatch.porous.darcy.PhysicalFlow;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.flow.SteadyFlow;

/**
 * A computed permeability and all that belongs to it.
 *
 * @param method by which it was computed
 * @param rock the rock
 * @param fluid fluid and drive
 * @param flow the flow, in voxel units
 * @param threads workers
 * @param collector what the collector did; empty if that could not be read
 */
record Outcome(
    Method method,
    Rock rock,
    PhysicalFlow fluid,
    SteadyFlow flow,
    int threads,
    Optional<CollectorWatch.Figures> collector) {

  FlowOptions options() {
    return flow.options();
  }

  Walls walls() {
    return rock.solid().isPresent() ? Walls.IMB : Walls.BOUNCE_BACK;
  }

  /** All that it comes to in physical units. */
  FlowFigures figures() {
    return new FlowFigures(flow, rock.voxelEdge(), fluid);
  }

  Permeability permeability() {
    return figures().permeability();
  }

  CollectorReport collectorReport() {
    return new CollectorReport(collector, flow.work().stats(), flow.work().warmUpSteps());
  }

  boolean percolates() {
    return flow.percolation().percolates();
  }

  double connectedPorosity() {
    return flow.connectedPorosity();
  }

  /** Superficial (Darcy) velocity, m/s, if the voxel edge is known. */
  OptionalDouble superficialVelocity() {
    return figures().superficialVelocity();
  }

  /** Mean velocity within the connected pores, m/s, if the voxel edge is known. */
  OptionalDouble poreVelocity() {
    return figures().poreVelocity();
  }

  /** Reynolds number of the pore velocity and the hydraulic diameter, if the edge is known. */
  OptionalDouble reynolds() {
    return figures().reynolds();
  }
}
