package org.hdispatch.sph;

import java.util.Arrays;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.KeyOrder;

/** Puts the particles to begin with into cells. */
final class Filling {
  private Filling() {}

  static CellMap<ParticleCell> of(ParticleGrid grid, Particles particles) {
    long[] keys = new long[particles.count()];
    for (int n = 0; n < keys.length; n++) {
      keys[n] = grid.keyAt(particles.x(n), particles.y(n), particles.z(n));
    }
    long[] distinct = Arrays.stream(keys).distinct().toArray();
    CellMap<ParticleCell> cells =
        CellMap.of(distinct, KeyOrder.MORTON, ParticleCell::new, ParticleCell::renew);
    for (long key : keys) {
      cells.get(key).count++;
    }
    for (int n = 0; n < cells.size(); n++) {
      ParticleCell cell = cells.cellAt(n);
      cell.buffers[0].makeRoom(cell.count);
      cell.count = 0;
    }
    for (int n = 0; n < keys.length; n++) {
      ParticleCell cell = cells.get(keys[n]);
      ParticleArrays to = cell.buffers[0];
      int at = cell.count++;
      to.x[at] = particles.x(n);
      to.y[at] = particles.y(n);
      to.z[at] = particles.z(n);
      to.vx[at] = particles.u(n);
      to.vy[at] = particles.v(n);
      to.vz[at] = particles.w(n);
      to.ux[at] = particles.u(n);
      to.uy[at] = particles.v(n);
      to.uz[at] = particles.w(n);
      to.phase[at] = (byte) particles.phase(n);
      to.id[at] = n;
    }
    return cells;
  }
}
