package org.hdispatch.porous.upscale;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.Objects;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.poisson.ConjugateGradients;
import org.hdispatch.poisson.Convergence;
import org.hdispatch.poisson.LinkMean;
import org.hdispatch.poisson.Mobility;
import org.hdispatch.poisson.PoissonProblem;
import org.hdispatch.poisson.Side;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.survey.Extent;

/**
 * The permeability of a sample from that of its blocks: Darcy's law with the diagonal tensor of
 * each block, div (k grad p) = 0, p given at the two ends of an axis, no flow through the sides and
 * where there is no block.
 *
 * <p>Two-point finite volumes, an unknown a block: between two blocks flows k A/d times the
 * difference of their pressures, k the harmonic mean of both along the axis across their face, A
 * the face, d the way from middle to middle (Aziz, Settari, Petroleum Reservoir Simulation, 1979).
 * In layers and columns that is exact. What flows across a block under a gradient along another
 * axis is left out.
 *
 * <p>Every bit is the same for any number of workers.
 */
public final class Upscaling {
  private static final double TOLERANCE = 1e-12;
  private static final int MOST_ITERATIONS = 2000;

  /** Above this share of what flows, the sections do not agree and k is not one number. */
  private static final double MOST_IMBALANCE = 1e-6;

  private final BlockMap map;
  private final Axis axis;
  private final double[][] conductance = new double[3][]; // of a block end to end, by axis, place

  private Upscaling(BlockMap map, Axis axis) {
    this.map = map;
    this.axis = axis;
    Extent block = map.block();
    double volume = (double) block.nx() * block.ny() * block.nz();
    for (Axis each : Axis.values()) {
      double edge = each.length(block.nx(), block.ny(), block.nz());
      double[] along = new double[map.places()];
      for (int place = 0; place < along.length; place++) {
        along[place] =
            map.permeability(
                    each,
                    coordinate(place, Axis.X),
                    coordinate(place, Axis.Y),
                    coordinate(place, Axis.Z))
                * (volume / (edge * edge));
      }
      conductance[each.ordinal()] = along;
    }
  }

  /**
   * Permeability of the mean cross-section of the blocks along an axis.
   *
   * @param permeability k, voxel²; 0 if no way leads through
   * @param percolates whether a way leads through
   * @param iterations of conjugate gradients
   * @param imbalance how far the flux through a section of blocks is at most from the mean,
   *     relative to it
   * @param converged whether the pressure was found and the sections agree to 1e-6
   */
  public record Result(
      double permeability,
      boolean percolates,
      int iterations,
      double imbalance,
      boolean converged) {}

  /**
   * What the permeability along an axis lies between.
   *
   * @throws IllegalArgumentException if permeabilities are not known along the axis
   */
  public static Bounds bounds(BlockMap map, Axis axis) {
    return Bounds.of(map, axis);
  }

  /**
   * Solves for the pressure and finds the permeability along an axis.
   *
   * @param dispatcher whose workers solve
   * @param map the blocks, with permeabilities along all three axes
   * @throws IllegalArgumentException if they are not known along one of the axes
   * @throws java.util.concurrent.CancellationException if the caller is interrupted
   */
  public static Result along(Dispatcher dispatcher, BlockMap map, Axis axis) {
    Objects.requireNonNull(dispatcher, "dispatcher");
    if (!map.axes().equals(EnumSet.allOf(Axis.class))) {
      throw new IllegalArgumentException(
          "permeabilities must be known along all three axes: known=" + map.axes());
    }
    Upscaling upscaling = new Upscaling(map, axis);
    return upscaling.percolates() ? upscaling.solve(dispatcher) : new Result(0, false, 0, 0, true);
  }

  private int coordinate(int place, Axis along) {
    return along.length(
        place % map.nx(), place / map.nx() % map.ny(), place / (map.nx() * map.ny()));
  }

  private int extent(Axis along) {
    return along.length(map.nx(), map.ny(), map.nz());
  }

  private int stride(Axis along) {
    return along == Axis.X ? 1 : along == Axis.Y ? map.nx() : map.nx() * map.ny();
  }

  /** Whether flow can get from one end to the other. */
  private boolean percolates() {
    double[] along = conductance[axis.ordinal()];
    boolean[] reached = new boolean[map.places()];
    ArrayDeque<Integer> next = new ArrayDeque<>();
    for (int place = 0; place < reached.length; place++) {
      if (coordinate(place, axis) == 0 && along[place] > 0) {
        reached[place] = true;
        next.add(place);
      }
    }
    while (!next.isEmpty()) {
      int place = next.remove();
      if (coordinate(place, axis) == extent(axis) - 1 && along[place] > 0) {
        return true;
      }
      for (Axis each : Axis.values()) {
        for (int step = -1; step <= 1; step += 2) {
          int beside = coordinate(place, each) + step;
          if (beside >= 0 && beside < extent(each)) {
            int other = place + step * stride(each);
            if (!reached[other] && link(each, place, other) > 0) {
              reached[other] = true;
              next.add(other);
            }
          }
        }
      }
    }
    return false;
  }

  /** Conductance between the middles of two neighbours. */
  private double link(Axis across, int one, int other) {
    double k = conductance[across.ordinal()][one];
    double l = conductance[across.ordinal()][other];
    return k == 0 || l == 0 ? 0 : LinkMean.HARMONIC.of(k, l);
  }

  private Result solve(Dispatcher dispatcher) {
    Side first = Side.values()[2 * axis.ordinal()];
    Side last = Side.values()[2 * axis.ordinal() + 1];
    PoissonProblem problem =
        PoissonProblem.box(map.nx(), map.ny(), map.nz())
            .mobility(mobility(Axis.X), mobility(Axis.Y), mobility(Axis.Z))
            .fixed(first, 1)
            .fixed(last, 0)
            .build();
    ConjugateGradients solver = ConjugateGradients.on(dispatcher, problem);
    Convergence end = solver.solve(TOLERANCE, MOST_ITERATIONS);
    double[] pressure = new double[map.places()];
    solver.forEachNode((x, y, z, p) -> pressure[place(x, y, z)] = p);
    double[] flux = fluxes(pressure);
    double mean = Arrays.stream(flux).sum() / flux.length;
    double most = 0;
    for (double each : flux) {
      most = Math.max(most, Math.abs(each - mean));
    }
    double imbalance = most / mean;
    Extent block = map.block();
    double edge = axis.length(block.nx(), block.ny(), block.nz());
    double volume = (double) block.nx() * block.ny() * block.nz() * map.blocks();
    double length = edge * extent(axis);
    return new Result(
        mean * length * length / volume, // q L/dp, q being the flux over the cross-section V/L
        true,
        end.iterations(),
        imbalance,
        imbalance <= MOST_IMBALANCE);
  }

  private int place(int x, int y, int z) {
    return x + map.nx() * (y + map.ny() * z);
  }

  private Mobility mobility(Axis along) {
    double[] values = conductance[along.ordinal()];
    return (x, y, z) -> values[place(x, y, z)];
  }

  /** Flux through each section across the axis, those of the two ends included. */
  private double[] fluxes(double[] pressure) {
    double[] along = conductance[axis.ordinal()];
    int last = extent(axis) - 1;
    double[] flux = new double[last + 2];
    for (int place = 0; place < pressure.length; place++) {
      int at = coordinate(place, axis);
      if (at == 0) {
        flux[0] += 2 * along[place] * (1 - pressure[place]);
      }
      if (at == last) {
        flux[last + 1] += 2 * along[place] * pressure[place];
      } else {
        int other = place + stride(axis);
        flux[at + 1] += link(axis, place, other) * (pressure[place] - pressure[other]);
      }
    }
    return flux;
  }
}
