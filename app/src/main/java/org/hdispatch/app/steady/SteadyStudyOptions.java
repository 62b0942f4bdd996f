package org.hdispatch.app.steady;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.app.rock.Rock;
import org.hdispatch.porous.block.HeapException;
import org.hdispatch.porous.block.Pores;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.RandomSpheres;
import picocli.CommandLine.Option;

/** Which rocks a study makes, if there is no image, and how far it goes. */
final class SteadyStudyOptions {
  /** The options that make rocks. */
  static final List<String> ROCKS = List.of("--porosity", "--size", "--radius", "--seed");

  @Option(
      names = "--porosity",
      paramLabel = "PHI",
      split = ",",
      hideParamSyntax = true,
      defaultValue = "0.1,0.15,0.2,0.3,0.5",
      description = "Without IMAGE: porosities of the rocks.")
  private List<Double> porosities;

  @Option(
      names = "--size",
      paramLabel = "N",
      description = "Without IMAGE: edge of a rock, voxels.")
  private int size = 64;

  @Option(
      names = "--radius",
      paramLabel = "R",
      description = "Without IMAGE: radius of the spheres, voxels.")
  private double radius = 6;

  @Option(
      names = "--seed",
      paramLabel = "S",
      description = "Without IMAGE: seed of the places of the spheres.")
  private long seed = 2011;

  @Option(
      names = "--axis",
      paramLabel = "AXIS",
      defaultValue = "z",
      completionCandidates = Choices.OfAxis.class,
      description = "Direction of the flow: ${COMPLETION-CANDIDATES}.")
  private Axis axis;

  @Option(
      names = "--tolerance",
      paramLabel = "E",
      description =
          "Tolerance of the stop rule. k is followed until its error is a tenth of it (at most"
              + " 0.01 %%); the steady k is computed to a thousandth.")
  private double tolerance = FlowOptions.DEFAULT.tolerance();

  @Option(
      names = "--max-steps",
      paramLabel = "N",
      description = "Steps after which a run is given up.")
  private long maxSteps = 20_000;

  /**
   * How the flows are computed.
   *
   * @throws UsageException if a number is out of its bounds
   */
  FlowOptions flow() {
    return UsageException.orRefused(
        () -> FlowOptions.DEFAULT.withAxis(axis).withTolerance(tolerance).withMaxSteps(maxSteps));
  }

  /**
   * Rocks of random spheres.
   *
   * @throws UsageException if a number is out of its bounds
   * @throws HeapException if they do not fit
   */
  List<Rock> rocks(Host host) {
    RandomSpheres spheres = UsageException.orRefused(() -> new RandomSpheres(radius, seed));
    host.requireHeap(
        porosities.size() + " rocks of " + size + "^3 voxels",
        porosities.size() * Math.pow(size, 3) * Pores.BYTES_PER_VOXEL);
    List<Rock> rocks = new ArrayList<>();
    for (double porosity : porosities) {
      Map<String, Object> origin = new LinkedHashMap<>();
      origin.put("spheres_porosity", porosity);
      origin.put("spheres_radius_voxel", radius);
      origin.put("spheres_seed", seed);
      rocks.add(
          new Rock(
              "random spheres",
              UsageException.orRefused(() -> spheres.poreSpace(size, porosity)),
              Optional.empty(),
              OptionalDouble.empty(),
              origin,
              List.of()));
    }
    return rocks;
  }
}
