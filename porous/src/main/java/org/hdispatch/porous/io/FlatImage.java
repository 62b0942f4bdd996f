package org.hdispatch.porous.io;

import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;

/**
 * An image whose voxels are a flat volume, whatever header describes it.
 *
 * @param file the file that is named: the header's, where the voxels have a file of their own
 * @param volume the voxels
 * @param order which axis of the image is the first of the volume
 * @param voxelEdge edge of a voxel in metres, if stated
 * @param facts what is to be said about it
 */
record FlatImage(
    Path file, FlatVolume volume, Order order, OptionalDouble voxelEdge, Map<String, Object> facts)
    implements ImageFile {

  /** Which axis runs fastest in the file. */
  enum Order {
    /** x, then y, then z: the order of images. */
    X_FASTEST,
    /** z, then y, then x: the axes of the volume are those of the image turned round. */
    Z_FASTEST
  }

  /** An image; the facts are copied. */
  FlatImage {
    facts = Collections.unmodifiableMap(new LinkedHashMap<>(facts));
  }

  /** An image, its length checked as far as that goes without reading it. */
  static FlatImage of(
      String format,
      Path file,
      FlatVolume volume,
      Order order,
      OptionalDouble voxelEdge,
      Map<String, Object> more)
      throws ImageFileException {
    Map<String, Object> facts = new LinkedHashMap<>();
    facts.put("format", format);
    facts.put("file_bytes", volume.requireLength());
    facts.putAll(more);
    facts.put("image_bytes", FlatVolume.bytes(volume.whole(), volume.type()));
    return new FlatImage(file, volume, order, voxelEdge, facts);
  }

  @Override
  public String name() {
    return file.toString();
  }

  @Override
  public VoxelBox whole() {
    VoxelBox stored = volume.whole();
    return order == Order.X_FASTEST
        ? stored
        : VoxelBox.whole(stored.nz(), stored.ny(), stored.nx());
  }

  @Override
  public VoxelImage read(VoxelBox box) throws ImageFileException {
    VoxelBox whole = whole();
    box.within(whole.nx(), whole.ny(), whole.nz());
    volume.requireLength();
    VoxelImage.requireFits(box.nx(), box.ny(), box.nz());
    byte[] labels = order == Order.X_FASTEST ? volume.read(box) : turned(box);
    VoxelImage image = VoxelImage.of(box.nx(), box.ny(), box.nz(), labels);
    return voxelEdge.isPresent() ? image.withVoxelEdge(voxelEdge.getAsDouble()) : image;
  }

  /** Reads one plane across x after the other, so that no more is held than the box and a plane. */
  private byte[] turned(VoxelBox box) throws ImageFileException {
    byte[] labels = new byte[Math.toIntExact(box.voxels())];
    for (int x = 0; x < box.nx(); x++) {
      byte[] plane =
          volume.read(new VoxelBox(box.z0(), box.y0(), box.x0() + x, box.nz(), box.ny(), 1));
      int from = 0;
      for (int y = 0; y < box.ny(); y++) {
        for (int z = 0; z < box.nz(); z++) {
          labels[x + box.nx() * (y + box.ny() * z)] = plane[from++];
        }
      }
    }
    return labels;
  }
}
