package org.hdispatch.app.particles;

import java.util.List;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.app.draw.ColourMap;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.io.VtiArray;
import org.hdispatch.porous.io.VtpWriter;
import org.hdispatch.sph.Phase;
import org.hdispatch.sph.SphScheme;

/**
 * The files of particles as they are: {@code particles.vtp} with all of them, in the units of the
 * flow, and a picture of a plane or of a slice through the middle, {@code particles.png}.
 */
final class ParticleFiles {
  private static final int PLACE = 0;
  private static final int VELOCITY = 3;
  private static final int DENSITY = 6;
  private static final int PRESSURE = 7;
  private static final int VALUES = 8;

  private final List<Phase> phases;
  private final double spacing;
  private final byte[] phase; // by identity, as all here
  private final float[] values;

  /**
   * Keeps the state of all particles.
   *
   * @param spacing distance of particles
   */
  ParticleFiles(SphScheme scheme, double spacing) {
    phases = scheme.phases();
    this.spacing = spacing;
    phase = new byte[scheme.particles()];
    values = new float[VALUES * phase.length];
    scheme.forEachParticle(
        (id, of, x, y, z, u, v, w, n, p) -> {
          phase[id] = (byte) of;
          double[] each = {x, y, z, u, v, w, n * phases.get(of).mass(), p};
          for (int value = 0; value < VALUES; value++) {
            values[VALUES * id + value] = (float) each[value];
          }
        });
  }

  void write(OutputFolder folder) throws ImageFileException {
    int count = phase.length;
    VtpWriter.write(
        folder.file("particles.vtp"),
        VtiArray.vector("place", count, (n, c) -> values[VALUES * n + PLACE + c]),
        List.of(
            VtiArray.integers("id", count, (n, c) -> n),
            VtiArray.labels("phase", count, (n, c) -> phase[n]),
            VtiArray.vector("velocity", count, (n, c) -> values[VALUES * n + VELOCITY + c]),
            VtiArray.scalar("density", count, (n, c) -> values[VALUES * n + DENSITY]),
            VtiArray.scalar("pressure", count, (n, c) -> values[VALUES * n + PRESSURE])));
    draw().write(folder.file("particles.png"));
  }

  /** Fluids by speed where there is one, else by phase. */
  private ParticlePicture draw() {
    double lowest = Double.POSITIVE_INFINITY;
    double highest = Double.NEGATIVE_INFINITY;
    double fastest = 0;
    for (int n = 0; n < phase.length; n++) {
      lowest = Math.min(lowest, values[VALUES * n + 2]);
      highest = Math.max(highest, values[VALUES * n + 2]);
      fastest = Math.max(fastest, speed(n));
    }
    // a layer of the lattice that particles begin on, not the gap between two
    double middle = lowest + Math.rint((highest - lowest) / 2 / spacing) * spacing;
    double top = fastest > 0 ? fastest : 1;
    boolean several = phases.stream().filter(each -> !each.solid()).count() > 1;
    ParticlePicture picture = new ParticlePicture(spacing);
    for (int n = 0; n < phase.length; n++) {
      double above = values[VALUES * n + 2] - middle;
      if (-spacing / 2 <= above && above < spacing / 2) { // in 2-D: all
        picture.add(values[VALUES * n], values[VALUES * n + 1], colour(n, several, top));
      }
    }
    return picture;
  }

  private int colour(int n, boolean several, double fastest) {
    if (phases.get(phase[n]).solid()) {
      return ColourMap.SOLID;
    }
    return several ? ColourMap.phase(phase[n]) : ColourMap.viridis(speed(n) / fastest);
  }

  /** Speed of a fluid particle; solids show none, though their walls may move. */
  private double speed(int n) {
    if (phases.get(phase[n]).solid()) {
      return 0;
    }
    double u = values[VALUES * n + VELOCITY];
    double v = values[VALUES * n + VELOCITY + 1];
    double w = values[VALUES * n + VELOCITY + 2];
    return Math.sqrt(u * u + v * v + w * w);
  }
}
