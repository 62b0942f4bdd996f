package org.hdispatch.app.rock;

import java.util.List;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.porous.block.Method;
import org.hdispatch.porous.flow.SphOptions;
import picocli.CommandLine.Option;

/** Which method computes the flow, and what belongs to particles alone. */
public final class MethodOptions {
  /** Estimated relative error of k at which particles stop, if none is given. */
  static final double SPH_TOLERANCE = 1e-2;

  /** What belongs to the lattice Boltzmann method alone. */
  static final List<String> LBM_NAMES =
      List.of("--lattice", "--storage", "--collision", "--tau", "--walls", "--approach");

  /** What belongs to particles alone. */
  static final List<String> SPH_NAMES = List.of("--smoothing-length", "--wall-factor");

  @Option(
      names = "--method",
      paramLabel = "METHOD",
      defaultValue = "lbm",
      completionCandidates = Choices.OfMethod.class,
      description =
          "${COMPLETION-CANDIDATES}: the lattice Boltzmann method, one node a voxel, or smoothed"
              + " particle hydrodynamics, one particle a voxel (with a --tolerance of 1e-2).")
  private Method method;

  @Option(
      names = "--smoothing-length",
      paramLabel = "H",
      description = "Smoothing length of particles, voxels: 1 to 2 (quintic spline).")
  private double smoothingLength = SphOptions.DEFAULT.smoothingLength();

  @Option(
      names = "--wall-factor",
      paramLabel = "BETA",
      description =
          "At most so many times its own velocity does a particle differ from the wall's (beta_max"
              + " of Morris et al. 1997).")
  private double wallFactor = SphOptions.DEFAULT.wallFactor();

  @Option(
      names = "--refine",
      paramLabel = "N",
      description =
          "Cut each voxel into N x N x N of the same kind: finer nodes or particles, the same"
              + " rock.")
  private int refine = 1;

  Method method() {
    return method;
  }

  /**
   * How many voxels an edge of one is cut into.
   *
   * @throws UsageException if it is not 1 to 16
   */
  public int refine() {
    if (refine < 1 || refine > 16) {
      throw new UsageException("--refine must be 1 to 16: N=" + refine);
    }
    return refine;
  }

  /**
   * The settings of particles.
   *
   * @throws UsageException if one is out of its bounds
   */
  SphOptions particles() {
    return UsageException.orRefused(() -> new SphOptions(smoothingLength, wallFactor));
  }
}
