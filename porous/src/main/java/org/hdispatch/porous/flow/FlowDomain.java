package org.hdispatch.porous.flow;

import java.util.Optional;
import org.hdispatch.cell.Ends;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.LbmSchemeBuilder;
import org.hdispatch.lbm.immersed.Body;
import org.hdispatch.lbm.immersed.ImmersedBodies;
import org.hdispatch.lbm.immersed.Point;
import org.hdispatch.porous.darcy.Darcy;
import org.hdispatch.porous.darcy.PermeabilityColumn;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.PoreSpace;

/**
 * The lattice on which a rock's flow is solved: the rock box with a slab of fluid at each end,
 * periodic along the flow, or with faces; and the sizes that time scales follow from.
 */
final class FlowDomain {
  private static final int LEAST_LAYERS = 4;
  private static final int MOST_LAYERS = 64;

  private final PoreSpace rock;
  private final Optional<SolidFractions> solid; // of immersed boundaries
  private final Ends sides;
  private final Ends ends;
  private final Axis axis;
  private final int layers;
  private final Sides atSides;
  private final Inlet inlet;
  private final Lattice lattice;
  private final double hydraulicDiameter;

  /**
   * Lays out a lattice.
   *
   * @param rock the part of the pore space in which fluid flows
   * @throws IllegalArgumentException if there is no wall at all: nothing would hold the flow back
   */
  FlowDomain(PoreSpace rock, FlowOptions options) {
    this(rock, Optional.empty(), rock, options);
  }

  /**
   * Lays out a lattice for immersed boundaries: its nodes are all voxels that are not wholly solid,
   * and those beside them.
   *
   * @param rock the part that is not wholly solid and in which fluid flows
   * @throws IllegalArgumentException if there is no wall at all: nothing would hold the flow back
   */
  FlowDomain(PoreSpace rock, SolidFractions solid, FlowOptions options) {
    this(rock, Optional.of(solid), widthOf(rock, solid), options);
  }

  /** The pores as wide as they are: the voxels that are less than half solid, if there are any. */
  private static PoreSpace widthOf(PoreSpace rock, SolidFractions solid) {
    PoreSpace half = solid.below(0.5);
    return half.poreVoxels() > 0 ? half : rock;
  }

  private FlowDomain(
      PoreSpace rock, Optional<SolidFractions> solid, PoreSpace pores, FlowOptions options) {
    this.rock = rock;
    this.solid = solid;
    axis = options.axis();
    hydraulicDiameter = PoreWidth.hydraulicDiameter(pores, options);
    layers = layers(options, hydraulicDiameter);
    atSides = options.sides();
    inlet = options.inlet();
    sides = atSides.ends();
    ends = inlet.ends();
    Ends along = inlet == Inlet.PRESSURE ? Ends.OPEN : Ends.PERIODIC;
    lattice =
        new Lattice(
            rock.nx() + 2 * offset(Axis.X),
            rock.ny() + 2 * offset(Axis.Y),
            rock.nz() + 2 * offset(Axis.Z),
            axis == Axis.X ? along : sides,
            axis == Axis.Y ? along : sides,
            axis == Axis.Z ? along : sides,
            this::fluid);
  }

  /**
   * Layers of fluid at each end: those asked for, or three quarters of the hydraulic diameter. From
   * there on the slabs are a plenum of one pressure, as in a laboratory: wider ones change k by
   * less than 1 %. Narrow ones hold the flow back that spreads in them.
   */
  private static int layers(FlowOptions options, double hydraulicDiameter) {
    if (options.inlet() != Inlet.SLAB) {
      return 0;
    }
    int fitting = (int) Math.ceil(0.75 * hydraulicDiameter);
    return options.inletLayers().orElse(Math.max(LEAST_LAYERS, Math.min(MOST_LAYERS, fitting)));
  }

  /** Layers of fluid before the rock along an axis. */
  int offset(Axis along) {
    return along == axis ? layers : 0;
  }

  private boolean fluid(int x, int y, int z) {
    int inRock = axis.length(x, y, z) - layers;
    return inRock < 0
        || inRock >= length()
        || isNode(x - offset(Axis.X), y - offset(Axis.Y), z - offset(Axis.Z));
  }

  /** Whether a voxel of the rock is a node. */
  private boolean isNode(int x, int y, int z) {
    return solid.isEmpty()
        ? rock.isPore(x, y, z)
        : solid
            .get()
            .matters(
                x,
                y,
                z,
                axis == Axis.X ? ends : sides,
                axis == Axis.Y ? ends : sides,
                axis == Axis.Z ? ends : sides);
  }

  /** Nodes of the rock, without the slabs. */
  long rockNodes() {
    long count = 0;
    for (int z = 0; z < rock.nz(); z++) {
      for (int y = 0; y < rock.ny(); y++) {
        for (int x = 0; x < rock.nx(); x++) {
          count += isNode(x, y, z) ? 1 : 0;
        }
      }
    }
    return count;
  }

  /** Pore volume of the rock in which fluid flows, over that of the rock box. */
  double connectedPorosity() {
    return solid.map(fractions -> fractions.porosity(rock)).orElse(rock.porosity());
  }

  /**
   * The column of the permeability tensor that goes with a flow.
   *
   * @param permeability along the flow, voxel²
   * @param mean velocity over the rock box, by axis, any unit
   * @return empty if the sides are not periodic
   */
  Optional<PermeabilityColumn> column(double permeability, double[] mean) {
    if (atSides != Sides.PERIODIC) {
      return Optional.empty();
    }
    double scale = permeability / mean[axis.ordinal()];
    return Optional.of(
        new PermeabilityColumn(
            axis == Axis.X ? permeability : scale * mean[0],
            axis == Axis.Y ? permeability : scale * mean[1],
            axis == Axis.Z ? permeability : scale * mean[2]));
  }

  /** Whether a wall stands at the ends of an axis. */
  boolean isWalled(int across) {
    return across != axis.ordinal() && atSides == Sides.WALL;
  }

  /** Whether a plenum of one pressure lies at the ends of an axis. */
  boolean isPressed(int along) {
    return along == axis.ordinal() && inlet == Inlet.PRESSURE;
  }

  /** Puts faces where the ends or sides are neither walls nor periodic. */
  void bound(LbmSchemeBuilder scheme) {
    if (inlet == Inlet.PRESSURE) {
      scheme.pressureFaces(axis.ordinal(), 1, 1);
    }
    for (Axis across : Axis.values()) {
      if (across != axis && atSides == Sides.MIRROR) {
        scheme.symmetryFaces(across.ordinal());
      }
    }
  }

  /** Whether boundaries are immersed. */
  boolean immersed() {
    return solid.isPresent();
  }

  /** The solid as a body in the lattice, if boundaries are immersed. */
  Optional<ImmersedBodies> bodies() {
    return solid.map(
        fractions ->
            ImmersedBodies.of(
                Body.fixed(
                    fractions.coverage(),
                    new Point(
                        (rock.nx() - 1) / 2.0 + offset(Axis.X),
                        (rock.ny() - 1) / 2.0 + offset(Axis.Y),
                        (rock.nz() - 1) / 2.0 + offset(Axis.Z)))));
  }

  Lattice lattice() {
    return lattice;
  }

  PoreSpace rock() {
    return rock;
  }

  Axis axis() {
    return axis;
  }

  int layers() {
    return layers;
  }

  /** Length of the rock along the flow, voxels. */
  int length() {
    return axis.length(rock.nx(), rock.ny(), rock.nz());
  }

  /** Voxels of the rock box. */
  int voxels() {
    return rock.voxels();
  }

  /**
   * The fluid node beside a node, x fastest, or -1 if there is a wall.
   *
   * @param step 1 or -1
   */
  int neighbour(int node, Axis along, int step) {
    int nx = lattice.nx();
    int x = node % nx + (along == Axis.X ? step : 0);
    int y = node / nx % lattice.ny() + (along == Axis.Y ? step : 0);
    int z = node / (nx * lattice.ny()) + (along == Axis.Z ? step : 0);
    int i = lattice.x().wrap(x, nx);
    int j = lattice.y().wrap(y, lattice.ny());
    int k = lattice.z().wrap(z, lattice.nz());
    return i < 0 || j < 0 || k < 0 || !lattice.nodes().fluid(i, j, k)
        ? -1
        : i + nx * (j + lattice.ny() * k);
  }

  /** Voxels of one slab. */
  long slabVoxels() {
    return (long) layers * crossSection();
  }

  /** Cross-section of the rock box, voxels². */
  int crossSection() {
    return voxels() / length();
  }

  /** Permeability of the empty cross-section between the side walls, voxel². */
  double slabPermeability() {
    if (atSides == Sides.WALL) {
      return switch (axis) {
        case X -> Darcy.ductPermeability(rock.ny(), rock.nz());
        case Y -> Darcy.ductPermeability(rock.nx(), rock.nz());
        case Z -> Darcy.ductPermeability(rock.nx(), rock.ny());
      };
    }
    return Double.POSITIVE_INFINITY;
  }

  /** See {@link PoreWidth#hydraulicDiameter}. */
  double hydraulicDiameter() {
    return hydraulicDiameter;
  }

  /**
   * A first guess of the permeability, voxel²: Kozeny-Carman with the hydraulic radius r = d/4, k =
   * phi r² / 5 (Carman 1937). It serves to choose numbers, never a result.
   */
  double guessedPermeability() {
    double radius = hydraulicDiameter / 4;
    return rock.porosity() * radius * radius / 5;
  }
}
