package org.hdispatch.sph;

import org.hdispatch.cell.CellMap;

/** Counts neighbours within the support, which quads of lists tell only from above. */
final class NeighbourCount {
  private final Surroundings surroundings;
  private final double square;
  private long neighbours;
  private long particles;

  NeighbourCount(Surroundings surroundings, double supportRadius) {
    this.surroundings = surroundings;
    square = supportRadius * supportRadius;
  }

  /** Mean over the fluid particles of all cells, places being those in a buffer. */
  double mean(CellMap<ParticleCell> cells, int buffer) {
    Neighbourhood near = new Neighbourhood();
    for (int n = 0; n < cells.size(); n++) {
      ParticleCell cell = cells.cellAt(n);
      if (cell.fluids > 0) {
        surroundings.positions(cell, buffer, near);
        count(near);
      }
    }
    return (double) neighbours / particles;
  }

  private void count(Neighbourhood near) {
    double[] values = near.values();
    int y = Neighbourhood.Y * near.stride();
    int z = Neighbourhood.Z * near.stride();
    for (int i = near.own(); i < near.own() + near.ownFluids(); i++) {
      int within = 0;
      for (int n = 0; n < near.count(); n++) {
        double dx = values[i] - values[n];
        double dy = values[y + i] - values[y + n];
        double dz = values[z + i] - values[z + n];
        within += dx * dx + dy * dy + dz * dz < square ? 1 : 0;
      }
      neighbours += within - 1; // without the particle itself
    }
    particles += near.ownFluids();
  }
}
