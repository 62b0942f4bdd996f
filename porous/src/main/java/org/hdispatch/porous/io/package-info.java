/**
 * Images from files, and results into files: HDF5, TIFF, NumPy, NRRD, MetaImage and raw 8-bit in,
 * VTI out.
 *
 * <pre>
 * ImageFormat ─ which? ─&gt; XxxImages.open(file) ─ header ─&gt; ImageFile ─ read(box) ─&gt; VoxelImage
 *
 * Hdf5Images               Hdf5Image ─&gt; Hdf5Slabs (chunks) ──────────────┐
 * TiffImages               TiffFile ─&gt; TiffPage (strips, tiles) ─────────┼─&gt; FlatRows ─&gt; LabelType
 * Numpy-, Nrrd-, Meta-,
 * RawImages                FlatImage ─&gt; FlatVolume (plain, compressed) ──┘
 * </pre>
 *
 * <p>This package is the only user of jHDF. Sub-blocks are read without loading the volume they are
 * cut from. A file that is missing, unreadable or wrong is an {@link
 * org.hdispatch.porous.io.ImageFileException} of one line that names the remedy; a bad argument,
 * such as a box outside the image, is an {@link IllegalArgumentException}. What jHDF 0.13.0 would
 * decode wrongly without a word is refused.
 */
package org.hdispatch.porous.io;
