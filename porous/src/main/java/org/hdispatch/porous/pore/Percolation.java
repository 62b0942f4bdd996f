package org.hdispatch.porous.pore;

import java.util.Arrays;
import org.hdispatch.cell.Ends;
import org.hdispatch.porous.image.Axis;

/**
 * Whether the pore space spans the box along an axis, and which part of it does.
 *
 * <p>Pore voxels that share a face belong together; those that share only an edge or a corner do
 * not, as no flow passes there. A cluster spans the axis when it touches the first and the last
 * layer; when the axis itself is periodic, when it winds around it: when a path through the cluster
 * leads from a voxel to the same voxel one or more periods further on.
 *
 * @param axis the axis asked about
 * @param connected the voxels of all spanning clusters, in a box of the same size
 * @param spanningClusters number of clusters that span the axis
 * @param isolatedPoreVoxels pore voxels in clusters that do not span
 */
public record Percolation(
    Axis axis, PoreSpace connected, int spanningClusters, int isolatedPoreVoxels) {

  /*
   * How. The unit is not the voxel but the run: a longest line of pore voxels along x, some 10
   * voxels long in sandstone. Runs of neighbouring rows that overlap are joined in a forest
   * (union-find, by size, with path halving): two sweeps over the voxels in file order, and nothing
   * recursive.
   *
   * Where the axis is periodic, each run also keeps its winding relative to its parent: how many
   * periods further on it lies. Joining two runs of one tree whose windings do not fit the step
   * between them closes a loop around the axis, and marks the tree. The winding lives in the runs,
   * so a pore that comes back to its start only after several rounds is found like any other.
   *
   * Memory beside the two pore spaces: 4 ints per run (5 when the axis is periodic) and one int per
   * row. Sandstone of 400^3: about 25 MB; the worst case, every second voxel, 16 to 20 bytes per
   * two voxels.
   */

  /**
   * The percolation of a pore space along an axis.
   *
   * @param space the pore space
   * @param axis the axis
   * @param sides whether the two other axes are periodic
   * @param alongAxis whether the axis itself is periodic
   * @return what spans
   */
  public static Percolation along(PoreSpace space, Axis axis, Ends sides, Ends alongAxis) {
    Runs runs = Runs.of(space);
    RunForest forest = new RunForest(runs.count(), alongAxis == Ends.PERIODIC);
    for (Axis each : Axis.values()) {
      join(space, runs, forest, each, each == axis ? alongAxis : sides, each == axis ? 1 : 0);
    }
    if (alongAxis == Ends.OPEN) {
      markEnds(space, runs, forest, axis);
    }
    byte[] connected = new byte[space.voxels()];
    int clusters = 0;
    int voxels = 0;
    for (int run = 0; run < runs.count(); run++) {
      int root = forest.root(run);
      if (forest.spans(root)) {
        clusters += root == run ? 1 : 0;
        voxels += runs.length(run);
        Arrays.fill(connected, runs.start(run), runs.end(run), PoreSpace.PORE);
      }
    }
    PoreSpace part = new PoreSpace(space.nx(), space.ny(), space.nz(), connected);
    return new Percolation(axis, part, clusters, space.poreVoxels() - voxels);
  }

  /**
   * Whether anything spans.
   *
   * @return true if there is at least one spanning cluster; otherwise k = 0
   */
  public boolean percolates() {
    return spanningClusters > 0;
  }

  /**
   * Connected porosity: voxels of the spanning clusters over all voxels.
   *
   * @return connected porosity, 0..1
   */
  public double connectedPorosity() {
    return connected.porosity();
  }

  /** Joins the runs that touch across the faces along one axis. */
  private static void join(
      PoreSpace space, Runs runs, RunForest forest, Axis along, Ends wrap, int periodStep) {
    int ny = space.ny();
    int nz = space.nz();
    for (int z = 0; z < nz; z++) {
      for (int y = 0; y < ny; y++) {
        int row = y + ny * z;
        switch (along) {
          case X -> {
            // Runs of one row never touch, except around the period.
            if (wrap == Ends.PERIODIC) {
              runs.joinEndToStart(forest, row, periodStep);
            }
          }
          case Y -> {
            if (y + 1 < ny) {
              runs.joinRows(forest, row, row + 1, 0);
            } else if (wrap == Ends.PERIODIC) {
              runs.joinRows(forest, row, ny * z, periodStep);
            }
          }
          case Z -> {
            if (z + 1 < nz) {
              runs.joinRows(forest, row, row + ny, 0);
            } else if (wrap == Ends.PERIODIC) {
              runs.joinRows(forest, row, y, periodStep);
            }
          }
        }
      }
    }
  }

  /** Tells every tree whether it touches the first and the last layer along the axis. */
  private static void markEnds(PoreSpace space, Runs runs, RunForest forest, Axis axis) {
    int nx = space.nx();
    int ny = space.ny();
    for (int row = 0; row < runs.rows(); row++) {
      for (int run = runs.firstOf(row); run < runs.firstOf(row + 1); run++) {
        boolean first;
        boolean last;
        switch (axis) {
          case X -> {
            first = runs.start(run) % nx == 0;
            last = runs.end(run) % nx == 0;
          }
          case Y -> {
            first = row % ny == 0;
            last = row % ny == ny - 1;
          }
          default -> {
            first = row / ny == 0;
            last = row / ny == space.nz() - 1;
          }
        }
        if (first || last) {
          forest.touch(run, first, last);
        }
      }
    }
  }
}
