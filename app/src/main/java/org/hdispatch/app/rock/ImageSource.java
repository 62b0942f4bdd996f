package org.hdispatch.app.rock;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.io.Hdf5Images;
import org.hdispatch.porous.io.ImageFile;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.io.ImageFormat;
import org.hdispatch.porous.io.MetaImages;
import org.hdispatch.porous.io.NrrdImages;
import org.hdispatch.porous.io.NumpyImages;
import org.hdispatch.porous.io.RawImages;
import org.hdispatch.porous.io.TiffImages;

/** Where an image comes from; its size is known, none of its voxels has been read. */
public interface ImageSource extends ImageFile {
  /** What to cite, line by line. */
  default List<String> citation() {
    return List.of();
  }

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
    ImageFormat format = options.dataset().isPresent() ? ImageFormat.HDF5 : ImageFormat.of(file);
    if (format != ImageFormat.RAW && options.dims().isPresent()) {
      throw new UsageException(
          "--dims must be left out, as " + format + " knows its size: file=" + file);
    }
    return stored(file, options.dataset(), options.dims());
  }

  /**
   * The image in a file.
   *
   * @param dataset its dataset, if it is HDF5 and that must be named
   * @param dims its size, which only raw files need
   * @throws UsageException if it is raw and has no size
   */
  static ImageSource stored(Path file, Optional<String> dataset, Optional<VoxelBox> dims)
      throws ImageFileException {
    ImageFormat format = dataset.isPresent() ? ImageFormat.HDF5 : ImageFormat.of(file);
    return new Stored(
        switch (format) {
          case HDF5 -> Hdf5Images.open(file, dataset);
          case TIFF -> TiffImages.open(file);
          case NUMPY -> NumpyImages.open(file);
          case NRRD -> NrrdImages.open(file);
          case META_IMAGE -> MetaImages.open(file);
          case RAW -> RawImages.open(file, sizeOfRaw(file, dims));
        });
  }

  private static VoxelBox sizeOfRaw(Path file, Optional<VoxelBox> dims) {
    return dims.orElseThrow(
        () ->
            new UsageException(
                "raw image must come with its size (--dims nx,ny,nz): file=" + file + hint(file)));
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

  /** An image in a file. */
  record Stored(ImageFile file) implements ImageSource {
    @Override
    public String name() {
      return file.name();
    }

    @Override
    public VoxelBox whole() {
      return file.whole();
    }

    @Override
    public OptionalDouble voxelEdge() {
      return file.voxelEdge();
    }

    @Override
    public Map<String, Object> facts() throws ImageFileException {
      return file.facts();
    }

    @Override
    public VoxelImage read(VoxelBox box) throws ImageFileException {
      return file.read(box);
    }
  }
}
