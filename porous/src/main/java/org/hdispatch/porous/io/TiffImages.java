package org.hdispatch.porous.io;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;

/**
 * TIFF and BigTIFF stacks: one file with a page for each slice along z, or a folder of slices.
 *
 * <p>Pages are grey, palette or bilevel, of 1 to 32 bits, uncompressed or packed by LZW, Deflate or
 * PackBits, in strips or tiles. Labels are the numbers as they are stored: of a palette image the
 * index, and where 0 means white still 0. All must be within 0..255. A folder's slices are its
 * files named {@code .tif} or {@code .tiff}, numbers in their names compared as numbers. Where any
 * has a number, the names must be equal apart from one number, which counts the slices.
 *
 * <p>The voxel edge is unknown: the resolution of a page is in dots per inch, and seldom true.
 */
public final class TiffImages {
  private TiffImages() {}

  /**
   * The stack in a file or folder.
   *
   * @param path a TIFF file, or a folder of TIFF files with one page each
   * @return the image, its voxel edge unknown
   * @throws ImageFileException if a file is missing, not TIFF or cut short, if its pages differ in
   *     size or type, or are of a kind that is not read, if a slice seems to be missing, or if the
   *     slices seem to be of more than one series; the message names the remedy
   */
  public static ImageFile open(Path path) throws ImageFileException {
    return Files.isDirectory(path) ? folder(path) : stack(path);
  }

  private static ImageFile stack(Path path) throws ImageFileException {
    TiffFile file = TiffFile.open(path);
    TiffPage page = file.page();
    Map<String, Object> facts = new LinkedHashMap<>();
    facts.put("format", file.form().big() ? "BigTIFF" : ImageFormat.TIFF.toString());
    facts.put("file_bytes", ImageFiles.requireReadable(path));
    facts.put("type", page.type());
    facts.put("pages", file.pages().size());
    VoxelBox whole = VoxelBox.whole(page.width(), page.height(), file.pages().size());
    return new Stack(path, whole, List.of(file), facts);
  }

  private static ImageFile folder(Path path) throws ImageFileException {
    List<Path> slices = slices(path);
    List<TiffFile> files = new ArrayList<>();
    long bytes = 0;
    for (Path slice : slices) {
      TiffFile file = TiffFile.open(slice);
      if (file.pages().size() != 1) {
        throw new ImageFileException(
            "slices in a folder must have one page each: file="
                + slice
                + ", pages="
                + file.pages().size());
      }
      if (!files.isEmpty() && !file.page().equals(files.get(0).page())) {
        throw TiffFile.unlike("file=" + slice, file.page(), files.get(0).page());
      }
      files.add(file);
      bytes += ImageFiles.requireReadable(slice);
    }
    TiffPage page = files.get(0).page();
    Map<String, Object> facts = new LinkedHashMap<>();
    facts.put("format", ImageFormat.TIFF + " slices");
    facts.put("file_bytes", bytes);
    facts.put("type", page.type());
    facts.put("slices", slices.size());
    facts.put("first_slice", slices.get(0).getFileName().toString());
    facts.put("last_slice", slices.get(slices.size() - 1).getFileName().toString());
    VoxelBox whole = VoxelBox.whole(page.width(), page.height(), slices.size());
    return new Stack(path, whole, files, facts);
  }

  /** The slices of a folder in their order. */
  private static List<Path> slices(Path folder) throws ImageFileException {
    List<Path> slices = new ArrayList<>();
    try (DirectoryStream<Path> all = Files.newDirectoryStream(folder)) {
      for (Path each : all) {
        String name = each.getFileName().toString().toLowerCase(Locale.ROOT);
        if (name.matches("[^.].*\\.tiff?")) { // not the hidden ones that some systems leave
          slices.add(each);
        }
      }
    } catch (IOException e) {
      throw ImageFiles.unreadable(folder, e);
    }
    if (slices.isEmpty()) {
      throw new ImageFileException(
          "folder must hold the slices of an image (.tif, .tiff): file=" + folder);
    }
    slices.sort((a, b) -> SliceNames.compare(name(a), name(b)));
    requireOneSeries(folder, slices.stream().map(TiffImages::name).toList());
    for (int i = 1; i < slices.size(); i++) {
      String before = name(slices.get(i - 1));
      String after = name(slices.get(i));
      if (SliceNames.leaveGap(before, after)) {
        throw new ImageFileException(
            "slices must be numbered without a gap: file="
                + folder
                + ", slices="
                + before
                + " and "
                + after);
      }
    }
    return slices;
  }

  /** Slices that have numbers must have the same name apart from one number, the same in all. */
  private static void requireOneSeries(Path folder, List<String> names) throws ImageFileException {
    if (names.stream().allMatch(SliceNames::isUnnumbered)) {
      return;
    }
    int counted = -1;
    for (int i = 1; i < names.size(); i++) {
      int different = SliceNames.onlyDifferentNumber(names.get(i - 1), names.get(i));
      counted = i == 1 ? different : counted;
      if (different < 0 || different != counted) {
        throw new ImageFileException(
            "slices must be of one series: folder="
                + folder
                + ", slices="
                + names.get(i - 1)
                + " and "
                + names.get(i));
      }
    }
  }

  private static String name(Path path) {
    return path.getFileName().toString();
  }

  /** Pages one above the other: of one file, or of as many files. */
  private record Stack(Path path, VoxelBox whole, List<TiffFile> files, Map<String, Object> facts)
      implements ImageFile {
    @Override
    public String name() {
      return path.toString();
    }

    @Override
    public OptionalDouble voxelEdge() {
      return OptionalDouble.empty();
    }

    @Override
    public VoxelImage read(VoxelBox box) throws ImageFileException {
      box.within(whole.nx(), whole.ny(), whole.nz());
      byte[] labels = new byte[VoxelImage.requireFits(box.nx(), box.ny(), box.nz())];
      if (files.size() == 1) {
        files.get(0).read(box.z0(), box.nz(), box, labels, 0);
      } else {
        for (int z = 0; z < box.nz(); z++) {
          files.get(box.z0() + z).read(0, 1, box, labels, z * box.nx() * box.ny());
        }
      }
      return VoxelImage.of(box.nx(), box.ny(), box.nz(), labels);
    }
  }
}
