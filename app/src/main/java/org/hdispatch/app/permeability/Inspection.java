package org.hdispatch.app.permeability;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.app.draw.ColourMap;
import org.hdispatch.app.draw.Picture;
import org.hdispatch.app.draw.Plane;
import org.hdispatch.app.rock.ImageSource;
import org.hdispatch.app.text.FlatRow;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.app.text.Table;
import org.hdispatch.cell.Ends;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.LabelRule;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.pore.Percolation;
import org.hdispatch.porous.pore.PoreSpace;

/** What can be said of an image without computing a flow. */
final class Inspection {
  private static final int DIGITS = 5;

  private final ImageSource source;
  private final VoxelBox box;
  private final LabelRule rule;
  private final OptionalDouble voxelEdge;
  private final List<Along> axes = new ArrayList<>();
  private long[] histogram;
  private PoreSpace space;
  private boolean[] connected; // along any axis

  /** What spans one axis. */
  private record Along(
      Axis axis, double connectedPorosity, int spanningClusters, int isolatedPoreVoxels) {
    String word() {
      return Choices.word(axis);
    }
  }

  Inspection(ImageSource source, VoxelBox box, LabelRule rule, OptionalDouble voxelEdge) {
    this.source = source;
    this.box = box;
    this.rule = rule;
    this.voxelEdge = voxelEdge;
  }

  ImageSource source() {
    return source;
  }

  VoxelBox box() {
    return box;
  }

  /** Looks at the voxels. */
  void look(VoxelImage image) {
    histogram = image.histogram();
    space = PoreSpace.of(image, rule);
    connected = new boolean[space.voxels()];
    for (Axis axis : Axis.values()) {
      Percolation percolation = Percolation.along(space, axis, Ends.OPEN, Ends.OPEN);
      axes.add(
          new Along(
              axis,
              percolation.connectedPorosity(),
              percolation.spanningClusters(),
              percolation.isolatedPoreVoxels()));
      for (int voxel = 0; voxel < connected.length; voxel++) {
        connected[voxel] |= percolation.connected().isPore(voxel);
      }
    }
  }

  FlatRow row() throws ImageFileException {
    FlatRow row =
        new FlatRow()
            .put("image", source.name())
            .putAll(source.facts())
            .put("image_nx", source.whole().nx())
            .put("image_ny", source.whole().ny())
            .put("image_nz", source.whole().nz())
            .put("box", box.toString())
            .put("voxels", box.voxels())
            .put("voxel_edge_m", voxelEdge)
            .put("pore_values", rule.toString().replace("pore=", ""));
    for (int label = 0; label < histogram.length; label++) {
      if (histogram[label] > 0) {
        row.put("label_" + label, histogram[label]);
      }
    }
    row.put("porosity", space.porosity());
    for (Along along : axes) {
      row.put("percolates_" + along.word(), along.spanningClusters() > 0)
          .put("porosity_connected_" + along.word(), along.connectedPorosity())
          .put("spanning_clusters_" + along.word(), along.spanningClusters())
          .put("isolated_pore_voxels_" + along.word(), along.isolatedPoreVoxels());
    }
    return row;
  }

  String table() throws ImageFileException {
    Table table = new Table().line("image", source.name());
    source.facts().forEach((key, value) -> table.line(key.replace('_', ' '), value.toString()));
    VoxelBox whole = source.whole();
    table
        .line("size", whole.nx() + " x " + whole.ny() + " x " + whole.nz() + " voxels")
        .line("box", box + " (" + box.voxels() + " voxels)")
        .line(
            "voxel edge",
            voxelEdge.isPresent()
                ? voxelEdge.getAsDouble() + " m"
                : "unknown (permeability needs --voxel-edge)");
    for (int label = 0; label < histogram.length; label++) {
      if (histogram[label] > 0) {
        double share = (double) histogram[label] / box.voxels();
        String phase = Choices.word(rule.phase(label));
        table.line(
            "label " + label,
            histogram[label] + " voxels, " + Numbers.percent(share) + ", " + phase);
      }
    }
    table.line("porosity", Numbers.significant(space.porosity(), DIGITS));
    for (Along along : axes) {
      table.line("along " + along.word(), sentence(along));
    }
    String cite = "cite";
    for (String line : source.citation()) {
      table.line(cite, line);
      cite = "";
    }
    return table.toString();
  }

  private static String sentence(Along along) {
    if (along.spanningClusters() == 0) {
      return "does NOT percolate: k = 0";
    }
    return "percolates, connected porosity "
        + Numbers.significant(along.connectedPorosity(), DIGITS)
        + ", spanning clusters "
        + along.spanningClusters()
        + ", isolated pore voxels "
        + along.isolatedPoreVoxels();
  }

  /** Draws the three middle planes. */
  void draw(OutputFolder folder) throws ImageFileException {
    for (Axis normal : Axis.values()) {
      Picture.write(
          folder.file("slice-" + Choices.word(normal) + ".png"),
          Plane.middle(normal, space.nx(), space.ny(), space.nz()),
          this::colour);
    }
    folder.write("inspect.json", row().toJson());
  }

  private int colour(int voxel) {
    if (!space.isPore(voxel)) {
      return ColourMap.SOLID;
    }
    return connected[voxel] ? ColourMap.PORE : ColourMap.ISOLATED;
  }
}
