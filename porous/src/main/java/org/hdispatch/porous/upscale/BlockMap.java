package org.hdispatch.porous.upscale;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.survey.BlockTensor;
import org.hdispatch.porous.survey.Extent;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveyStatus;

/**
 * Blocks of one size side by side, and the permeability of each along one axis or several. Where
 * there is no block, nothing flows.
 *
 * <p>Units: permeabilities in voxel².
 */
public final class BlockMap {
  private static final int MOST_BLOCKS = 1 << 24;

  private final Extent block;
  private final int nx;
  private final int ny;
  private final int nz;
  private final Map<Axis, double[]> permeability; // by place, x fastest; NaN: no block
  private final int blocks;

  /** Permeability of a block along an axis. */
  @FunctionalInterface
  public interface Values {
    /**
     * Permeability of the block at a place, counted in blocks.
     *
     * @return voxel², 0 where it does not percolate; NaN where there is no block, then along each
     *     axis
     */
    double at(Axis axis, int x, int y, int z);
  }

  private BlockMap(Extent block, int nx, int ny, int nz, Map<Axis, double[]> permeability) {
    this.block = block;
    this.nx = nx;
    this.ny = ny;
    this.nz = nz;
    this.permeability = permeability;
    Axis first = permeability.keySet().iterator().next();
    blocks = (int) Arrays.stream(permeability.get(first)).filter(k -> !Double.isNaN(k)).count();
    if (blocks == 0) {
      throw new IllegalArgumentException("map must have a block: places=" + nx * ny * nz);
    }
  }

  /**
   * A map of given permeabilities.
   *
   * @param block size of a block, voxels
   * @param nx blocks along x
   * @param ny blocks along y
   * @param nz blocks along z
   * @param axes axes along which permeabilities are known, at least one
   * @param values the permeabilities
   * @throws IllegalArgumentException if a value is negative or infinite, a block has one along some
   *     of the axes only, there is no block, or there are more than 2^24 places
   */
  public static BlockMap of(Extent block, int nx, int ny, int nz, Set<Axis> axes, Values values) {
    Objects.requireNonNull(block, "block");
    int places = places(nx, ny, nz);
    if (axes.isEmpty()) {
      throw new IllegalArgumentException("axes must be given: axes=" + axes);
    }
    Map<Axis, double[]> permeability = new EnumMap<>(Axis.class);
    for (Axis axis : EnumSet.copyOf(axes)) {
      double[] along = new double[places];
      for (int place = 0; place < places; place++) {
        int x = place % nx;
        int y = place / nx % ny;
        int z = place / (nx * ny);
        along[place] = values.at(axis, x, y, z);
        if (along[place] < 0 || Double.isInfinite(along[place])) {
          throw new IllegalArgumentException(
              "permeability of a block must be finite and not negative: k="
                  + along[place]
                  + " voxel², axis="
                  + axis
                  + ", place="
                  + x
                  + ","
                  + y
                  + ","
                  + z);
        }
      }
      permeability.put(axis, along);
    }
    requireAlongAllAxes(permeability, places);
    return new BlockMap(block, nx, ny, nz, permeability);
  }

  private static int places(long nx, long ny, long nz) {
    long most = MOST_BLOCKS;
    if (nx < 1
        || ny < 1
        || nz < 1
        || nx > most
        || ny > most
        || nx * ny > most
        || nz > most
        || nx * ny * nz > most) {
      throw new IllegalArgumentException(
          "places of blocks must number 1 to "
              + MOST_BLOCKS
              + " (do they lie side by side?): places="
              + nx
              + " x "
              + ny
              + " x "
              + nz);
    }
    return (int) (nx * ny * nz);
  }

  private static void requireAlongAllAxes(Map<Axis, double[]> permeability, int places) {
    for (int place = 0; place < places; place++) {
      int known = 0;
      for (double[] along : permeability.values()) {
        known += Double.isNaN(along[place]) ? 0 : 1;
      }
      if (known > 0 && known < permeability.size()) {
        throw new IllegalArgumentException(
            "block must have a permeability along each of the axes: axes="
                + permeability.keySet()
                + ", place="
                + place);
      }
    }
  }

  /**
   * The map of the rows of a survey. Blocks that do not percolate have k = 0, those that did not
   * converge the k they came to; where blocks lie outside the sample or were left out, there is
   * none.
   *
   * @param rows all rows of the survey
   * @throws IllegalArgumentException if there is no row, blocks differ in size, do not lie side by
   *     side, one failed, or one has no row along an axis that others have
   */
  public static BlockMap of(List<SurveyRow> rows) {
    if (rows.isEmpty()) {
      throw new IllegalArgumentException("survey must have rows: rows=0");
    }
    requireNoneFailed(rows);
    VoxelBox first = rows.get(0).job().box();
    int[] from = {Integer.MAX_VALUE, Integer.MAX_VALUE, Integer.MAX_VALUE};
    int[] to = {0, 0, 0};
    Set<Axis> axes = EnumSet.noneOf(Axis.class);
    for (SurveyRow row : rows) {
      VoxelBox box = row.job().box();
      axes.add(row.job().axis());
      if (box.nx() != first.nx() || box.ny() != first.ny() || box.nz() != first.nz()) {
        throw new IllegalArgumentException(
            "blocks must be of one size: block=" + first + ", other=" + box);
      }
      int[] at = {box.x0(), box.y0(), box.z0()};
      for (int n = 0; n < 3; n++) {
        from[n] = Math.min(from[n], at[n]);
        to[n] = Math.max(to[n], at[n]);
      }
    }
    Extent block = new Extent(first.nx(), first.ny(), first.nz());
    int nx = (to[0] - from[0]) / block.nx() + 1;
    int ny = (to[1] - from[1]) / block.ny() + 1;
    int nz = (to[2] - from[2]) / block.nz() + 1;
    Map<Axis, double[]> known = new EnumMap<>(Axis.class);
    for (Axis axis : axes) {
      known.put(axis, new double[places(nx, ny, nz)]);
      Arrays.fill(known.get(axis), Double.NaN);
    }
    Map<Integer, EnumSet<Axis>> seen = new TreeMap<>();
    for (SurveyRow row : rows) {
      VoxelBox box = row.job().box();
      int x = box.x0() - from[0];
      int y = box.y0() - from[1];
      int z = box.z0() - from[2];
      if (x % block.nx() != 0 || y % block.ny() != 0 || z % block.nz() != 0) {
        throw new IllegalArgumentException(
            "blocks must lie side by side (no --stride, --overlap or other --origin): block="
                + block
                + ", at="
                + box);
      }
      int place = x / block.nx() + nx * (y / block.ny() + ny * (z / block.nz()));
      EnumSet<Axis> along = seen.computeIfAbsent(place, key -> EnumSet.noneOf(Axis.class));
      if (!along.add(row.job().axis())) {
        throw new IllegalArgumentException("blocks must lie side by side, each once: at=" + box);
      }
      if (row.status() != SurveyStatus.OUTSIDE) {
        known.get(row.job().axis())[place] = permeability(row);
      }
    }
    requireAllRows(seen, axes);
    requireAlongAllAxes(known, nx * ny * nz);
    return new BlockMap(block, nx, ny, nz, known);
  }

  private static void requireNoneFailed(List<SurveyRow> rows) {
    List<SurveyRow> failed =
        rows.stream().filter(row -> row.status() == SurveyStatus.FAILED).toList();
    if (!failed.isEmpty()) {
      throw new IllegalArgumentException(
          "every block must have a permeability (the survey tries those that failed again):"
              + " failed="
              + failed.size()
              + ", block="
              + failed.get(0).job().block()
              + ", cause="
              + failed.get(0).cause());
    }
  }

  private static void requireAllRows(Map<Integer, EnumSet<Axis>> seen, Set<Axis> axes) {
    long missing = seen.values().stream().filter(along -> !along.equals(axes)).count();
    if (missing > 0) {
      throw new IllegalArgumentException(
          "every block must have a row along each axis (let the survey go on): axes="
              + axes
              + ", blocks that lack one="
              + missing);
    }
  }

  private static double permeability(SurveyRow row) {
    OptionalDouble k = row.number(BlockTensor.PERMEABILITY);
    if (k.isEmpty() || !(k.getAsDouble() >= 0 && k.getAsDouble() <= Double.MAX_VALUE)) {
      throw new IllegalArgumentException(
          "row must have a permeability that is finite and not negative: job="
              + row.job().number()
              + ", "
              + BlockTensor.PERMEABILITY
              + "="
              + (k.isEmpty() ? "" : k.getAsDouble()));
    }
    return k.getAsDouble();
  }

  /** Size of a block, voxels. */
  public Extent block() {
    return block;
  }

  /** Places of blocks along x. */
  public int nx() {
    return nx;
  }

  /** Places of blocks along y. */
  public int ny() {
    return ny;
  }

  /** Places of blocks along z. */
  public int nz() {
    return nz;
  }

  /** Places of blocks, with one there or not. */
  public int places() {
    return nx * ny * nz;
  }

  /** Number of blocks. */
  public int blocks() {
    return blocks;
  }

  /** The axes along which permeabilities are known. */
  public Set<Axis> axes() {
    return EnumSet.copyOf(permeability.keySet());
  }

  /**
   * Permeability at a place, voxel²; 0 where nothing flows, with a block there or not.
   *
   * @throws IllegalArgumentException if it is not known along this axis
   */
  public double permeability(Axis axis, int x, int y, int z) {
    double k = along(axis)[x + nx * (y + ny * z)];
    return Double.isNaN(k) ? 0 : k;
  }

  private double[] along(Axis axis) {
    double[] along = permeability.get(axis);
    if (along == null) {
      throw new IllegalArgumentException(
          "permeability must be known along the axis: axis="
              + axis
              + ", known="
              + permeability.keySet());
    }
    return along;
  }
}
