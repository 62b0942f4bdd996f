package org.hdispatch.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.io.Hdf5Dataset;
import org.hdispatch.porous.io.Hdf5Images;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.io.ImageFormat;
import org.hdispatch.porous.io.RawImages;

/** Where an image comes from; its size is known, none of its voxels has been read. */
interface ImageSource {
  /** What it is called in reports and errors. */
  String name();

  /** The whole image. */
  VoxelBox whole();

  /** Edge of a voxel in m, if the source knows it. */
  OptionalDouble voxelEdge();

  /** What is to be said about the source itself: key, value. */
  Map<String, Object> facts() throws ImageFileException;

  /** What to cite, line by line. */
  default List<String> citation() {
    return List.of();
  }

  /**
   * Reads a part.
   *
   * @throws IllegalArgumentException if the box does not lie inside, or is too large for one image
   */
  VoxelImage read(VoxelBox box) throws ImageFileException;

  /**
   * The source that the options name.
   *
   * @throws UsageException if the options contradict each other or the file
   */
  static ImageSource of(ImageOptions options) throws ImageFileException {
    if (options.image().isEmpty()) {
      if (options.dataset().isPresent() || options.dims().isPresent()) {
        throw new UsageException(
            (options.dims().isPresent() ? "--dims" : "--dataset") + " must come with an IMAGE");
      }
      return new SampleRock();
    }
    Path file = options.image().get();
    if (options.dims().isPresent() && options.dataset().isPresent()) {
      throw new UsageException("--dims (raw) and --dataset (HDF5) must not be combined");
    }
    boolean hdf5 = options.dataset().isPresent() || ImageFormat.of(file) == ImageFormat.HDF5;
    if (hdf5) {
      if (options.dims().isPresent()) {
        throw new UsageException("--dims must be left out, as HDF5 knows its size: file=" + file);
      }
      Hdf5Dataset dataset = Hdf5Images.select(file, options.dataset());
      return new Hdf5(dataset, dataset.whole());
    }
    VoxelBox whole =
        options
            .dims()
            .orElseThrow(
                () ->
                    new UsageException(
                        "raw image must come with its size (--dims nx,ny,nz): file="
                            + file
                            + hint(file)));
    RawImages.requireLength(file, whole.nx(), whole.ny(), whole.nz());
    return new Raw(file, whole);
  }

  /** Length of a file in words, and the cube that it may be. */
  private static String hint(Path file) {
    try {
      long length = Files.size(file);
      long edge = Math.round(Math.cbrt(length));
      return ", length="
          + length
          + " bytes"
          + (edge * edge * edge == length
              ? " (a cube would be --dims " + edge + "," + edge + "," + edge + ")"
              : "");
    } catch (IOException e) {
      return ""; // the length is a courtesy
    }
  }

  /** A raw file. */
  record Raw(Path file, VoxelBox whole) implements ImageSource {
    @Override
    public String name() {
      return file.toString();
    }

    @Override
    public OptionalDouble voxelEdge() {
      return OptionalDouble.empty();
    }

    @Override
    public Map<String, Object> facts() throws ImageFileException {
      Map<String, Object> facts = new LinkedHashMap<>();
      facts.put("format", "raw 8 bit");
      facts.put("file_bytes", file.toFile().length());
      facts.put("image_bytes", whole.voxels());
      return facts;
    }

    @Override
    public VoxelImage read(VoxelBox box) throws ImageFileException {
      return RawImages.read(file, whole.nx(), whole.ny(), whole.nz(), box);
    }
  }

  /** A dataset of an HDF5 file. */
  record Hdf5(Hdf5Dataset dataset, VoxelBox whole) implements ImageSource {
    @Override
    public String name() {
      return dataset.file() + ":" + dataset.path();
    }

    @Override
    public OptionalDouble voxelEdge() {
      return dataset.voxelEdge();
    }

    @Override
    public Map<String, Object> facts() throws ImageFileException {
      Map<String, Object> facts = new LinkedHashMap<>();
      facts.put("format", "HDF5");
      facts.put("file_bytes", dataset.file().toFile().length());
      facts.put("dataset", dataset.path());
      facts.put("type", dataset.type());
      facts.put("shape", dataset.shape().toString());
      List<Hdf5Dataset> all = Hdf5Images.describe(dataset.file());
      facts.put("datasets", String.join("; ", all.stream().map(Hdf5Dataset::toString).toList()));
      return facts;
    }

    @Override
    public VoxelImage read(VoxelBox box) throws ImageFileException {
      return Hdf5Images.read(dataset, box);
    }
  }
}
