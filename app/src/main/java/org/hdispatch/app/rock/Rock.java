package org.hdispatch.app.rock;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.porous.block.Pores;
import org.hdispatch.porous.block.Walls;
import org.hdispatch.porous.flow.SolidFractions;
import org.hdispatch.porous.image.LabelRule;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.pore.PoreSpace;

/**
 * A pore space and where it comes from.
 *
 * @param name what it is called
 * @param space the pore space; of voxels solid in part, those that are less than half
 * @param solid solid fractions, if walls are immersed
 * @param voxelEdge edge of a voxel, m, if known
 * @param origin how it was made: key, value
 * @param citation what to cite, line by line
 */
public record Rock(
    String name,
    PoreSpace space,
    Optional<SolidFractions> solid,
    OptionalDouble voxelEdge,
    Map<String, Object> origin,
    List<String> citation) {
  /** Keeps copies of the lists. */
  public Rock {
    citation = List.copyOf(citation);
  }

  /** What flows take of it. */
  public Pores pores() {
    return new Pores(space, solid);
  }

  /**
   * Reads the part of an image that the options say.
   *
   * @throws UsageException if the box does not fit the image, or no voxel edge is known
   * @throws ImageFileException if the image cannot be read, or has no pore there
   */
  public static Rock of(ImageSource source, ImageOptions options, FlowSettings settings, Host host)
      throws ImageFileException {
    VoxelBox box = boxOf(source, options.box());
    return of(source, box, options, settings.walls(), settings.solidFractionRange(), host);
  }

  /**
   * Reads a part of a segmented image, with bounce-back at the walls.
   *
   * @param box the part, inside of the image
   * @throws UsageException if no voxel edge is known
   * @throws ImageFileException if the image cannot be read, or has no pore there
   */
  public static Rock of(ImageSource source, VoxelBox box, ImageOptions options, Host host)
      throws ImageFileException {
    return of(source, box, options, Walls.BOUNCE_BACK, Optional.empty(), host);
  }

  private static Rock of(
      ImageSource source,
      VoxelBox box,
      ImageOptions options,
      Walls walls,
      Optional<List<Integer>> range,
      Host host)
      throws ImageFileException {
    edgeOf(source, options);
    VoxelImage image = read(source, box, host);
    Rock rock = of(source, box, image, options, walls, range);
    if (rock.space().poreVoxels() == 0) {
      throw new ImageFileException(
          "image must have pore voxels (--pore-value or --solid-fraction-range says which are pore): file="
              + source.name()
              + ", box="
              + box
              + ", "
              + range
                  .map(grey -> "pore_solid=" + grey.get(0) + "," + grey.get(1))
                  .orElse(options.rule().toString())
              + ", labels="
              + labelsOf(image));
    }
    return rock;
  }

  /**
   * The edge of a voxel, m, which is there.
   *
   * @throws UsageException if it is not known
   */
  public static OptionalDouble edgeOf(ImageSource source, ImageOptions options) {
    OptionalDouble edge = options.voxelEdgeOr(source.voxelEdge());
    if (edge.isEmpty()) {
      throw new UsageException(
          "voxel edge must be known, as the file does not say it (give --voxel-edge, in m): file="
              + source.name());
    }
    return edge;
  }

  /**
   * The rock of a part that has been read; it may have no pore.
   *
   * @param box the part
   * @param image its voxels
   * @param range grey values of pore and solid, if the image is not segmented
   * @throws UsageException if no voxel edge is known
   */
  static Rock of(
      ImageSource source,
      VoxelBox box,
      VoxelImage image,
      ImageOptions options,
      Walls walls,
      Optional<List<Integer>> range) {
    LabelRule rule = options.rule();
    OptionalDouble edge = edgeOf(source, options);
    Pores pores =
        UsageException.orRefused(() -> Pores.of(image, rule, walls, range.orElse(List.of())));
    Map<String, Object> origin = new LinkedHashMap<>();
    origin.put("image", source.name());
    origin.put("box", box.toString());
    if (range.isPresent()) {
      origin.put("solid_fraction_range", range.get().get(0) + "," + range.get().get(1));
    } else {
      origin.put("pore_values", rule.toString().replace("pore=", ""));
    }
    return new Rock(source.name(), pores.space(), pores.solid(), edge, origin, source.citation());
  }

  /** Regular spheres. */
  public static Rock of(SphereOptions spheres, ImageOptions options, Walls walls, Host host) {
    OptionalDouble edge = options.voxelEdgeOr(OptionalDouble.empty());
    PoreSpace space = spheres.poreSpace(host);
    String packing = Choices.word(spheres.packing().orElseThrow());
    Map<String, Object> origin = new LinkedHashMap<>();
    origin.put("spheres", packing);
    origin.put("solid_fraction", spheres.solidFraction());
    String name = packing + " spheres, solid fraction " + spheres.solidFraction();
    return new Rock(name, space, spheres.solid(walls), edge, origin, List.of());
  }

  /**
   * The same rock in finer voxels.
   *
   * @param n voxels along an edge of one
   * @throws UsageException if its walls are immersed
   */
  public Rock refined(int n, Host host) {
    if (n == 1) {
      return this;
    }
    Pores fine = UsageException.orRefused(() -> pores().refined(n, host.heap()));
    OptionalDouble edge =
        voxelEdge.isPresent() ? OptionalDouble.of(voxelEdge.getAsDouble() / n) : voxelEdge;
    Map<String, Object> more = new LinkedHashMap<>(origin);
    more.put("refine", n);
    return new Rock(name, fine.space(), fine.solid(), edge, more, citation);
  }

  /** The box to take, checked to lie inside. */
  public static VoxelBox boxOf(ImageSource source, Optional<VoxelBox> given) {
    VoxelBox whole = source.whole();
    VoxelBox box = given.orElse(whole);
    return UsageException.orRefused(
        () -> {
          VoxelImage.requireFits(box.nx(), box.ny(), box.nz());
          return box.within(whole.nx(), whole.ny(), whole.nz());
        });
  }

  /** Reads a box, if it fits into the heap. */
  public static VoxelImage read(ImageSource source, VoxelBox box, Host host)
      throws ImageFileException {
    host.requireHeap(
        "an image of " + box.voxels() + " voxels", (double) Pores.BYTES_PER_VOXEL * box.voxels());
    return source.read(box);
  }

  private static String labelsOf(VoxelImage image) {
    long[] histogram = image.histogram();
    List<String> labels = new ArrayList<>();
    for (int label = 0; label < histogram.length; label++) {
      if (histogram[label] > 0) {
        labels.add(Integer.toString(label));
      }
    }
    return String.join(",", labels);
  }
}
