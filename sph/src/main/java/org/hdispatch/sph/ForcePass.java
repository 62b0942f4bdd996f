package org.hdispatch.sph;

import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.dispatch.CellKernel;
import org.hdispatch.dispatch.Tick;

/**
 * Sums up the forces on the fluid particles of a cell and moves them on, from one buffer to the
 * other: the leapfrog, with the velocity of forces taken half a step ahead.
 *
 * <pre>
 * v(t + dt/2) = v(t - dt/2) + a(t) dt,   x(t + dt) = x(t) + v(t + dt/2) dt,
 * u(t + dt) = v(t + dt/2) + a(t) dt/2:   the velocity that forces will see
 * </pre>
 */
final class ForcePass implements CellKernel<ParticleCell, SphScratch> {
  private final Surroundings surroundings;
  private final ParticleGrid grid;
  private final StepPlan plan;
  private final SearchMode mode;
  private final double reach;
  private final Phase[] phases;
  private final WallDistance walls; // null: none
  private final double leastDistance; // from a wall
  private final AccelerationField field; // null: none

  ForcePass(
      Surroundings surroundings,
      ParticleGrid grid,
      StepPlan plan,
      SearchMode mode,
      double reach,
      Phase[] phases,
      WallDistance walls,
      double leastDistance,
      AccelerationField field) {
    this.surroundings = surroundings;
    this.grid = grid;
    this.plan = plan;
    this.mode = mode;
    this.reach = reach;
    this.phases = phases;
    this.walls = walls;
    this.leastDistance = leastDistance;
    this.field = field;
  }

  @Override
  public void process(ParticleCell cell, SphScratch scratch, Tick tick) {
    cell.leaving = 0;
    cell.fastestSquare = 0;
    if (plan.rehash) {
      copyWhatStays(cell);
    }
    if (cell.fluids == 0) {
      return;
    }
    long begin = System.nanoTime();
    surroundings.states(cell, plan.at, scratch.near);
    if (walls != null) {
      setNearness(cell, scratch.near);
    }
    NeighbourList list = mode == SearchMode.DOUBLE ? scratch.list : cell.list;
    long found = begin;
    if (mode == SearchMode.DOUBLE) {
      scratch.sums.search(scratch.near, reach, list);
      found = System.nanoTime();
    }
    scratch.makeRoom(cell.count);
    scratch.sums.force(
        scratch.near, list, scratch.forceX, scratch.forceY, scratch.forceZ, scratch.share);
    if (scratch.pairs != null) {
      cell.makeVirialRoom();
      scratch.pairs.add(
          scratch.near, list, scratch.forceX, scratch.forceY, scratch.forceZ, cell.virial);
    }
    if (field != null) {
      addField(cell, scratch);
    }
    move(cell, scratch, tick);
    cell.searchNanos += found - begin;
    cell.forceNanos = System.nanoTime() - found;
  }

  private void copyWhatStays(ParticleCell cell) {
    ParticleArrays at = cell.buffers[plan.at];
    ParticleArrays to = cell.buffers[plan.to];
    to.makeRoom(cell.count);
    System.arraycopy(at.phase, 0, to.phase, 0, cell.count);
    System.arraycopy(at.id, 0, to.id, 0, cell.count);
    for (int n = cell.fluids; n < cell.count; n++) {
      to.copy(n, at, n, 0, 0, 0);
    }
  }

  private void setNearness(ParticleCell cell, Neighbourhood near) {
    ParticleArrays at = cell.buffers[plan.at];
    double[] nearness = near.nearness();
    for (int n = 0; n < cell.fluids; n++) {
      double distance = walls.at(at.x[n], at.y[n], at.z[n]);
      nearness[n] = 1 / Math.max(distance, leastDistance);
    }
  }

  private void addField(ParticleCell cell, SphScratch scratch) {
    ParticleArrays at = cell.buffers[plan.at];
    double[] a = scratch.acceleration;
    for (int n = 0; n < cell.fluids; n++) {
      field.at(at.x[n], at.y[n], at.z[n], a);
      double mass = phases[at.phase[n]].mass();
      scratch.forceX[n] = Math.fma(mass, a[0], scratch.forceX[n]);
      scratch.forceY[n] = Math.fma(mass, a[1], scratch.forceY[n]);
      scratch.forceZ[n] = Math.fma(mass, a[2], scratch.forceZ[n]);
    }
  }

  private void move(ParticleCell cell, SphScratch scratch, Tick tick) {
    ParticleArrays at = cell.buffers[plan.at];
    ParticleArrays to = cell.buffers[plan.to];
    double dt = plan.timeStep;
    double kick = plan.kick;
    double fastest = 0;
    double farthest = grid.leastEdge() / dt;
    for (int n = 0; n < cell.fluids; n++) {
      double inverseMass = 1 / phases[at.phase[n]].mass();
      double share = scratch.share[n];
      double ax = share * Math.fma(scratch.forceX[n], inverseMass, plan.gx);
      double ay = share * Math.fma(scratch.forceY[n], inverseMass, plan.gy);
      double az = share * Math.fma(scratch.forceZ[n], inverseMass, plan.gz);
      double vx = Math.fma(ax, kick, at.vx[n]);
      double vy = Math.fma(ay, kick, at.vy[n]);
      double vz = Math.fma(az, kick, at.vz[n]);
      double square = vx * vx + vy * vy + vz * vz;
      if (!(square < farthest * farthest)) { // NaN too
        throw BlownUp.tooFast(at, n, Math.sqrt(square) * dt, grid.leastEdge());
      }
      fastest = Math.max(fastest, square);
      to.vx[n] = vx;
      to.vy[n] = vy;
      to.vz[n] = vz;
      to.ux[n] = Math.fma(ax, dt / 2, vx);
      to.uy[n] = Math.fma(ay, dt / 2, vy);
      to.uz[n] = Math.fma(az, dt / 2, vz);
      to.x[n] = Math.fma(vx, dt, at.x[n]);
      to.y[n] = Math.fma(vy, dt, at.y[n]);
      to.z[n] = Math.fma(vz, dt, at.z[n]);
      noteLeaver(cell, to, n, tick);
    }
    cell.fastestSquare = fastest;
  }

  private void noteLeaver(ParticleCell cell, ParticleArrays to, int n, Tick tick) {
    int i = side(to.x[n], cell.key, 0);
    int j = side(to.y[n], cell.key, 1);
    int k = side(to.z[n], cell.key, 2);
    int slot = ParticleCell.ITSELF + i + 3 * (j + 3 * k);
    if (slot == ParticleCell.ITSELF) {
      return;
    }
    ParticleCell there = cell.around[slot];
    if (there == null || there.count == 0) { // an empty cell may be about to vanish
      CellGrid cells = grid.cells();
      long key = cell.neighbour(cells, slot);
      if (key == CellKey.NONE) {
        throw BlownUp.leftTheBox(to, n);
      }
      tick.changes().add(key);
    }
    cell.addLeaver(n, slot);
  }

  private int side(double place, long key, int axis) {
    return place < grid.low(key, axis) ? -1 : place >= grid.high(key, axis) ? 1 : 0;
  }
}
