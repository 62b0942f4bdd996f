package org.hdispatch.porous.io;

import io.jhdf.HdfFile;
import io.jhdf.api.Attribute;
import io.jhdf.api.Dataset;
import io.jhdf.api.Group;
import io.jhdf.api.Link;
import io.jhdf.api.Node;
import io.jhdf.exceptions.HdfBrokenLinkException;
import io.jhdf.exceptions.HdfException;
import io.jhdf.exceptions.HdfInvalidPathException;
import io.jhdf.object.datatype.DataType;
import io.jhdf.object.datatype.EnumDataType;
import io.jhdf.object.datatype.FixedPoint;
import io.jhdf.object.datatype.FloatingPoint;
import java.lang.reflect.Array;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;

/**
 * Opens HDF5 files and finds datasets in them, with jHDF's refusals put into one line.
 *
 * <p>jHDF throws whatever a damaged file makes its parser run into (buffer underflows, negative
 * array sizes), not only {@link HdfException}; hence {@link RuntimeException} is what is caught at
 * each call into it, and nothing of our own runs inside those calls.
 */
final class Hdf5Access {
  private static final String VOXEL_EDGE = "voxel_size_m";
  private static final String AXIS_ORDER = "axis_order";

  private Hdf5Access() {}

  static HdfFile open(Path file) throws ImageFileException {
    ImageFiles.requireReadable(file);
    try {
      // Absolute, as jHDF resolves external links against the parent of the path it was given.
      return new HdfFile(file.toAbsolutePath());
    } catch (RuntimeException e) {
      throw refusal(file, "", e);
    }
  }

  /** All datasets below the root, groups and links followed, none twice. */
  static List<Hdf5Dataset> datasets(Path file, HdfFile hdf) throws ImageFileException {
    List<Hdf5Dataset> found = new ArrayList<>();
    collect(file, hdf, hdf, "/", new HashSet<>(), found);
    return found;
  }

  private static void collect(
      Path file, HdfFile hdf, Group group, String path, Set<String> seen, List<Hdf5Dataset> found)
      throws ImageFileException {
    List<Node> children;
    try {
      if (!seen.add(identity(group))) {
        return; // a link back up
      }
      children = new ArrayList<>(group.getChildren().values());
    } catch (RuntimeException e) {
      throw refusal(file, "", e);
    }
    for (Node child : children) {
      Node node;
      try {
        node = child instanceof Link link ? link.getTarget() : child;
      } catch (HdfBrokenLinkException e) {
        continue; // it hides nothing else; whoever names it is told
      }
      String childPath = path + child.getName();
      if (node instanceof Dataset dataset) {
        found.add(describe(file, hdf, childPath, dataset));
      } else if (node instanceof Group inner) {
        collect(file, hdf, inner, childPath + "/", seen, found);
      }
    }
  }

  private static String identity(Node node) {
    return node.getHdfFile().getFileAsPath() + ":" + node.getAddress();
  }

  /** The dataset of a path, or empty when there is none. */
  static Optional<Dataset> find(Path file, HdfFile hdf, String path) throws ImageFileException {
    try {
      Node node = hdf.getByPath(path);
      return node instanceof Dataset dataset ? Optional.of(dataset) : Optional.empty();
    } catch (HdfInvalidPathException e) {
      return Optional.empty();
    } catch (RuntimeException e) {
      throw refusal(file, path, e);
    }
  }

  static Hdf5Dataset describe(Path file, HdfFile hdf, String path, Dataset dataset)
      throws ImageFileException {
    List<Long> shape = new ArrayList<>();
    String type;
    boolean integer;
    String axisOrder;
    Object edge;
    try {
      for (long length : dataset.getDimensionsAsLong()) {
        shape.add(length);
      }
      Optional<LabelType> label = labelType(dataset.getDataType());
      integer = label.isPresent();
      type = integer ? label.get().toString() : typeName(dataset.getDataType());
      axisOrder = attribute(dataset, AXIS_ORDER) instanceof String text ? text : "z,y,x";
      edge = attribute(dataset, VOXEL_EDGE);
      if (edge == null) {
        edge = attribute(hdf, VOXEL_EDGE);
      }
    } catch (RuntimeException e) {
      throw refusal(file, path, e);
    }
    if (shape.size() == 3 && !axisOrder.toLowerCase(Locale.ROOT).matches("\\W*z\\W*y\\W*x\\W*")) {
      throw new ImageFileException(
          "axis order of the dataset must be (z, y, x) (transpose it): file="
              + file
              + ", dataset="
              + path
              + ", "
              + AXIS_ORDER
              + "="
              + axisOrder);
    }
    return new Hdf5Dataset(file, path, shape, type, integer, voxelEdge(file, path, edge));
  }

  private static Object attribute(Node node, String name) {
    Attribute attribute = node.getAttribute(name);
    return attribute == null ? null : attribute.getData();
  }

  private static OptionalDouble voxelEdge(Path file, String path, Object value)
      throws ImageFileException {
    if (value == null) {
      return OptionalDouble.empty();
    }
    List<Object> values = new ArrayList<>();
    if (value.getClass().isArray()) {
      for (int i = 0; i < Array.getLength(value); i++) {
        values.add(Array.get(value, i));
      }
    } else {
      values.add(value);
    }
    double edge = Double.NaN;
    for (Object each : values) {
      double metres = each instanceof Number number ? number.doubleValue() : Double.NaN;
      edge = each == values.get(0) || metres == edge ? metres : Double.NaN;
    }
    if (!(edge > 0) || edge == Double.POSITIVE_INFINITY) {
      throw new ImageFileException(
          "attribute "
              + VOXEL_EDGE
              + " must be one positive number, the same along all axes (correct or remove it): file="
              + file
              + ", dataset="
              + path
              + ", "
              + VOXEL_EDGE
              + "="
              + values
              + " m");
    }
    return OptionalDouble.of(edge);
  }

  /** How a label is stored, or empty when the type is not an integer of whole bytes. */
  static Optional<LabelType> labelType(DataType type) {
    if (type instanceof EnumDataType named) {
      return labelType(named.getBaseType());
    }
    if (type instanceof FixedPoint fixed
        && fixed.getBitOffset() == 0
        && fixed.getBitPrecision() == 8 * fixed.getSize()
        && fixed.getSize() <= 8
        && Integer.bitCount(fixed.getSize()) == 1) {
      return Optional.of(new LabelType(fixed.getSize(), fixed.isSigned(), fixed.getByteOrder()));
    }
    return Optional.empty();
  }

  private static String typeName(DataType type) {
    if (type instanceof FloatingPoint) {
      return "float" + 8 * type.getSize();
    }
    return type.getClass().getSimpleName() + " of " + type.getSize() + " bytes";
  }

  /** One line for a refusal of jHDF: its innermost reason, and what the user can do about it. */
  static ImageFileException refusal(Path file, String dataset, RuntimeException thrown) {
    Throwable reason = thrown;
    while (reason.getCause() != null && reason.getCause() != reason) {
      reason = reason.getCause();
    }
    String text = reason.getMessage() == null ? "" : reason.getMessage();
    String where = "file=" + file + (dataset.isEmpty() ? "" : ", dataset=" + dataset);
    String must;
    if (text.contains("No valid HDF5 signature")) {
      return new ImageFileException("file must be HDF5: " + where, thrown);
    } else if (text.contains("data layout message version")) {
      must =
          "file must not be in the format of HDF5 2.0"
              + " (write it again with h5py.File(..., libver=('earliest', 'v114')))";
    } else if (text.contains("Virtual storage")) {
      must =
          "dataset must not be virtual"
              + " (copy its voxels into a plain dataset, e.g. h5py create_dataset(name, data=old[:]))";
    } else if (text.contains("External Data Files")) {
      must =
          "dataset must not keep its voxels in an external raw file"
              + " (copy it: h5repack -f GZIP=6 in.h5 out.h5)";
    } else if (text.contains("filter is not available")) {
      must =
          "dataset must be stored with filters that jHDF reads"
              + " (copy it where its filter is installed: h5repack -f GZIP=6 in.h5 out.h5)";
    } else if (reason instanceof HdfBrokenLinkException
        || thrown instanceof HdfBrokenLinkException) {
      must = "link must lead to a dataset (put the other file beside this one)";
    } else {
      must =
          "file must be sound HDF5 that jHDF reads (check or copy it:"
              + " h5repack -f GZIP=6 in.h5 out.h5)";
    }
    return new ImageFileException(
        must + ": " + where + ", cause=" + ImageFiles.describe(reason), thrown);
  }
}
