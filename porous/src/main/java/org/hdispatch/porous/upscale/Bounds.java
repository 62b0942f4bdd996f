package org.hdispatch.porous.upscale;

import org.hdispatch.porous.image.Axis;

/**
 * What the permeability of a sample along an axis lies between, whatever flows across: harmonic
 * &lt;= columns &lt;= k &lt;= layers &lt;= arithmetic. Units: voxel².
 *
 * <p>The inner two are the sharper interval (Cardwell, Parsons, Trans. AIME 160, 1945, 34-42; see
 * Renard, de Marsily, Adv. Water Resour. 20, 1997, 253-278): walls between columns of blocks can
 * only hold the flow back, layers of one pressure can only help it. The outer two are Wiener's.
 *
 * @param harmonic harmonic mean of all blocks; 0 if one has no permeability
 * @param columns harmonic mean of each column of blocks along the axis, then their arithmetic mean
 * @param layers arithmetic mean of each layer of blocks across the axis, then their harmonic mean
 * @param arithmetic arithmetic mean of all blocks
 */
public record Bounds(double harmonic, double columns, double layers, double arithmetic) {

  /**
   * The bounds of a map. Where there is no block there is no permeability; k is that of the mean
   * cross-section of the blocks.
   *
   * @throws IllegalArgumentException if permeabilities are not known along the axis
   */
  static Bounds of(BlockMap map, Axis axis) {
    int length = axis.length(map.nx(), map.ny(), map.nz());
    int columns = map.places() / length;
    double[] resistances = new double[columns];
    double[] sums = new double[length];
    for (int z = 0; z < map.nz(); z++) {
      for (int y = 0; y < map.ny(); y++) {
        for (int x = 0; x < map.nx(); x++) {
          double k = map.permeability(axis, x, y, z);
          resistances[column(map, axis, x, y, z)] += 1 / k; // infinite where k = 0
          sums[axis.length(x, y, z)] += k;
        }
      }
    }
    double resistance = 0;
    double conductance = 0;
    for (double each : resistances) {
      resistance += each;
      conductance += length / each;
    }
    double inSeries = 0;
    double all = 0;
    for (double sum : sums) {
      inSeries += columns / sum;
      all += sum;
    }
    double section = (double) map.places() / map.blocks();
    return new Bounds(
        section * map.places() / resistance,
        section * conductance / columns,
        section * length / inSeries,
        section * all / map.places());
  }

  private static int column(BlockMap map, Axis axis, int x, int y, int z) {
    return switch (axis) {
      case X -> y + map.ny() * z;
      case Y -> x + map.nx() * z;
      case Z -> x + map.nx() * y;
    };
  }
}
