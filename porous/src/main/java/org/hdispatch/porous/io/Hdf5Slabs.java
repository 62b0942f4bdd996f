package org.hdispatch.porous.io;

import io.jhdf.HdfFile;
import io.jhdf.api.Dataset;
import io.jhdf.api.dataset.ChunkedDataset;
import io.jhdf.api.dataset.ContiguousDataset;
import io.jhdf.dataset.DatasetBase;
import io.jhdf.exceptions.HdfException;
import io.jhdf.filter.PipelineFilterWithData;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.hdispatch.porous.image.VoxelBox;

/**
 * Reads a box of one dataset straight into bytes, whatever its layout.
 *
 * <p>jHDF's own slices would do for most files, but they widen every uint8 to an int, turn
 * enumerations into strings, refuse compact datasets, and read parts that were never written as 0
 * whatever the fill value. So chunks and rows are taken as stored and decoded here.
 */
final class Hdf5Slabs {
  private static final int FLETCHER32 = 3;
  private static final int BITSHUFFLE = 32008;

  /** gzip, shuffle, fletcher32, LZF, LZ4: found right for every chunk size that was tried. */
  private static final Set<Integer> TRUSTED_FILTERS = Set.of(1, 2, FLETCHER32, 32000, 32004);

  private static final int FLETCHER32_BYTES = 4;

  private Hdf5Slabs() {}

  /** Reads the labels of a box that lies inside the dataset; x fastest. */
  static byte[] read(Hdf5Dataset dataset, Dataset stored, VoxelBox box) throws ImageFileException {
    LabelType type = Hdf5Access.labelType(stored.getDataType()).orElseThrow();
    VoxelBox whole = dataset.whole();
    try {
      requireTrustedFilters(dataset, stored);
      if (stored instanceof ChunkedDataset chunked) {
        return readChunks(dataset, chunked, box, type);
      }
      if (stored instanceof ContiguousDataset contiguous) {
        return readContiguous(contiguous, whole, box, type);
      }
      return readCompact(dataset, stored, whole, box, type);
    } catch (LabelType.LabelRangeException e) {
      throw e.in(dataset.where(), type);
    } catch (IOException e) {
      if (e instanceof ImageFileException wrong) {
        throw wrong;
      }
      throw ImageFiles.unreadable(dataset.file(), e);
    } catch (RuntimeException e) { // damaged files: see Hdf5Access
      throw Hdf5Access.refusal(dataset.file(), dataset.path(), e);
    }
  }

  private static void requireTrustedFilters(Hdf5Dataset dataset, Dataset stored)
      throws ImageFileException {
    for (PipelineFilterWithData filter : stored.getFilters()) {
      int id = filter.getId();
      int[] data = filter.getFilterData();
      // Bitshuffle states its compressor in the fifth value; 0 is none, and that one is read right.
      boolean plainBitshuffle = id == BITSHUFFLE && data.length > 4 && data[4] == 0;
      if (!TRUSTED_FILTERS.contains(id) && !plainBitshuffle) {
        throw new ImageFileException(
            "dataset must be stored with filters that jHDF decodes rightly (copy it where its"
                + " filter is installed: h5repack -f GZIP=6 in.h5 out.h5): "
                + dataset.where()
                + ", filter="
                + filter.getName()
                + ", id="
                + id
                + ", data="
                + Arrays.toString(data));
      }
    }
  }

  private static byte[] readChunks(
      Hdf5Dataset dataset, ChunkedDataset stored, VoxelBox box, LabelType type)
      throws ImageFileException {
    byte[] labels = new byte[Math.toIntExact(box.voxels())];
    int[] chunk = stored.getChunkDimensions();
    int rowBytes = Math.multiplyExact(chunk[2], type.bytes());
    int chunkBytes = Math.multiplyExact(Math.multiplyExact(chunk[0], chunk[1]), rowBytes);
    boolean checksummed = hasFilter(stored.getFilters(), FLETCHER32);
    int x1 = box.x0() + box.nx();
    int y1 = box.y0() + box.ny();
    int z1 = box.z0() + box.nz();
    for (int cz = box.z0() / chunk[0] * chunk[0]; cz < z1; cz = next(cz, chunk[0])) {
      for (int cy = box.y0() / chunk[1] * chunk[1]; cy < y1; cy = next(cy, chunk[1])) {
        for (int cx = box.x0() / chunk[2] * chunk[2]; cx < x1; cx = next(cx, chunk[2])) {
          byte[] voxels = decompress(stored, cz, cy, cx);
          if (voxels != null
              && voxels.length != chunkBytes
              && !(checksummed && voxels.length == chunkBytes + FLETCHER32_BYTES)) {
            throw new ImageFileException(
                "chunk must decode to its full size (the file is damaged, or its filter misread): "
                    + dataset.where()
                    + ", chunk=["
                    + cz
                    + ", "
                    + cy
                    + ", "
                    + cx
                    + "], bytes="
                    + voxels.length
                    + ", full="
                    + chunkBytes);
          }
          byte fill = voxels == null ? fillLabel(stored) : 0;
          int fromX = Math.max(cx, box.x0());
          int toX = Math.min(next(cx, chunk[2]), x1);
          for (int z = Math.max(cz, box.z0()); z < Math.min(next(cz, chunk[0]), z1); z++) {
            for (int y = Math.max(cy, box.y0()); y < Math.min(next(cy, chunk[1]), y1); y++) {
              int to = fromX - box.x0() + box.nx() * (y - box.y0() + box.ny() * (z - box.z0()));
              if (voxels == null) {
                Arrays.fill(labels, to, to + toX - fromX, fill);
              } else {
                int row = (z - cz) * chunk[1] + y - cy;
                int from = row * rowBytes + (fromX - cx) * type.bytes();
                type.decode(voxels, from, labels, to, toX - fromX);
              }
            }
          }
        }
      }
    }
    return labels;
  }

  /** Where the next chunk begins; saturates, as a chunk may reach beyond the last voxel. */
  private static int next(int start, int length) {
    return (int) Math.min((long) start + length, Integer.MAX_VALUE);
  }

  private static boolean hasFilter(List<PipelineFilterWithData> filters, int id) {
    for (PipelineFilterWithData filter : filters) {
      if (filter.getId() == id) {
        return true;
      }
    }
    return false;
  }

  /** A chunk as it was before compression, or null when it was never written. */
  private static byte[] decompress(ChunkedDataset stored, int z, int y, int x) {
    try {
      return stored.getDecompressedChunk(new int[] {z, y, x});
    } catch (HdfException e) {
      // jHDF 0.13.0 has no other way to ask (ChunkedDatasetBase). Indexes that list every chunk
      // give the undefined address, -1, to those that were never written.
      String message = String.valueOf(e.getMessage());
      if (message.startsWith("No chunk with offset") || message.endsWith("at address -1")) {
        return null;
      }
      throw e;
    }
  }

  private static byte[] readContiguous(
      ContiguousDataset stored, VoxelBox whole, VoxelBox box, LabelType type) throws IOException {
    if (stored.isEmpty()) { // no space was ever given to it in the file
      byte[] labels = new byte[Math.toIntExact(box.voxels())];
      Arrays.fill(labels, fillLabel(stored));
      return labels;
    }
    HdfFile home = stored.getHdfFile(); // another file, behind an external link
    long start = home.getUserBlockSize() + stored.getDataAddress();
    return FlatRows.read(
        home.getHdfBackingStorage().getFileChannel(), start, whole.nx(), whole.ny(), box, type);
  }

  /** Compact datasets live in the file's metadata: at most 64 KiB, so they are read whole. */
  private static byte[] readCompact(
      Hdf5Dataset dataset, Dataset stored, VoxelBox whole, VoxelBox box, LabelType type)
      throws ImageFileException {
    if (!(stored instanceof DatasetBase compact)) {
      throw new ImageFileException(
          "dataset must be contiguous, compact or chunked (copy it: h5repack -f GZIP=6 in.h5"
              + " out.h5): "
              + dataset.where()
              + ", layout="
              + stored.getDataLayout());
    }
    ByteBuffer data = compact.getDataBuffer();
    byte[] voxels = new byte[data.remaining()];
    data.get(voxels);
    byte[] labels = new byte[Math.toIntExact(box.voxels())];
    for (int z = 0; z < box.nz(); z++) {
      for (int y = 0; y < box.ny(); y++) {
        int from = box.x0() + whole.nx() * (box.y0() + y + whole.ny() * (box.z0() + z));
        int to = box.nx() * (y + box.ny() * z);
        type.decode(voxels, from * type.bytes(), labels, to, box.nx());
      }
    }
    return labels;
  }

  private static byte fillLabel(Dataset stored) {
    Object fill = stored.getFillValue();
    long value = fill instanceof Number number ? number.longValue() : 0;
    if (value < 0 || value > 255) {
      throw new LabelType.LabelRangeException(Long.toString(value));
    }
    return (byte) value;
  }
}
