package org.hdispatch.porous.io;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.io.TiffDirectory.Form;
import org.hdispatch.porous.io.TiffDirectory.WrongTiffException;

/**
 * A TIFF file: where its pages are, and what they have in common.
 *
 * @param file the file
 * @param form how it writes numbers
 * @param page how every page is stored
 * @param pages where the directory of each page stands, in bytes
 */
record TiffFile(Path file, Form form, TiffPage page, List<Long> pages) {
  private static final int CLASSIC = 42;
  private static final int BIG = 43;
  private static final int DESCRIPTION = 270;
  private static final int MOST_DESCRIPTION = 4096;
  private static final Pattern IMAGEJ_IMAGES =
      Pattern.compile("\\AImageJ=[\\s\\S]*?\\nimages=(\\d+)");

  /** More than one channel or frame: its pages are not, or not only, slices along z. */
  private static final Pattern IMAGEJ_NO_SLICES =
      Pattern.compile("\\AImageJ=[\\s\\S]*?\\n((?:channels|frames)=(?:[2-9]|1\\d)\\d*)");

  /** Whether a file begins like this. */
  static boolean isStart(byte[] start) {
    if (start.length < 4 || start[0] != start[1]) {
      return false;
    }
    int low = start[0] == 'I' ? 2 : 3;
    boolean known = start[low] == CLASSIC || start[low] == BIG;
    return (start[0] == 'I' || start[0] == 'M') && known && start[5 - low] == 0;
  }

  /** Reads all directories, none of the pixels. */
  static TiffFile open(Path file) throws ImageFileException {
    ImageFiles.requireReadable(file);
    try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
      ByteBuffer head = ByteBuffer.allocate(16);
      channel.read(head, 0);
      byte[] start = head.array();
      if (head.position() < 8 || !isStart(start)) {
        throw new ImageFileException("file must be TIFF: file=" + file);
      }
      boolean little = start[0] == 'I';
      boolean big = start[little ? 2 : 3] == BIG;
      Form form = new Form(little ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN, big);
      head.order(form.order()).position(big ? 8 : 4);
      return open(file, channel, form, form.place(head));
    } catch (IOException e) {
      throw refusal("file=" + file, e);
    }
  }

  private static TiffFile open(Path file, FileChannel channel, Form form, long first)
      throws ImageFileException {
    Set<Long> pages = new LinkedHashSet<>();
    TiffPage common = null;
    for (long at = first; at != 0; ) {
      String where = "file=" + file + ", page=" + pages.size();
      if (!pages.add(at)) {
        throw new ImageFileException("pages must not lead back to an earlier one: " + where);
      }
      try {
        TiffDirectory tags = new TiffDirectory(channel, form, at);
        TiffPage page = TiffPage.of(tags);
        if (common == null) {
          common = page;
        } else if (!common.equals(page)) {
          throw unlike(where, page, common);
        }
        at = tags.next();
      } catch (IOException e) {
        throw refusal(where, e);
      }
    }
    if (common == null) {
      throw new ImageFileException("file must have a page: file=" + file);
    }
    TiffFile tiff = new TiffFile(file, form, common, List.copyOf(pages));
    tiff.requireImageJPages(channel);
    return tiff;
  }

  /** A page that differs from the first. */
  static ImageFileException unlike(String where, TiffPage page, TiffPage common) {
    return new ImageFileException(
        "all pages must be of one size and type: "
            + where
            + ", found="
            + words(page)
            + ", first="
            + words(common));
  }

  private static String words(TiffPage page) {
    return page.width() + "x" + page.height() + " " + page.type();
  }

  /**
   * All images that ImageJ states must be pages, as it leaves out all but the first from files
   * above 4 GB, and pages must be slices: it stores channels and frames as pages too.
   */
  private void requireImageJPages(FileChannel channel) throws ImageFileException {
    try {
      String text =
          new TiffDirectory(channel, form, pages.get(0))
              .text(DESCRIPTION, MOST_DESCRIPTION)
              .orElse("");
      Matcher images = IMAGEJ_IMAGES.matcher(text);
      if (images.find() && !images.group(1).equals(Integer.toString(pages.size()))) {
        throw new ImageFileException(
            "file must have a page for each of ImageJ's images (save it as an image sequence or as"
                + " raw data): file="
                + file
                + ", pages="
                + pages.size()
                + ", images="
                + images.group(1));
      }
      Matcher noSlices = IMAGEJ_NO_SLICES.matcher(text);
      if (noSlices.find()) {
        throw new ImageFileException(
            "ImageJ's images must be slices (save one channel and frame; if all are slices, say so"
                + " in ImageJ: Image > Properties): file="
                + file
                + ", "
                + noSlices.group(1));
      }
    } catch (IOException e) {
      throw refusal("file=" + file, e);
    }
  }

  /** Reads what a box covers of some pages that follow each other. */
  void read(int firstPage, int count, VoxelBox box, byte[] labels, int to)
      throws ImageFileException {
    String where = "file=" + file;
    try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
      for (int i = 0; i < count; i++) {
        where = "file=" + file + ", page=" + (firstPage + i);
        TiffDirectory tags = new TiffDirectory(channel, form, pages.get(firstPage + i));
        int at = to + i * box.nx() * box.ny();
        if (!page.equals(TiffPage.of(tags))) {
          throw new ImageFileException("file must not change while it is read: " + where);
        }
        page.read(channel, form, tags, box, labels, at);
      }
    } catch (LabelType.LabelRangeException e) {
      throw e.in(where, page.type());
    } catch (IOException e) {
      throw refusal(where, e);
    }
  }

  private static ImageFileException refusal(String where, IOException e) {
    if (e instanceof ImageFileException wrong) {
      return wrong;
    } else if (e instanceof WrongTiffException wrong) {
      return wrong.in(where);
    } else if (e instanceof EOFException) {
      return new ImageFileException(
          "TIFF must be complete (the file is cut short): "
              + where
              + ", cause="
              + ImageFiles.describe(e),
          e);
    }
    return new ImageFileException(
        "file must be readable: " + where + ", cause=" + ImageFiles.describe(e), e);
  }
}
