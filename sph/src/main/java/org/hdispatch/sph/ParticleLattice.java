package org.hdispatch.sph;

import java.util.Objects;
import java.util.Random;

/**
 * A square or simple-cubic lattice of sites that fills a box: where particles begin.
 *
 * @param box the box
 * @param spacing dx, distance of neighbouring sites; sites lie at (i + 1/2) dx
 */
public record ParticleLattice(ParticleBox box, double spacing) {

  /**
   * Checks that the lattice fills the box.
   *
   * @throws IllegalArgumentException if a length of the box is not a multiple of the spacing
   */
  public ParticleLattice {
    Objects.requireNonNull(box, "box");
    Checks.positive("spacing of the lattice", "dx", spacing);
    sites("lx", box.lx(), spacing);
    sites("ly", box.ly(), spacing);
    if (box.dimensions() == 3) {
      sites("lz", box.lz(), spacing);
    }
  }

  private static int sites(String name, double length, double spacing) {
    double sites = length / spacing;
    if (!(Math.rint(sites) >= 1) || Math.abs(sites / Math.rint(sites) - 1) > 1e-9) {
      throw new IllegalArgumentException(
          "length of the box must be a multiple of the spacing of the lattice: "
              + name
              + "="
              + length
              + ", dx="
              + spacing);
    }
    return (int) Math.rint(sites);
  }

  /** Sites along x. */
  public int nx() {
    return sites("lx", box.lx(), spacing);
  }

  /** Sites along y. */
  public int ny() {
    return sites("ly", box.ly(), spacing);
  }

  /** Sites along z; 1 in 2-D. */
  public int nz() {
    return box.dimensions() == 2 ? 1 : sites("lz", box.lz(), spacing);
  }

  /** Share of the sites that lie in a fluid: 1 less the solid fraction that particles see. */
  public double porosity(WallDistance walls) {
    long fluid = 0;
    for (int k = 0; k < nz(); k++) {
      for (int j = 0; j < ny(); j++) {
        for (int i = 0; i < nx(); i++) {
          fluid += walls.at(at(i), at(j), atZ(k)) > 0 ? 1 : 0;
        }
      }
    }
    return (double) fluid / ((long) nx() * ny() * nz());
  }

  /**
   * A particle at rest on each site but those deep in the walls: of phase 0 in the fluid, of phase
   * 1 in the solid.
   *
   * @param walls where the walls are
   * @param deepest depth in the wall beyond which sites stay empty: the support radius will do
   * @param disorder how far from its site a fluid particle may begin, in spacings along each axis,
   *     0 to 1/2; it stays on its site if that would take it into a wall
   * @param seed of the random numbers
   */
  public Particles fill(WallDistance walls, double deepest, double disorder, long seed) {
    if (!(disorder >= 0 && disorder <= 0.5)) {
      throw new IllegalArgumentException(
          "disorder must be 0 to 0.5 spacings of the lattice: disorder=" + disorder);
    }
    Random random = new Random(seed);
    Particles particles = new Particles();
    for (int k = 0; k < nz(); k++) {
      for (int j = 0; j < ny(); j++) {
        for (int i = 0; i < nx(); i++) {
          double distance = walls.at(at(i), at(j), atZ(k));
          if (distance > 0) {
            addFluid(particles, walls, i, j, k, disorder, random);
          } else if (distance > -deepest) {
            particles.add(1, at(i), at(j), atZ(k));
          }
        }
      }
    }
    return particles;
  }

  private void addFluid(
      Particles particles,
      WallDistance walls,
      int i,
      int j,
      int k,
      double disorder,
      Random random) {
    double most = 2 * disorder * spacing;
    double x = at(i) + most * (random.nextDouble() - 0.5);
    double y = at(j) + most * (random.nextDouble() - 0.5);
    double z = box.dimensions() == 2 ? 0 : atZ(k) + most * (random.nextDouble() - 0.5);
    if (walls.at(x, y, z) > 0) {
      particles.add(0, x, y, z);
    } else {
      particles.add(0, at(i), at(j), atZ(k));
    }
  }

  private double at(int site) {
    return (site + 0.5) * spacing;
  }

  private double atZ(int site) {
    return box.dimensions() == 2 ? 0 : at(site);
  }
}
