package org.hdispatch.app.study;

import java.util.function.LongSupplier;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.lbm.BodyForce;
import org.hdispatch.lbm.BundleSize;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.porous.pore.PoreSpace;
import org.hdispatch.porous.pore.RandomSpheres;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SumForm;
import org.hdispatch.sph.cases.PeriodicShear;

/**
 * A workload that can be stepped. Kernels are plain Java: what is compared is JVMs, with as few
 * options as possible.
 *
 * @param scheme to step
 * @param checksum of its state between steps; the same bits, the same sum
 * @param <C> type of a cell
 * @param <S> type of the scratch
 */
record Work<C, S>(Scheme<C, S> scheme, LongSupplier checksum) {
  /** Nodes along an edge of the rock, in 405 bundles of at most 16 x 8 x 8. */
  private static final int ROCK = 72;

  private static final double POROSITY = 0.6;
  private static final double SPHERE_RADIUS = 9;
  private static final double FORCE = 1e-6;

  /** Particles along an edge of the box, in 512 cells. */
  private static final int BOX = 27;

  private static final double SUPPORT = 3;

  /** Of the cells of {@link GatherSweepScheme}, about. */
  private static final double LIVE_BYTES = 64 << 20;

  private static final long HASH = 0x9E3779B97F4A7C15L;

  /**
   * Makes a workload.
   *
   * @param scratchBytes size of a scratch
   * @throws IllegalArgumentException if the scratch of the method takes more by itself
   */
  static Work<?, ?> of(Workload workload, int scratchBytes) {
    return switch (workload) {
      case LBM -> lbm(scratchBytes);
      case SPH -> sph(scratchBytes);
      case BANDWIDTH -> gather(scratchBytes, false);
      case COMPUTE -> gather(scratchBytes, true);
    };
  }

  private static Work<?, ?> lbm(int scratchBytes) {
    PoreSpace rock = new RandomSpheres(SPHERE_RADIUS, 1).poreSpace(ROCK, POROSITY);
    LbmScheme scheme =
        LbmScheme.on(
                new Lattice(
                    ROCK, ROCK, ROCK, Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC, rock::isPore))
            .velocitySet(VelocitySet.D3Q15)
            .bundleSize(new BundleSize(16, 8, 8))
            .force(new BodyForce(FORCE, 0, 0))
            .kernel(KernelForm.SCALAR)
            .build();
    return new Work<>(new PaddedScheme<>(scheme, scratchBytes), () -> checksum(scheme));
  }

  private static Work<?, ?> sph(int scratchBytes) {
    PeriodicShear flow = new PeriodicShear(BOX, SUPPORT);
    SphScheme scheme = flow.settings().form(SumForm.SCALAR).build(flow.particles());
    return new Work<>(new PaddedScheme<>(scheme, scratchBytes), () -> checksum(scheme));
  }

  private static Work<?, ?> gather(int scratchBytes, boolean sweeps) {
    int edge = (int) Math.round(Math.cbrt(LIVE_BYTES / scratchBytes));
    GatherSweepScheme scheme = new GatherSweepScheme(edge, scratchBytes, sweeps);
    return new Work<>(scheme, () -> checksum(scheme.cells()));
  }

  private static long checksum(LbmScheme scheme) {
    long[] sum = new long[1];
    scheme.forEachNode(
        (x, y, z, density, ux, uy, uz) ->
            sum[0] = mixed(mixed(mixed(mixed(sum[0], density), ux), uy), uz));
    return sum[0];
  }

  private static long checksum(SphScheme scheme) {
    long[] sum = new long[1];
    scheme.forEachParticle(
        (id, phase, x, y, z, ux, uy, uz, n, pressure) ->
            sum[0] = mixed(mixed(mixed(mixed(sum[0], x), ux), uy), pressure));
    return sum[0];
  }

  private static long checksum(CellMap<GatherSweepScheme.Cell> cells) {
    long sum = 0;
    for (int n = 0; n < cells.size(); n++) {
      for (int buffer = 0; buffer < 2; buffer++) {
        for (double value : cells.cellAt(n).values(buffer)) {
          sum = mixed(sum, value);
        }
      }
    }
    return sum;
  }

  private static long mixed(long sum, double value) {
    return Long.rotateLeft(sum, 7) * HASH + Double.doubleToLongBits(value);
  }
}
