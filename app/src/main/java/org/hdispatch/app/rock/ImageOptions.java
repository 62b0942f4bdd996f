package org.hdispatch.app.rock;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.porous.darcy.Permeability;
import org.hdispatch.porous.image.LabelRule;
import org.hdispatch.porous.image.VoxelBox;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Which image, and how it is to be read. */
public final class ImageOptions {
  /** The options that belong to an image and to nothing else. */
  public static final List<String> NAMES = List.of("--dataset", "--dims", "--box", "--pore-value");

  /** Six integers, small enough for any image. */
  private static final Pattern BOX = Pattern.compile("(\\s*-?\\d{1,9}\\s*,){5}\\s*-?\\d{1,9}\\s*");

  @Parameters(
      arity = "0..1",
      paramLabel = "IMAGE",
      description =
          "Segmented image, labels 0 to 255: HDF5, TIFF (a file of pages, or a folder of slices),"
              + " NumPy .npy (z, y, x), NRRD, MetaImage .mhd or .mha, or raw 8-bit (x fastest, no"
              + " header; also .gz). Default: none, see above.")
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
      hideParamSyntax = true,
      description = "Take only this part: first voxel and size. Default: the whole image.")
  private List<String> boxes; // as they were given; null: none

  @Option(
      names = "--pore-value",
      paramLabel = "LABEL",
      split = ",",
      hideParamSyntax = true,
      defaultValue = "1",
      description = "Labels that are pore, 0 to 255; all others are solid.")
  private List<Integer> poreValue;

  @Option(
      names = "--voxel-edge",
      paramLabel = "M",
      description =
          "Edge of a voxel, m. Default: as the file says (HDF5: attribute voxel_size_m; NRRD: where"
              + " a unit is stated; MetaImage: mm unless stated; TIFF, NumPy and raw do not say it).")
  private Double voxelEdge;

  /** The file, if one is given. */
  public Optional<Path> image() {
    return Optional.ofNullable(image);
  }

  Optional<String> dataset() {
    return Optional.ofNullable(dataset);
  }

  /** Size of a raw image, if given. */
  Optional<VoxelBox> dims() {
    if (dims != null && dims.size() != 3) {
      throw new UsageException("--dims must be 3 integers: --dims=" + dims);
    }
    return Optional.ofNullable(dims)
        .map(n -> UsageException.orRefused(() -> VoxelBox.whole(n.get(0), n.get(1), n.get(2))));
  }

  /**
   * Part of the image to take, if given.
   *
   * @throws UsageException if there are several
   */
  public Optional<VoxelBox> box() {
    List<VoxelBox> all = boxes();
    if (all.size() > 1) {
      throw new UsageException("--box must come once: --box=" + String.join(" ", boxes));
    }
    return all.stream().findFirst();
  }

  /** Parts of the image to take; none if none is given. */
  public List<VoxelBox> boxes() {
    return boxes == null ? List.of() : boxes.stream().map(ImageOptions::parsed).toList();
  }

  private static VoxelBox parsed(String box) {
    if (!BOX.matcher(box).matches()) {
      throw new UsageException("--box must be 6 integers: --box=" + box);
    }
    int[] n = Arrays.stream(box.split(",")).map(String::trim).mapToInt(Integer::parseInt).toArray();
    return UsageException.orRefused(() -> new VoxelBox(n[0], n[1], n[2], n[3], n[4], n[5]));
  }

  /** Which labels are pore. */
  public LabelRule rule() {
    int[] labels = poreValue.stream().mapToInt(Integer::intValue).toArray();
    return UsageException.orRefused(() -> LabelRule.poreIs(labels));
  }

  /** The given edge, checked, or else the known one. */
  public OptionalDouble voxelEdgeOr(OptionalDouble known) {
    OptionalDouble edge = voxelEdge == null ? known : OptionalDouble.of(voxelEdge);
    return UsageException.orRefused(() -> new Permeability(0, edge)).voxelEdge();
  }
}
