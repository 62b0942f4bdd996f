package org.hdispatch.porous.survey;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The part of a survey that one process does: every {@code count}-th block of its plan, along all
 * axes, so that no block is read twice. The files of a shard bear its name, so that all write side
 * by side into one folder.
 *
 * @param number which one, from 1
 * @param count how many there are
 */
public record Shard(int number, int count) {
  /** A survey in one piece. */
  public static final Shard WHOLE = new Shard(1, 1);

  private static final Pattern GIVEN = Pattern.compile("(\\d{1,9})/(\\d{1,9})");

  /**
   * A shard.
   *
   * @throws IllegalArgumentException if the number is not 1 to the count
   */
  public Shard {
    if (number < 1 || number > count) {
      throw new IllegalArgumentException("shard must be 1/N to N/N: shard=" + number + "/" + count);
    }
  }

  /**
   * The shard of a text {@code i/N}.
   *
   * @throws IllegalArgumentException if it is not of this form, or i is not 1 to N
   */
  public static Shard parse(String text) {
    Matcher given = GIVEN.matcher(text);
    if (!given.matches()) {
      throw new IllegalArgumentException("shard must be 1/N to N/N: shard=" + text);
    }
    return new Shard(Integer.parseInt(given.group(1)), Integer.parseInt(given.group(2)));
  }

  /**
   * Whether a block belongs to this shard.
   *
   * @param block its place in the plan, from 0
   */
  public boolean has(int block) {
    return block % count == number - 1;
  }

  /** How many of so many blocks belong to this shard. */
  public int share(int blocks) {
    return (int) (((long) blocks - number + count) / count);
  }

  /** What its files are called: {@code survey}, or {@code survey-i-of-N}. */
  String fileName() {
    return count == 1 ? "survey" : "survey-" + number + "-of-" + count;
  }

  @Override
  public String toString() {
    return number + "/" + count;
  }
}
