package org.hdispatch.sph;

/** Gathers the particles within reach of a cell into a worker's scratch. */
final class Surroundings {
  private final ParticleGrid grid;
  private final PairModel model;
  private final double[] viscosities; // by phase, as the plane holds them
  private final double[] numbers; // of the phases; null: no force depends on them

  Surroundings(ParticleGrid grid, PairModel model, double[] viscosities, boolean phases) {
    this.grid = grid;
    this.model = model;
    this.viscosities = viscosities;
    numbers = phases ? new double[viscosities.length] : null;
    for (int phase = 0; phases && phase < numbers.length; phase++) {
      numbers[phase] = phase;
    }
  }

  /** Gathers positions. */
  void positions(ParticleCell cell, int buffer, Neighbourhood near) {
    begin(cell, near);
    for (int slot = 0; slot < ParticleCell.SLOTS; slot++) {
      ParticleCell other = cell.around[slot];
      if (other != null && other.count > 0) {
        addPositions(cell, slot, other, buffer, near);
      }
    }
    near.close(Neighbourhood.UX);
  }

  /** Gathers all that forces depend on. */
  void states(ParticleCell cell, int buffer, Neighbourhood near) {
    begin(cell, near);
    for (int slot = 0; slot < ParticleCell.SLOTS; slot++) {
      ParticleCell other = cell.around[slot];
      if (other != null && other.count > 0) {
        addPositions(cell, slot, other, buffer, near);
        ParticleArrays from = other.buffers[buffer];
        near.copyLast(Neighbourhood.UX, from.ux, other.count);
        near.copyLast(Neighbourhood.UY, from.uy, other.count);
        near.copyLast(Neighbourhood.UZ, from.uz, other.count);
        near.copyLast(Neighbourhood.VOLUME, other.volume, other.count);
        near.copyLast(Neighbourhood.PRESSURE, other.pressure, other.count);
        if (!model.uniform()) {
          near.phasesLast(Neighbourhood.VISCOSITY, from.phase, viscosities, other.count);
          if (model.walled()) {
            near.copyLast(Neighbourhood.DEPTH, other.depth, other.count);
          } else {
            near.clearLast(Neighbourhood.DEPTH, other.count);
          }
        }
        if (numbers != null) {
          near.phasesLast(Neighbourhood.PHASE, from.phase, numbers, other.count);
        }
      }
    }
    near.close(
        numbers != null
            ? Neighbourhood.PHASE + 1
            : model.uniform() ? Neighbourhood.VISCOSITY : Neighbourhood.PHASE);
  }

  private static void begin(ParticleCell cell, Neighbourhood near) {
    int room = 0;
    for (ParticleCell other : cell.around) {
      room += other == null ? 0 : other.count;
    }
    near.clear(room);
  }

  private void addPositions(
      ParticleCell cell, int slot, ParticleCell other, int buffer, Neighbourhood near) {
    if (slot == ParticleCell.ITSELF) {
      near.ownFollow(cell.count, cell.fluids);
    }
    near.addPositions(
        other.buffers[buffer],
        other.count,
        grid.shift(cell.key, slot, 0),
        grid.shift(cell.key, slot, 1),
        grid.shift(cell.key, slot, 2));
  }
}
