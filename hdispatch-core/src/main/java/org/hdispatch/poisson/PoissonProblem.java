package org.hdispatch.poisson;

import java.util.EnumMap;
import java.util.Map;
import java.util.Objects;
import org.hdispatch.cell.Ends;

/**
 * Flow between the active nodes of a box of nx x ny x nz nodes, one spacing apart: at every active
 * node m
 *
 * <pre>  sum over its neighbours n of  k_mn (p_m - p_n)  =  b_m </pre>
 *
 * <p>with the six neighbours across the faces of the node's unit cell. No flow crosses a face to a
 * node that is not active, nor an open end of the box. At a {@linkplain Builder#fixed fixed side}
 * the value of p is given on the outer face of the last nodes, half a spacing away from them: the
 * link has mobility 2 K_m (twice the node's, for half the way). With {@linkplain Builder#fixedWalls
 * fixed walls} so it is at the faces to nodes that are not active. Mobilities may differ
 * {@linkplain Builder#mobility(Mobility, Mobility, Mobility) from axis to axis}.
 *
 * <p>Units: any; those of b are those of mobility times p.
 */
public final class PoissonProblem {
  private final int nx;
  private final int ny;
  private final int nz;
  private final Ends[] ends;
  private final Mobility[] mobility; // one for all axes, or one for each
  private final LinkMean mean;
  private final Map<Side, Double> fixed;
  private final double walls; // NaN: closed to flow

  private PoissonProblem(Builder builder) {
    nx = builder.nx;
    ny = builder.ny;
    nz = builder.nz;
    ends = builder.ends.clone();
    mobility = builder.mobility.clone();
    mean = builder.mean;
    fixed = new EnumMap<>(builder.fixed);
    walls = builder.walls;
  }

  /**
   * Starts with a box whose nodes all have mobility 1 and whose ends are open (closed to flow).
   *
   * @throws IllegalArgumentException if an extent is not in 1 to 2^20
   */
  public static Builder box(int nx, int ny, int nz) {
    return new Builder(nx, ny, nz);
  }

  int extent(int axis) {
    return axis == 0 ? nx : axis == 1 ? ny : nz;
  }

  Ends ends(int axis) {
    return ends[axis];
  }

  /** Mobilities of a node: 1, or 3 if each axis has its own. */
  int mobilities() {
    return mobility.length;
  }

  /**
   * A mobility of a node; all of them are 0 if it is not active.
   *
   * @param which 0 to {@link #mobilities()} - 1
   * @throws IllegalArgumentException if it is negative, infinite or not a number
   */
  double mobility(int which, int x, int y, int z) {
    double value = mobility[which].at(x, y, z);
    if (!(value >= 0 && value <= Double.MAX_VALUE)) {
      throw Refusal.value("mobility must be finite and not negative", "mobility", value, x, y, z);
    }
    return value;
  }

  /**
   * Mobility of the link of two nodes; 0 if one of them has none along it.
   *
   * @throws IllegalArgumentException if it is negative, infinite or not a number
   */
  double link(double one, double other) {
    if (one == 0 || other == 0) {
      return 0;
    }
    double value = mean.of(one, other);
    if (!(value >= 0 && value <= Double.MAX_VALUE)) {
      throw Refusal.link(value, one, other);
    }
    return value;
  }

  boolean isFixed(Side side) {
    return fixed.containsKey(side);
  }

  /** Value on a fixed side. */
  double value(Side side) {
    return fixed.get(side);
  }

  boolean hasFixedWalls() {
    return !Double.isNaN(walls);
  }

  /** Value on the faces to nodes that are not active. */
  double wallValue() {
    return walls;
  }

  /** Settings of a problem. */
  public static final class Builder {
    private final int nx;
    private final int ny;
    private final int nz;
    private final Ends[] ends = {Ends.OPEN, Ends.OPEN, Ends.OPEN};
    private final Map<Side, Double> fixed = new EnumMap<>(Side.class);
    private Mobility[] mobility = {(x, y, z) -> 1};
    private LinkMean mean = LinkMean.HARMONIC;
    private double walls = Double.NaN;

    private Builder(int nx, int ny, int nz) {
      this.nx = extent(nx, "nx");
      this.ny = extent(ny, "ny");
      this.nz = extent(nz, "nz");
    }

    private static int extent(int nodes, String name) {
      if (nodes < 1 || nodes > 1 << 20) {
        throw new IllegalArgumentException(
            "nodes along an axis must number 1 to 1048576: " + name + "=" + nodes);
      }
      return nodes;
    }

    /** Sets what lies beyond the ends of each axis; {@code OPEN} is closed to flow. */
    public Builder ends(Ends x, Ends y, Ends z) {
      ends[0] = Objects.requireNonNull(x, "x");
      ends[1] = Objects.requireNonNull(y, "y");
      ends[2] = Objects.requireNonNull(z, "z");
      return this;
    }

    /** Sets the mobility of the nodes, and with it which are active. Asked when cells are made. */
    public Builder mobility(Mobility ofNodes) {
      mobility = new Mobility[] {Objects.requireNonNull(ofNodes, "mobility")};
      return this;
    }

    /**
     * Sets the mobility of the nodes along each axis, as of a diagonal tensor: the links across x
     * faces follow from those along x, and so on. A node is active if one of its mobilities is
     * positive; where two nodes meet along an axis and one has none there, nothing flows. Asked
     * when cells are made and, at fixed sides, when a force is added.
     */
    public Builder mobility(Mobility alongX, Mobility alongY, Mobility alongZ) {
      mobility =
          new Mobility[] {
            Objects.requireNonNull(alongX, "alongX"),
            Objects.requireNonNull(alongY, "alongY"),
            Objects.requireNonNull(alongZ, "alongZ")
          };
      return this;
    }

    /** Sets how the mobility of a link follows from its nodes'. Default: the harmonic mean. */
    public Builder linkMean(LinkMean ofLinks) {
      mean = Objects.requireNonNull(ofLinks, "mean");
      return this;
    }

    /**
     * Fixes p on a side of the box, half a spacing outside the last nodes.
     *
     * @throws IllegalArgumentException if the value is infinite or not a number
     */
    public Builder fixed(Side side, double value) {
      if (!Double.isFinite(value)) {
        throw new IllegalArgumentException(
            "value on a side must be finite: side=" + side + ", value=" + value);
      }
      fixed.put(side, value);
      return this;
    }

    /**
     * Fixes p on all faces between an active node and one that is not, half a spacing outside the
     * active one, as a laminar profile is 0 on the walls of its duct. The ends of the box are not
     * among them: see {@link #fixed}.
     *
     * @throws IllegalArgumentException if the value is infinite or not a number
     */
    public Builder fixedWalls(double value) {
      if (!Double.isFinite(value)) {
        throw new IllegalArgumentException("value on walls must be finite: value=" + value);
      }
      walls = value;
      return this;
    }

    /**
     * The problem.
     *
     * @throws IllegalArgumentException if a fixed side lies across a periodic axis
     */
    public PoissonProblem build() {
      for (Side side : fixed.keySet()) {
        if (ends[side.axis()] == Ends.PERIODIC) {
          throw new IllegalArgumentException(
              "axis of a fixed side must have open ends: side=" + side);
        }
      }
      return new PoissonProblem(this);
    }
  }
}
