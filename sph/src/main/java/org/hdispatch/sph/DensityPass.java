package org.hdispatch.sph;

import org.hdispatch.dispatch.CellKernel;
import org.hdispatch.dispatch.Tick;

/** Finds number density, volume and pressure of the particles of a cell. */
final class DensityPass implements CellKernel<ParticleCell, SphScratch> {
  private final Surroundings surroundings;
  private final StepPlan plan;
  private final SearchMode mode;
  private final double reach;
  private final Phase[] phases;

  DensityPass(
      Surroundings surroundings, StepPlan plan, SearchMode mode, double reach, Phase[] phases) {
    this.surroundings = surroundings;
    this.plan = plan;
    this.mode = mode;
    this.reach = reach;
    this.phases = phases;
  }

  @Override
  public void process(ParticleCell cell, SphScratch scratch, Tick tick) {
    if (cell.count == 0) {
      return;
    }
    long begin = System.nanoTime();
    surroundings.positions(cell, plan.at, scratch.near);
    NeighbourList list = mode == SearchMode.DOUBLE ? scratch.list : cell.list;
    if (plan.rehash) {
      scratch.sums.search(scratch.near, reach, scratch.list);
      if (mode != SearchMode.DOUBLE) {
        list.copy(scratch.list);
      }
    }
    long found = System.nanoTime();
    scratch.makeRoom(cell.count);
    scratch.sums.density(scratch.near, list, scratch.density);
    setPressures(cell, scratch.density);
    cell.searchNanos += found - begin;
    cell.densityNanos = System.nanoTime() - found;
  }

  /** A solid counts as at least as dense as at rest, as what lies deeper is left out. */
  private void setPressures(ParticleCell cell, double[] density) {
    byte[] phase = cell.buffers[plan.at].phase;
    double least = Double.POSITIVE_INFINITY;
    double most = 0;
    for (int n = 0; n < cell.count; n++) {
      Phase of = phases[phase[n]];
      double rest = of.state().restDensity();
      double rho = of.mass() * density[n];
      if (of.solid()) {
        rho = Math.max(rho, rest);
      } else {
        least = Math.min(least, rho / rest);
        most = Math.max(most, rho / rest);
      }
      double volume = of.mass() / rho;
      cell.volume[n] = volume;
      cell.pressure[n] = of.state().pressure(rho) * volume * volume;
    }
    cell.leastCompression = least;
    cell.mostCompression = most;
  }
}
