package org.hdispatch.porous.io;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;

/**
 * A dataset of an HDF5 file, checked to be an image.
 *
 * @param dataset the dataset
 * @param whole all of it
 */
record Hdf5Image(Hdf5Dataset dataset, VoxelBox whole) implements ImageFile {
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
    facts.put("format", ImageFormat.HDF5.toString());
    facts.put("file_bytes", ImageFiles.requireReadable(dataset.file()));
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
