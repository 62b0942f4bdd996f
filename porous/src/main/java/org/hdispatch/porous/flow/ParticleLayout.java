package org.hdispatch.porous.flow;

import java.util.Arrays;
import org.hdispatch.cell.Ends;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.sph.ParticleBox;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.VoxelWalls;

/**
 * The particles of a domain: a fluid one at the centre of each fluid node, numbered as the nodes
 * are; then solid ones, as deep as a reach, in the rock and in walls outside the sides.
 */
final class ParticleLayout {
  static final int FLUID = 0;
  static final int SOLID = 1;

  private final Lattice lattice;
  private final int[] margin = new int[3]; // layers of wall outside the sides
  private final int[] nodes; // of the fluid particles
  private final VoxelWalls distance;
  private final ParticleBox box;
  private final double reach;

  /**
   * Lays particles out.
   *
   * @param reach how deep in the solid particles matter, voxels
   */
  ParticleLayout(FlowDomain domain, double reach) {
    this.reach = reach;
    lattice = domain.lattice();
    for (Axis axis : Axis.values()) {
      margin[axis.ordinal()] = margin(domain, axis, reach);
    }
    int nx = lattice.nx() + 2 * margin[0];
    int ny = lattice.ny() + 2 * margin[1];
    int nz = lattice.nz() + 2 * margin[2];
    box = ParticleBox.space(nx, ny, nz, lattice.x(), lattice.y(), lattice.z());
    distance =
        new VoxelWalls(
            nx, ny, nz, 1, lattice.x(), lattice.y(), lattice.z(), (x, y, z) -> !isFluid(x, y, z));
    nodes = fluidNodes();
  }

  private static int margin(FlowDomain domain, Axis axis, double reach) {
    return domain.isWalled(axis.ordinal()) ? (int) Math.ceil(reach) + 1 : 0;
  }

  /** Voxels of the box, layers of wall included: there are not more particles. */
  static double voxels(FlowDomain domain, double reach) {
    Lattice lattice = domain.lattice();
    return (lattice.nx() + 2.0 * margin(domain, Axis.X, reach))
        * (lattice.ny() + 2.0 * margin(domain, Axis.Y, reach))
        * (lattice.nz() + 2.0 * margin(domain, Axis.Z, reach));
  }

  private boolean isFluid(int x, int y, int z) {
    int i = x - margin[0];
    int j = y - margin[1];
    int k = z - margin[2];
    return i >= 0
        && j >= 0
        && k >= 0
        && i < lattice.nx()
        && j < lattice.ny()
        && k < lattice.nz()
        && lattice.nodes().fluid(i, j, k);
  }

  private int[] fluidNodes() {
    int[] found = new int[lattice.nx() * lattice.ny() * lattice.nz()];
    int count = 0;
    int node = 0;
    for (int k = 0; k < lattice.nz(); k++) {
      for (int j = 0; j < lattice.ny(); j++) {
        for (int i = 0; i < lattice.nx(); i++) {
          if (lattice.nodes().fluid(i, j, k)) {
            found[count++] = node;
          }
          node++;
        }
      }
    }
    return Arrays.copyOf(found, count);
  }

  ParticleBox box() {
    return box;
  }

  VoxelWalls distance() {
    return distance;
  }

  /** Node of each fluid particle. */
  int[] nodes() {
    return nodes;
  }

  /** Coordinate of a node along an axis. */
  int coordinate(int node, Axis axis) {
    int nx = lattice.nx();
    return axis.length(node % nx, node / nx % lattice.ny(), node / (nx * lattice.ny()));
  }

  /** The node at a place, which may have left the box through a periodic end by a little. */
  int nodeAt(double x, double y, double z) {
    int i = along(x, 0, lattice.nx(), lattice.x());
    int j = along(y, 1, lattice.ny(), lattice.y());
    int k = along(z, 2, lattice.nz(), lattice.z());
    return i + lattice.nx() * (j + lattice.ny() * k);
  }

  private int along(double place, int axis, int length, Ends ends) {
    int at = (int) Math.floor(place) - margin[axis];
    return ends == Ends.PERIODIC
        ? Math.floorMod(at, length)
        : Math.max(0, Math.min(length - 1, at));
  }

  /**
   * The particles.
   *
   * @param velocity of a node
   */
  Particles particles(NodeVelocity velocity) {
    Particles particles = new Particles();
    for (int node : nodes) {
      int i = coordinate(node, Axis.X);
      int j = coordinate(node, Axis.Y);
      int k = coordinate(node, Axis.Z);
      particles.add(
          FLUID,
          i + margin[0] + 0.5,
          j + margin[1] + 0.5,
          k + margin[2] + 0.5,
          velocity.at(i, j, k, Axis.X),
          velocity.at(i, j, k, Axis.Y),
          velocity.at(i, j, k, Axis.Z));
    }
    for (int z = 0; z < box.lz(); z++) {
      for (int y = 0; y < box.ly(); y++) {
        for (int x = 0; x < box.lx(); x++) {
          double depth = -distance.at(x + 0.5, y + 0.5, z + 0.5);
          if (!isFluid(x, y, z) && depth < reach) {
            particles.add(SOLID, x + 0.5, y + 0.5, z + 0.5);
          }
        }
      }
    }
    return particles;
  }

  /** Velocity at nodes. */
  @FunctionalInterface
  interface NodeVelocity {
    double at(int x, int y, int z, Axis component);
  }
}
