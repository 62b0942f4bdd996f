package org.hdispatch.sph.cases;

import org.hdispatch.cell.Ends;
import org.hdispatch.sph.ParticleBox;
import org.hdispatch.sph.ParticleLattice;
import org.hdispatch.sph.WallDistance;
import org.hdispatch.sph.Walls;

/** The gap between two plane walls, y upwards, in 2-D. */
final class Slit {
  private Slit() {}

  static void check(int across) {
    if (across < 4) {
      throw new IllegalArgumentException(
          "there must be at least 4 particles across: across=" + across);
    }
  }

  static ParticleLattice lattice(double gap, int across, int length) {
    double spacing = gap / across;
    ParticleBox box =
        ParticleBox.plane(
            length * spacing,
            (across + 2 * ViscousFlow.LAYERS) * spacing,
            Ends.PERIODIC,
            Ends.OPEN);
    return new ParticleLattice(box, spacing);
  }

  static double low(double gap, int across) {
    return ViscousFlow.LAYERS * gap / across;
  }

  static WallDistance walls(double gap, int across) {
    double low = low(gap, across);
    return Walls.slit(low, low + gap);
  }
}
