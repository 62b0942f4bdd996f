package org.hdispatch.porous.flow;

import java.util.function.Consumer;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.porous.image.Axis;

/**
 * Velocity and pressure of a steady flow in the rock box, free of any fluid: multiply by what the
 * user's fluid and pressure gradient give.
 *
 * <p>Shape of all arrays: flat, x fastest, one value a voxel, 0 in solid voxels.
 *
 * <ul>
 *   <li>{@code velocity}: u nu / G in voxel², where rho G is the pressure drop over the rock per
 *       length; its mean along the flow over the rock box is the permeability. Physical: u =
 *       velocity edge² (dp/dx)/mu.
 *   <li>{@code pressure}: p / (rho G) in voxels, 0 on average over the first layer of the rock,
 *       about -L at the last one; 0 also in pores that do not span. Physical: p = pressure edge
 *       (dp/dx).
 * </ul>
 */
public final class FlowField {
  private final int nx;
  private final int ny;
  private final int nz;
  private final float[][] velocity;
  private final float[] pressure;

  private FlowField(FlowDomain domain) {
    nx = domain.rock().nx();
    ny = domain.rock().ny();
    nz = domain.rock().nz();
    velocity = new float[3][domain.voxels()];
    pressure = new float[domain.voxels()];
  }

  /**
   * Reads the field from the populations of a scheme.
   *
   * @param force body force g along the flow
   * @param drive pressure drop over the rock per length and density, G
   */
  static FlowField of(FlowDomain domain, LbmScheme flow, double force, double drive) {
    return of(
        domain,
        flow.relaxation().viscosity(),
        force,
        drive,
        visitor -> {
          LbmScheme.NodeVisitor inNodes =
              (x, y, z, density, ux, uy, uz) ->
                  visitor.visit(x, y, z, (density - 1) / 3, ux, uy, uz);
          LbmScheme.Scratch scratch = flow.newScratch();
          for (int n = 0; n < flow.cells().size(); n++) {
            flow.forEachFlux(flow.cells().cellAt(n), scratch, inNodes);
          }
        });
  }

  /** Is shown the nodes of a domain: pressure over density, beside the force's, and velocity. */
  interface Visitor {
    void visit(int x, int y, int z, double pressure, double ux, double uy, double uz);
  }

  /**
   * Reads the field from what shows all fluid nodes.
   *
   * @param viscosity kinematic viscosity
   * @param force body force g along the flow
   * @param drive pressure drop over the rock per length and density, G
   */
  static FlowField of(
      FlowDomain domain, double viscosity, double force, double drive, Consumer<Visitor> flow) {
    FlowField field = new FlowField(domain);
    double scale = viscosity / drive;
    double fall = force / drive;
    int x0 = domain.offset(Axis.X);
    int y0 = domain.offset(Axis.Y);
    int z0 = domain.offset(Axis.Z);
    flow.accept(
        (x, y, z, pressure, ux, uy, uz) -> {
          int along = domain.axis().length(x, y, z) - domain.layers();
          if (along >= 0 && along < domain.length()) {
            int voxel = domain.rock().index(x - x0, y - y0, z - z0);
            field.velocity[0][voxel] = (float) (ux * scale);
            field.velocity[1][voxel] = (float) (uy * scale);
            field.velocity[2][voxel] = (float) (uz * scale);
            // Beside the linear fall for which the force stands.
            field.pressure[voxel] = (float) (pressure / drive - fall * (along + 0.5));
          }
        });
    field.pressureFromInlet(domain);
    return field;
  }

  /** Shifts the pressure so that its mean over the first layer of connected pores is 0. */
  private void pressureFromInlet(FlowDomain domain) {
    double sum = 0;
    int count = 0;
    for (int voxel = 0; voxel < pressure.length; voxel++) {
      if (domain.rock().isPore(voxel) && layer(domain, voxel) == 0) {
        sum += pressure[voxel];
        count++;
      }
    }
    double inlet = sum / count;
    for (int voxel = 0; voxel < pressure.length; voxel++) {
      if (domain.rock().isPore(voxel)) {
        pressure[voxel] -= (float) inlet;
      }
    }
  }

  private int layer(FlowDomain domain, int voxel) {
    return domain.axis().length(voxel % nx, voxel / nx % ny, voxel / (nx * ny));
  }

  /** Voxels along x. */
  public int nx() {
    return nx;
  }

  /** Voxels along y. */
  public int ny() {
    return ny;
  }

  /** Voxels along z. */
  public int nz() {
    return nz;
  }

  /** One component of the velocity. The array itself, not a copy. */
  public float[] velocity(Axis component) {
    return velocity[component.ordinal()];
  }

  /** The pressure. The array itself, not a copy. */
  public float[] pressure() {
    return pressure;
  }
}
