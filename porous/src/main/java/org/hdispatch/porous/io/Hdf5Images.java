package org.hdispatch.porous.io;

import io.jhdf.HdfFile;
import io.jhdf.api.Dataset;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;

/**
 * Reads images from HDF5 files: a whole dataset, or a box of it as a hyperslab.
 *
 * <p>An image is a dataset of 3 dimensions in the order (z, y, x), of integers of any width and
 * byte order (enumerations such as h5py's booleans included) whose values in the box are all within
 * 0..255. Read are contiguous, compact and chunked layouts, with gzip, shuffle, fletcher32, LZF,
 * LZ4 and uncompressed bitshuffle; parts of a file that were never written read as its fill value.
 * All else is refused: bitshuffle with LZ4 above all, which jHDF 0.13.0 decodes wrongly without an
 * error unless a chunk is a multiple of 8192 bytes.
 *
 * <p>Memory: one byte per voxel of the box, and one chunk; never the whole volume.
 */
public final class Hdf5Images {
  private Hdf5Images() {}

  /**
   * The datasets of a file, in the order the file lists them, groups and links followed.
   *
   * @param file an HDF5 file
   * @return its datasets
   * @throws ImageFileException if the file is missing, not HDF5, or holds what jHDF cannot list
   */
  public static List<Hdf5Dataset> describe(Path file) throws ImageFileException {
    try (HdfFile hdf = Hdf5Access.open(file)) {
      return Hdf5Access.datasets(file, hdf);
    }
  }

  /**
   * The dataset that holds the image: the one that is named, else the only image in the file.
   *
   * @param file an HDF5 file
   * @param dataset path of the dataset, with or without a leading slash; or empty
   * @return the dataset, checked to be an image
   * @throws ImageFileException if the file is missing or not HDF5, if the dataset is missing or not
   *     an image, or if none is named and the file has none or several; the message lists what is
   *     there
   */
  public static Hdf5Dataset select(Path file, Optional<String> dataset) throws ImageFileException {
    try (HdfFile hdf = Hdf5Access.open(file)) {
      Hdf5Dataset chosen = dataset.isPresent() ? named(file, hdf, dataset.get()) : only(file, hdf);
      chosen.whole();
      return chosen;
    }
  }

  /**
   * The image of {@link #select}.
   *
   * @param file an HDF5 file
   * @param dataset path of the dataset, with or without a leading slash; or empty
   * @return the image
   * @throws ImageFileException as {@link #select} does
   */
  public static ImageFile open(Path file, Optional<String> dataset) throws ImageFileException {
    Hdf5Dataset chosen = select(file, dataset);
    return new Hdf5Image(chosen, chosen.whole());
  }

  /**
   * Reads a whole dataset.
   *
   * @param dataset a dataset of {@link #select} or {@link #describe}
   * @return the image, with the voxel edge of the file where it has one
   * @throws ImageFileException if the file is unreadable or wrong, or stored in a way that jHDF
   *     does not read rightly; the message names the remedy
   * @throws IllegalArgumentException if the image is too large for one array: read a box
   */
  public static VoxelImage read(Hdf5Dataset dataset) throws ImageFileException {
    return read(dataset, dataset.whole());
  }

  /**
   * Reads a box of a dataset without loading the rest.
   *
   * @param dataset a dataset of {@link #select} or {@link #describe}
   * @param box the part to read
   * @return the part as an image, with the voxel edge of the file where it has one
   * @throws ImageFileException if the file is unreadable or wrong, or stored in a way that jHDF
   *     does not read rightly; the message names the remedy
   * @throws IllegalArgumentException if the box does not lie inside the image, or is too large for
   *     one array
   */
  public static VoxelImage read(Hdf5Dataset dataset, VoxelBox box) throws ImageFileException {
    VoxelBox whole = dataset.whole();
    box.within(whole.nx(), whole.ny(), whole.nz());
    VoxelImage.requireFits(box.nx(), box.ny(), box.nz());
    try (HdfFile hdf = Hdf5Access.open(dataset.file())) {
      Dataset stored =
          Hdf5Access.find(dataset.file(), hdf, dataset.path())
              .orElseThrow(() -> missing(dataset.file(), dataset.path(), List.of()));
      byte[] labels = Hdf5Slabs.read(dataset, stored, box);
      VoxelImage image = VoxelImage.of(box.nx(), box.ny(), box.nz(), labels);
      return dataset.voxelEdge().isPresent()
          ? image.withVoxelEdge(dataset.voxelEdge().getAsDouble())
          : image;
    }
  }

  private static Hdf5Dataset named(Path file, HdfFile hdf, String path) throws ImageFileException {
    Optional<Dataset> found = Hdf5Access.find(file, hdf, path);
    if (found.isEmpty()) {
      throw missing(file, path, Hdf5Access.datasets(file, hdf));
    }
    return Hdf5Access.describe(file, hdf, path.startsWith("/") ? path : "/" + path, found.get());
  }

  private static Hdf5Dataset only(Path file, HdfFile hdf) throws ImageFileException {
    List<Hdf5Dataset> all = Hdf5Access.datasets(file, hdf);
    List<Hdf5Dataset> images = new ArrayList<>();
    for (Hdf5Dataset dataset : all) {
      if (dataset.isImage()) {
        images.add(dataset);
      }
    }
    if (images.size() == 1) {
      return images.get(0);
    }
    // With a single dataset there is no doubt which one is meant: let it say what is wrong with it.
    if (all.size() == 1) {
      return all.get(0);
    }
    String must =
        images.isEmpty()
            ? "file must hold a dataset of integers with 3 dimensions (z, y, x)"
            : "dataset must be named, as the file holds several images";
    throw new ImageFileException(must + ": file=" + file + ", datasets=" + all);
  }

  private static ImageFileException missing(Path file, String path, List<Hdf5Dataset> there) {
    return new ImageFileException(
        "dataset must exist: file=" + file + ", dataset=" + path + ", datasets=" + there);
  }
}
