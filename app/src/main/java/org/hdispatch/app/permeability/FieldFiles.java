package org.hdispatch.app.permeability;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.app.draw.ColourMap;
import org.hdispatch.app.draw.Picture;
import org.hdispatch.app.draw.Plane;
import org.hdispatch.porous.darcy.Permeability;
import org.hdispatch.porous.flow.FlowField;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.io.VtiArray;
import org.hdispatch.porous.io.VtiGrid;
import org.hdispatch.porous.io.VtiWriter;
import org.hdispatch.porous.pore.PoreSpace;

/**
 * The files of a computed flow: {@code flow.vti} with velocity, pressure and solid, and pictures of
 * the speed in the three middle planes.
 *
 * <p>Velocity and pressure are those of the fluid under its pressure gradient along the rock, in
 * m/s and Pa, the pressure relative to the inlet; without a voxel edge they are per unit of
 * (dp/dx)/mu and of dp/dx, in voxel² and voxels. Nothing flows in a rock that does not percolate:
 * its file holds the solid alone.
 */
final class FieldFiles {
  private final Outcome outcome;
  private final PoreSpace space;

  FieldFiles(Outcome outcome) {
    this.outcome = outcome;
    space = outcome.rock().space();
  }

  void write(OutputFolder folder) throws ImageFileException {
    List<VtiArray> arrays = new ArrayList<>();
    if (outcome.flow().field().isPresent()) {
      FlowField field = outcome.flow().field().get();
      arrays.add(velocity(field));
      arrays.add(pressure(field));
    }
    arrays.add(VtiArray.labels("solid", space.voxels(), (v, c) -> space.isPore(v) ? 0 : 1));
    double spacing = outcome.rock().voxelEdge().orElse(1);
    VtiGrid grid = VtiGrid.atOrigin(space.nx(), space.ny(), space.nz(), spacing);
    VtiWriter.write(folder.file("flow.vti"), grid, arrays); // first: the largest, if room is scarce
    if (outcome.flow().field().isPresent()) {
      drawSpeed(folder, outcome.flow().field().get());
    }
  }

  private VtiArray velocity(FlowField field) {
    OptionalDouble edge = outcome.rock().voxelEdge();
    // q = k/mu dp/dx, at every voxel: the permeability of its own velocity.
    double scale = outcome.fluid().superficialVelocity(new Permeability(1, edge)).orElse(1);
    return vector(edge.isPresent() ? "velocity (m/s)" : "velocity (voxel2)", field, scale);
  }

  private VtiArray vector(String name, FlowField field, double scale) {
    float[][] velocity = {field.velocity(Axis.X), field.velocity(Axis.Y), field.velocity(Axis.Z)};
    return VtiArray.vector(name, space.voxels(), (v, c) -> velocity[c][v] * scale);
  }

  private VtiArray pressure(FlowField field) {
    OptionalDouble edge = outcome.rock().voxelEdge();
    double scale = edge.isPresent() ? edge.getAsDouble() * outcome.fluid().pressureGradient() : 1;
    float[] pressure = field.pressure();
    String name = edge.isPresent() ? "pressure (Pa)" : "pressure (voxel)";
    return VtiArray.scalar(name, space.voxels(), (v, c) -> pressure[v] * scale);
  }

  /** Bright is fast; the square root lets slow pores be seen beside fast ones. */
  private void drawSpeed(OutputFolder folder, FlowField field) throws ImageFileException {
    float highest = 0;
    for (Axis normal : Axis.values()) {
      highest = Math.max(highest, highest(plane(normal), field));
    }
    double top = highest > 0 ? highest : 1;
    for (Axis normal : Axis.values()) {
      Picture.write(
          folder.file("speed-" + Choices.word(normal) + ".png"),
          plane(normal),
          voxel ->
              space.isPore(voxel)
                  ? ColourMap.viridis(Math.sqrt(speed(field, voxel) / top))
                  : ColourMap.SOLID);
    }
  }

  private Plane plane(Axis normal) {
    return Plane.middle(normal, space.nx(), space.ny(), space.nz());
  }

  private static float highest(Plane plane, FlowField field) {
    float highest = 0;
    for (int row = 0; row < plane.height(); row++) {
      for (int column = 0; column < plane.width(); column++) {
        highest = Math.max(highest, speed(field, plane.voxel(column, row)));
      }
    }
    return highest;
  }

  private static float speed(FlowField field, int voxel) {
    double x = field.velocity(Axis.X)[voxel];
    double y = field.velocity(Axis.Y)[voxel];
    double z = field.velocity(Axis.Z)[voxel];
    return (float) Math.sqrt(x * x + y * y + z * z);
  }
}
