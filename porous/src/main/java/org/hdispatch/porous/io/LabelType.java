package org.hdispatch.porous.io;

import java.nio.ByteOrder;

/**
 * How an integer label is stored in a file, and how it becomes a byte.
 *
 * @param bytes bytes per voxel: 1, 2, 4 or 8
 * @param signed whether the top bit is a sign
 * @param order byte order
 */
record LabelType(int bytes, boolean signed, ByteOrder order) {
  /** The plain label: one unsigned byte. */
  static final LabelType UINT8 = new LabelType(1, false, ByteOrder.LITTLE_ENDIAN);

  /**
   * Decodes labels into bytes.
   *
   * @param from stored labels
   * @param fromByte first byte of the first label
   * @param to where the labels go, as bytes 0..255
   * @param toVoxel place of the first label
   * @param count how many labels
   * @throws LabelRangeException if a label lies outside 0..255
   */
  void decode(byte[] from, int fromByte, byte[] to, int toVoxel, int count) {
    if (bytes == 1 && !signed) {
      System.arraycopy(from, fromByte, to, toVoxel, count);
      return;
    }
    int at = fromByte;
    for (int i = 0; i < count; i++) {
      long value = value(from, at);
      if (value < 0 || value > 255) {
        throw new LabelRangeException(
            !signed && value < 0 ? Long.toUnsignedString(value) : Long.toString(value));
      }
      to[toVoxel + i] = (byte) value;
      at += bytes;
    }
  }

  private long value(byte[] from, int at) {
    boolean big = order == ByteOrder.BIG_ENDIAN;
    // The most significant byte carries the sign; the others are unsigned.
    byte top = from[big ? at : at + bytes - 1];
    long value = signed ? top : top & 0xff;
    for (int i = 1; i < bytes; i++) {
      value = value << 8 | from[big ? at + i : at + bytes - 1 - i] & 0xff;
    }
    return value;
  }

  /** The type in NumPy's words, such as {@code uint8} or {@code int16 big-endian}. */
  @Override
  public String toString() {
    String name = (signed ? "int" : "uint") + 8 * bytes;
    return bytes > 1 && order == ByteOrder.BIG_ENDIAN ? name + " big-endian" : name;
  }

  /** A stored label does not fit into a byte. */
  static final class LabelRangeException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    LabelRangeException(String value) {
      super(value);
    }

    /** What to throw, with the place where the label was found. */
    ImageFileException in(String where, Object type) {
      return new ImageFileException(
          "labels must be within 0..255 (map them to uint8): "
              + where
              + ", type="
              + type
              + ", label="
              + getMessage(),
          this);
    }
  }
}
