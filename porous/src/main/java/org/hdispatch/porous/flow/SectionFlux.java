package org.hdispatch.porous.flow;

import java.util.Arrays;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.KeyOrder;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.NodalBundle;
import org.hdispatch.porous.image.Axis;

/**
 * Measures the flux through every cross-section of the rock, and the highest speed, in a pass of
 * its own over the bundles. Each bundle sums its own nodes; the sums are added in key order, so
 * that every bit is the same for any number of workers.
 */
final class SectionFlux {
  private final FlowDomain domain;
  private final LbmScheme flow;
  private final CellMap<Part> parts;
  private final TimeLoop loop;
  private final double[] flux;
  private final double[] density; // mean of the nodes of each section
  private final int[] nodes; // of each section
  private final double[] total = new double[3]; // of all sections, by direction
  private final LbmScheme.NodeVisitor also; // sees what is measured at each node
  private double highestSpeed;

  /**
   * Makes the pass.
   *
   * @param also sees density and flux of each node, called by several workers at the same time
   */
  SectionFlux(
      Dispatcher dispatcher, FlowDomain domain, LbmScheme flow, LbmScheme.NodeVisitor also) {
    this.also = also;
    this.domain = domain;
    this.flow = flow;
    flux = new double[domain.length()];
    density = new double[domain.length()];
    nodes = new int[domain.length()];
    CellMap<NodalBundle> bundles = flow.cells();
    long[] keys = new long[bundles.size()];
    Arrays.setAll(keys, bundles::keyAt);
    parts = CellMap.fixed(keys, KeyOrder.MORTON, key -> new Part(bundles.get(key)));
    loop =
        dispatcher.loop(
            Scheme.of(parts)
                .scratch(flow::newScratch)
                .pass("section flux", (part, scratch, tick) -> part.sum(scratch))
                .build());
  }

  /** Measures now. */
  void measure() {
    loop.run(1);
    Arrays.fill(flux, 0);
    Arrays.fill(density, 0);
    Arrays.fill(nodes, 0);
    Arrays.fill(total, 0);
    double square = 0;
    for (int n = 0; n < parts.size(); n++) {
      parts.cellAt(n).addTo(flux, density, nodes, total);
      square = Math.max(square, parts.cellAt(n).highestSquare);
    }
    for (int section = 0; section < density.length; section++) {
      density[section] /= nodes[section];
    }
    highestSpeed = Math.sqrt(square);
  }

  /** Highest speed at a node, slabs included, voxels per step. */
  double highestSpeed() {
    return highestSpeed;
  }

  /** Mean flux over the rock per cross-section: the superficial velocity, voxels per step. */
  double superficialVelocity() {
    return mean() / domain.crossSection();
  }

  /**
   * Mean velocity over the rock box, solid included, by axis, voxels per step; the array is the
   * caller's. With periodic sides and in a steady flow it is the flux through any section across
   * each axis, as all of them carry the same.
   */
  double[] meanVelocity() {
    double[] mean = new double[total.length];
    Arrays.setAll(mean, component -> total[component] / domain.voxels());
    return mean;
  }

  /** Mean flux through a section, voxels³ per step. */
  double section() {
    return mean();
  }

  private double mean() {
    double sum = 0;
    for (double section : flux) {
      sum += section;
    }
    return sum / flux.length;
  }

  /**
   * How far the flux of a section is at most from the mean, relative to it. In a steady flow all
   * are the same; while pressure still spreads, the flux to come lies between the least and the
   * most of them (each stretch of rock obeys Darcy's law, and the pressure drops add up to the
   * drive).
   */
  double imbalance() {
    double mean = mean();
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    for (double section : flux) {
      least = Math.min(least, section);
      most = Math.max(most, section);
    }
    return Math.max(most - mean, mean - least) / Math.abs(mean);
  }

  /**
   * How far the flux to come is from the mean, relative to it, as far as sections can tell. It is
   * the mean of the fluxes weighted by the pressure drops over the sections, so by the inequality
   * of Cauchy and Schwarz no farther than the relative standard deviation of the fluxes times that
   * of the drops. The latter counts as 1 at least, for pressure also spreads within sections; and
   * more than {@link #imbalance} it cannot be.
   *
   * @param force body force along the flow, to which the pressure drops belong
   */
  double unsettled(double force) {
    double mean = mean();
    double squares = 0;
    for (double section : flux) {
      squares += (section / mean - 1) * (section / mean - 1);
    }
    double spread = Math.sqrt(squares / flux.length) * Math.max(1, spreadOfDrops(force));
    return spread <= imbalance() ? spread : imbalance();
  }

  /** Standard deviation of the pressure drops from section to section over their mean. */
  private double spreadOfDrops(double force) {
    int drops = density.length - 1;
    double mean = force - (density[drops] - density[0]) / 3 / drops;
    double squares = 0;
    for (int n = 0; n < drops; n++) {
      double drop = force - (density[n + 1] - density[n]) / 3;
      squares += (drop / mean - 1) * (drop / mean - 1);
    }
    return Math.sqrt(squares / drops);
  }

  /** The sums of one bundle. */
  private final class Part {
    private final NodalBundle bundle;
    private final int firstSection;
    private final double[] sums;
    private final double[] densities;
    private final int[] counts;
    private double totalX;
    private double totalY;
    private double totalZ;
    private final LbmScheme.NodeVisitor add = this::add; // made once: nothing allocates in a pass
    private double highestSquare;

    Part(NodalBundle bundle) {
      this.bundle = bundle;
      int axis = domain.axis().ordinal();
      firstSection = bundle.first(axis) - domain.layers();
      sums = new double[bundle.extent(axis)];
      densities = new double[sums.length];
      counts = new int[sums.length];
    }

    private int section(int x, int y, int z) {
      return domain.axis().length(x, y, z) - domain.layers();
    }

    void sum(LbmScheme.Scratch scratch) {
      Arrays.fill(sums, 0);
      Arrays.fill(densities, 0);
      Arrays.fill(counts, 0);
      highestSquare = 0;
      totalX = 0;
      totalY = 0;
      totalZ = 0;
      flow.forEachFlux(bundle, scratch, add);
    }

    private void add(int x, int y, int z, double density, double ux, double uy, double uz) {
      also.visit(x, y, z, density, ux, uy, uz);
      Axis axis = domain.axis();
      int section = section(x, y, z);
      int n = section - firstSection;
      sums[n] += axis == Axis.X ? ux : axis == Axis.Y ? uy : uz;
      densities[n] += density;
      counts[n]++;
      if (section >= 0 && section < flux.length) {
        totalX += ux;
        totalY += uy;
        totalZ += uz;
      }
      highestSquare = Math.max(highestSquare, ux * ux + uy * uy + uz * uz);
    }

    void addTo(double[] flux, double[] density, int[] nodes, double[] total) {
      total[0] += totalX;
      total[1] += totalY;
      total[2] += totalZ;
      for (int n = 0; n < sums.length; n++) {
        int section = firstSection + n;
        if (section >= 0 && section < flux.length) {
          flux[section] += sums[n];
          density[section] += densities[n];
          nodes[section] += counts[n];
        }
      }
    }
  }
}
