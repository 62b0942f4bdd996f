package org.hdispatch.sph;

import java.util.Arrays;
import org.hdispatch.cell.CellMap;
import org.hdispatch.dispatch.CellKernel;
import org.hdispatch.dispatch.Tick;

/**
 * Puts particles into the cells that they are in, without a lock: each cell gathers its own that
 * have stayed and those around it that have left for it, from one buffer into the other.
 *
 * <p>Within the cell fluid comes before solid, and particles of the same bin lie side by side, bin
 * rows along x, so that the particles of a quad are near each other.
 */
final class Rehash implements CellKernel<ParticleCell, SphScratch> {
  private final CellMap<ParticleCell> cells;
  private final ParticleGrid grid;
  private final StepPlan plan;
  private final boolean[] solid; // by phase
  private final WallDistance walls; // null: none
  private final int binsX;
  private final int binsY;
  private final int binsZ;

  /**
   * A kernel for these cells.
   *
   * @param binEdge edge of a bin: about the distance of particles
   */
  Rehash(
      CellMap<ParticleCell> cells,
      ParticleGrid grid,
      StepPlan plan,
      boolean[] solid,
      WallDistance walls,
      double binEdge) {
    this.cells = cells;
    this.grid = grid;
    this.plan = plan;
    this.solid = solid;
    this.walls = walls;
    binsX = bins(grid.edge(0), binEdge);
    binsY = bins(grid.edge(1), binEdge);
    binsZ = grid.box().dimensions() == 2 ? 1 : bins(grid.edge(2), binEdge);
  }

  private static int bins(double edge, double binEdge) {
    return (int) Math.max(1, Math.min(32, Math.round(edge / binEdge)));
  }

  /** Bins of a cell, fluid and solid. */
  int bins() {
    return 2 * binsX * binsY * binsZ;
  }

  @Override
  public void process(ParticleCell cell, SphScratch scratch, Tick tick) {
    if (!plan.rehash) {
      return;
    }
    long begin = System.nanoTime();
    cell.link(cells, grid.cells());
    pick(cell, scratch);
    place(cell, scratch);
    if (cell.count == 0) {
      tick.changes().remove(cell.key);
    }
    cell.searchNanos = System.nanoTime() - begin;
  }

  private void pick(ParticleCell cell, SphScratch scratch) {
    scratch.picked = 0;
    ParticleArrays own = cell.buffers[plan.from];
    int left = 0;
    for (int n = 0; n < cell.count; n++) {
      if (left < cell.leaving && cell.leavers[left] == n) {
        left++;
      } else {
        pick(cell, scratch, ParticleCell.ITSELF, own, n);
      }
    }
    for (int slot = 0; slot < ParticleCell.SLOTS; slot++) {
      ParticleCell other = cell.around[slot];
      if (other == null || other.leaving == 0) {
        continue;
      }
      int way = ParticleCell.SLOTS - 1 - slot; // seen from there, this cell lies opposite
      for (int n = 0; n < other.leaving; n++) {
        if (other.ways[n] == way) {
          pick(cell, scratch, slot, other.buffers[plan.from], other.leavers[n]);
        }
      }
    }
  }

  private void pick(
      ParticleCell cell, SphScratch scratch, int slot, ParticleArrays from, int index) {
    int i = bin(from.x[index], cell.key, slot, 0, binsX);
    int j = bin(from.y[index], cell.key, slot, 1, binsY);
    int k = binsZ == 1 ? 0 : bin(from.z[index], cell.key, slot, 2, binsZ);
    int fluid = i + binsX * (j + binsY * k);
    scratch.pick(slot, index, solid[from.phase[index]] ? fluid + binsX * binsY * binsZ : fluid);
  }

  private int bin(double place, long key, int slot, int axis, int bins) {
    double inside = place + grid.shift(key, slot, axis) - grid.low(key, axis);
    return Math.max(0, Math.min(bins - 1, (int) (inside / grid.edge(axis) * bins)));
  }

  private void place(ParticleCell cell, SphScratch scratch) {
    int picked = scratch.picked;
    int[] starts = scratch.binStarts;
    Arrays.fill(starts, 0);
    for (int n = 0; n < picked; n++) {
      starts[scratch.bins[n] + 1]++;
    }
    for (int bin = 1; bin < starts.length; bin++) {
      starts[bin] += starts[bin - 1];
    }
    cell.count = picked;
    cell.fluids = starts[binsX * binsY * binsZ];
    ParticleArrays to = cell.buffers[plan.at];
    to.makeRoom(picked);
    cell.makeRoom(picked, walls != null);
    for (int n = 0; n < picked; n++) {
      int slot = scratch.slots[n];
      ParticleArrays from =
          (slot == ParticleCell.ITSELF ? cell : cell.around[slot]).buffers[plan.from];
      to.copy(
          starts[scratch.bins[n]]++,
          from,
          scratch.indices[n],
          grid.shift(cell.key, slot, 0),
          grid.shift(cell.key, slot, 1),
          grid.shift(cell.key, slot, 2));
    }
    if (walls != null) {
      Arrays.fill(cell.depth, 0, cell.fluids, 0);
      for (int n = cell.fluids; n < picked; n++) {
        cell.depth[n] = Math.max(0, -walls.at(to.x[n], to.y[n], to.z[n]));
      }
    }
  }
}
