package org.hdispatch.porous.flow;

import org.hdispatch.cell.Ends;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.PoreSpace;

/** How wide the pores of a rock are, which sets the scales of its flow. */
final class PoreWidth {
  /**
   * A surface made of voxel faces is 3/2 times the smooth one for which it stands: the mean of
   * |n_x| + |n_y| + |n_z| over all directions n.
   */
  private static final double STAIRCASE = 1.5;

  private PoreWidth() {}

  /**
   * Hydraulic diameter, 4 volume / surface of the pores, in voxels; 0 if there are no pores. The
   * surface is that of the smooth rock, two thirds of the voxel faces.
   *
   * @param rock the part of the pore space in which fluid flows
   * @throws IllegalArgumentException if there is no wall at all: nothing would hold the flow back
   */
  static double hydraulicDiameter(PoreSpace rock, FlowOptions options) {
    long faces = 0;
    for (Axis axis : Axis.values()) {
      faces += wallFaces(rock, axis, options);
    }
    if (faces == 0 && rock.poreVoxels() > 0) {
      throw new IllegalArgumentException(
          "pore space must have a wall, or no flow is steady: porosity="
              + rock.porosity()
              + ", sides="
              + options.sides());
    }
    return rock.poreVoxels() == 0 ? 0 : 4.0 * rock.poreVoxels() * STAIRCASE / faces;
  }

  /** Faces between pore and wall across an axis. Open ends of the flow and mirrors are no wall. */
  private static long wallFaces(PoreSpace rock, Axis across, FlowOptions options) {
    boolean along = across == options.axis();
    boolean walled = !along && options.sides() == Sides.WALL;
    Ends ends = along ? options.inlet().ends() : options.sides().ends();
    int stride =
        rock.index(across == Axis.X ? 1 : 0, across == Axis.Y ? 1 : 0, across == Axis.Z ? 1 : 0);
    int round = (across.length(rock.nx(), rock.ny(), rock.nz()) - 1) * stride; // to the last voxel
    int block = round + stride; // the voxels whose rows along the axis lie side by side
    long faces = 0;
    for (int from = 0; from < rock.voxels(); from += block) {
      faces += rock.differences(from, from + round, stride);
      if (walled) {
        faces += rock.poreVoxels(from, from + stride);
        faces += rock.poreVoxels(from + round, from + block);
      } else if (ends == Ends.PERIODIC) {
        faces += rock.differences(from, from + stride, round);
      }
    }
    return faces;
  }
}
