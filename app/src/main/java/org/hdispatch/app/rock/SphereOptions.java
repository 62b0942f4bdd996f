package org.hdispatch.app.rock;

import java.util.List;
import java.util.Optional;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.porous.block.Pores;
import org.hdispatch.porous.block.Walls;
import org.hdispatch.porous.flow.SolidFractions;
import org.hdispatch.porous.pore.PoreSpace;
import org.hdispatch.porous.pore.SpherePacking;
import picocli.CommandLine.Option;

/** A regular packing of equal spheres instead of an image. */
public final class SphereOptions {
  /** The options that need {@code --spheres}. */
  public static final List<String> NAMES = List.of("--solid-fraction", "--size");

  @Option(
      names = "--spheres",
      paramLabel = "PACKING",
      completionCandidates = Choices.OfSpheres.class,
      description =
          "Instead of an image: equal spheres, ${COMPLETION-CANDIDATES}, periodic on all sides."
              + " Default: none.")
  private SpherePacking packing;

  @Option(
      names = "--solid-fraction",
      paramLabel = "C",
      defaultValue = "0.343",
      description = "Share of the volume that the spheres take.")
  private double solidFraction;

  @Option(
      names = "--size",
      paramLabel = "N",
      defaultValue = "64",
      description = "Edge of the cubic cell, voxels.")
  private int size;

  /** The packing, if spheres are asked for. */
  public Optional<SpherePacking> packing() {
    return Optional.ofNullable(packing);
  }

  double solidFraction() {
    return solidFraction;
  }

  int size() {
    return size;
  }

  /**
   * The pore space between the spheres.
   *
   * @throws UsageException if there can be no such packing
   */
  PoreSpace poreSpace(Host host) {
    UsageException.orRefused(() -> packing.radius(size, solidFraction));
    double voxels = Math.pow(size, 3);
    host.requireHeap("spheres of " + size + "^3 voxels", voxels * Pores.BYTES_PER_VOXEL);
    return UsageException.orRefused(() -> packing.poreSpace(size, solidFraction));
  }

  /** How much of each voxel the spheres take, exactly, if walls are immersed. */
  Optional<SolidFractions> solid(Walls walls) {
    return walls == Walls.IMB
        ? Optional.of(SolidFractions.of(packing, size, solidFraction))
        : Optional.empty();
  }
}
