package org.hdispatch.porous.io;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * One image file directory: the tags of a page (TIFF 6.0, section 2; BigTIFF has wider fields).
 *
 * <p>A file that is cut short is an {@link EOFException}; one whose tags make no sense a {@link
 * WrongTiffException}.
 */
final class TiffDirectory {
  private static final int MOST_TAGS = 1 << 16;

  /** What must hold and does not, still without file and page. */
  static final class WrongTiffException extends IOException {
    private static final long serialVersionUID = 1L;

    private final String values;

    /**
     * A refusal.
     *
     * @param must what must hold
     * @param values what is there instead: {@code name=value}
     */
    WrongTiffException(String must, String values) {
      super(must);
      this.values = values;
    }

    ImageFileException in(String where) {
      return new ImageFileException(getMessage() + ": " + where + ", " + values, this);
    }
  }

  /** How a file writes its numbers. */
  record Form(ByteOrder order, boolean big) {
    /** Bytes of a place in the file. */
    int placeBytes() {
      return big ? Long.BYTES : Integer.BYTES;
    }

    ByteBuffer read(FileChannel channel, long at, int bytes) throws IOException {
      if (at < 0 || bytes > channel.size() - at) {
        throw new EOFException("file ends at " + channel.size() + " bytes");
      }
      ByteBuffer buffer = ByteBuffer.allocate(bytes).order(order);
      long from = at;
      while (buffer.hasRemaining()) {
        int got = channel.read(buffer, from);
        if (got < 0) {
          throw new EOFException("file ends at " + channel.size() + " bytes");
        }
        from += got;
      }
      return buffer.flip();
    }

    long place(ByteBuffer from) {
      return big ? from.getLong() : from.getInt() & 0xffffffffL;
    }
  }

  /** A tag: where its values stand. */
  private record Tag(int type, long count, long at) {
    int bytes() throws WrongTiffException {
      return switch (type) {
        case 1, 2, 6, 7 -> 1;
        case 3, 8 -> 2;
        case 4, 9, 11, 13 -> 4;
        case 5, 10, 12, 16, 17, 18 -> 8;
        default -> throw new WrongTiffException("tag must be of a known type", "type=" + type);
      };
    }
  }

  private final FileChannel channel;
  private final Form form;
  private final Map<Integer, Tag> tags = new HashMap<>();
  private final long next;

  /** Reads the directory at a place of a file. */
  TiffDirectory(FileChannel channel, Form form, long at) throws IOException {
    this.channel = channel;
    this.form = form;
    int countBytes = form.big() ? Long.BYTES : Short.BYTES;
    ByteBuffer head = form.read(channel, at, countBytes);
    long count = form.big() ? head.getLong() : head.getShort() & 0xffff;
    if (count < 1 || count > MOST_TAGS) {
      throw new WrongTiffException("page must have 1 to " + MOST_TAGS + " tags", "tags=" + count);
    }
    int entryBytes = 4 + 2 * form.placeBytes();
    long entries = at + countBytes;
    ByteBuffer all = form.read(channel, entries, (int) count * entryBytes + form.placeBytes());
    for (int i = 0; i < count; i++) {
      int id = all.getShort() & 0xffff;
      int type = all.getShort() & 0xffff;
      long values = form.place(all);
      long inside = entries + all.position();
      long outside = form.place(all);
      Tag tag = new Tag(type, values, inside);
      boolean fits = type < 1 || type > 18 || values <= form.placeBytes() / tag.bytes();
      tags.put(id, fits ? tag : new Tag(type, values, outside));
    }
    next = form.place(all);
  }

  /** Where the directory of the next page stands; 0 after the last. */
  long next() {
    return next;
  }

  /** A tag of one number. */
  long number(int id, long absent) throws IOException {
    return tags.containsKey(id) ? numbers(id, 1)[0] : absent;
  }

  /** A tag of one number that must be there. */
  long number(int id, String name) throws IOException {
    return numbers(id, name, 1)[0];
  }

  /** A tag of so many whole numbers that must be there. */
  long[] numbers(int id, String name, int count) throws IOException {
    if (!tags.containsKey(id)) {
      throw new WrongTiffException("page must have the tag " + name, "tag=" + id);
    }
    return numbers(id, count);
  }

  private long[] numbers(int id, int count) throws IOException {
    Tag tag = tags.get(id);
    if (tag.count() < count) {
      throw new WrongTiffException(
          "tag must hold " + count + " numbers", "tag=" + id + ", numbers=" + tag.count());
    }
    int bytes = tag.bytes();
    ByteBuffer from = form.read(channel, tag.at(), Math.multiplyExact(count, bytes));
    long[] numbers = new long[count];
    for (int i = 0; i < count; i++) {
      numbers[i] =
          switch (tag.type()) {
            case 1 -> from.get() & 0xff;
            case 3 -> from.getShort() & 0xffff;
            case 4, 13 -> from.getInt() & 0xffffffffL;
            case 16, 18 -> from.getLong();
            default ->
                throw new WrongTiffException(
                    "tag must be of whole numbers", "tag=" + id + ", type=" + tag.type());
          };
    }
    return numbers;
  }

  /** The beginning of a text, if there is one. */
  Optional<String> text(int id, int most) throws IOException {
    Tag tag = tags.get(id);
    if (tag == null || tag.type() != 2) {
      return Optional.empty();
    }
    int bytes = (int) Math.min(tag.count(), most);
    return Optional.of(
        new String(form.read(channel, tag.at(), bytes).array(), StandardCharsets.ISO_8859_1));
  }
}
