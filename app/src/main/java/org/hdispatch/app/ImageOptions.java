package org.hdispatch.app;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.porous.darcy.Permeability;
import org.hdispatch.porous.image.LabelRule;
import org.hdispatch.porous.image.VoxelBox;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Which image, and how it is to be read. */
final class ImageOptions {
  /** The options that belong to an image and to nothing else. */
  static final List<String> NAMES =
      List.of("--dataset", "--dims", "--box", "--pore-value", "--solid-fraction-range");

  @Parameters(
      arity = "0..1",
      paramLabel = "IMAGE",
      description =
          "Segmented image: HDF5, or raw 8-bit (x fastest, no header; also .gz)."
              + " Default: the bundled sample of Berea sandstone.")
  private Path image;

  @Option(
      names = "--dataset",
      paramLabel = "PATH",
      description =
          "HDF5: path of the dataset, such as /volume. Default: the only image in the file.")
  private String dataset;

  @Option(
      names = "--dims",
      paramLabel = "NX,NY,NZ",
      split = ",",
      hideParamSyntax = true,
      description = "Raw: size of the whole image, voxels. Default: none, raw files need it.")
  private List<Integer> dims;

  @Option(
      names = "--box",
      paramLabel = "X0,Y0,Z0,NX,NY,NZ",
      split = ",",
      hideParamSyntax = true,
      description = "Take only this part: first voxel and size. Default: the whole image.")
  private List<Integer> box;

  @Option(
      names = "--pore-value",
      paramLabel = "LABEL",
      split = ",",
      hideParamSyntax = true,
      defaultValue = "1",
      description = "Labels that are pore, 0 to 255; all others are solid.")
  private List<Integer> poreValue;

  @Option(
      names = "--solid-fraction-range",
      paramLabel = "PORE,SOLID",
      split = ",",
      hideParamSyntax = true,
      description =
          "With --walls imb, for a grey-scale image in place of a segmented one: the grey values, 0 to"
              + " 255, of pure pore and pure solid; between them a voxel is solid in part."
              + " Default: none, the image is segmented, for which imb brings nothing.")
  private List<Integer> solidFractionRange;

  @Option(
      names = "--voxel-edge",
      paramLabel = "M",
      description = "Edge of a voxel, m. Default: as the file says (HDF5 attribute voxel_size_m).")
  private Double voxelEdge;

  Optional<Path> image() {
    return Optional.ofNullable(image);
  }

  Optional<String> dataset() {
    return Optional.ofNullable(dataset);
  }

  /** Size of a raw image, if given. */
  Optional<VoxelBox> dims() {
    return numbers("--dims", dims, 3)
        .map(n -> UsageException.orRefused(() -> VoxelBox.whole(n.get(0), n.get(1), n.get(2))));
  }

  /** Part of the image to take, if given. */
  Optional<VoxelBox> box() {
    return numbers("--box", box, 6)
        .map(
            n ->
                UsageException.orRefused(
                    () ->
                        new VoxelBox(n.get(0), n.get(1), n.get(2), n.get(3), n.get(4), n.get(5))));
  }

  /** Grey values of pore and solid, if given. */
  Optional<List<Integer>> solidFractionRange() {
    return numbers("--solid-fraction-range", solidFractionRange, 2);
  }

  private static Optional<List<Integer>> numbers(String name, List<Integer> given, int count) {
    if (given != null && given.size() != count) {
      throw new UsageException(name + " must be " + count + " integers: " + name + "=" + given);
    }
    return Optional.ofNullable(given);
  }

  LabelRule rule() {
    int[] labels = poreValue.stream().mapToInt(Integer::intValue).toArray();
    return UsageException.orRefused(() -> LabelRule.poreIs(labels));
  }

  /** The given edge, checked, or else the known one. */
  OptionalDouble voxelEdgeOr(OptionalDouble known) {
    OptionalDouble edge = voxelEdge == null ? known : OptionalDouble.of(voxelEdge);
    return UsageException.orRefused(() -> new Permeability(0, edge)).voxelEdge();
  }
}
