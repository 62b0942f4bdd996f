package org.hdispatch.app;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** How the walls of the pores are made. */
enum Walls {
  /** Half-way bounce-back between pore and solid voxels. */
  BOUNCE_BACK,
  /** Immersed moving boundaries: voxels may be solid in part. */
  IMB;

  /** Reads the words of {@link Choices}. */
  static final class Converter implements ITypeConverter<Walls> {
    @Override
    public Walls convert(String word) {
      for (Walls each : values()) {
        if (Choices.word(each).equalsIgnoreCase(word)) {
          return each;
        }
      }
      throw new TypeConversionException("unknown word: " + word);
    }
  }
}
