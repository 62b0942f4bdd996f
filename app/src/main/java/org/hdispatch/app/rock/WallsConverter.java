package org.hdispatch.app.rock;

import org.hdispatch.app.console.Choices;
import org.hdispatch.porous.block.Walls;
import picocli.CommandLine.ITypeConverter;

/** Reads the words of {@link Choices} for walls, as one of them has a hyphen. */
final class WallsConverter implements ITypeConverter<Walls> {
  @Override
  public Walls convert(String word) {
    return Choices.value(Walls.values(), word);
  }
}
