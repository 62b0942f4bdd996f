package org.hdispatch.porous.io;

import java.math.BigInteger;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The order of slices by their names: numbers in them count as numbers, so that 2 is before 10. */
final class SliceNames {
  private static final Pattern PART = Pattern.compile("\\d+|\\D+");

  private SliceNames() {}

  /** Less than 0 if the first name comes first; 0 only for equal names. */
  static int compare(String a, String b) {
    Matcher partsA = PART.matcher(a);
    Matcher partsB = PART.matcher(b);
    while (true) {
      boolean moreA = partsA.find();
      boolean moreB = partsB.find();
      if (!moreA || !moreB) {
        return moreA == moreB ? a.compareTo(b) : Boolean.compare(moreA, moreB);
      }
      int order = comparePart(partsA.group(), partsB.group());
      if (order != 0) {
        return order;
      }
    }
  }

  private static int comparePart(String a, String b) {
    return isNumber(a) && isNumber(b)
        ? new BigInteger(a).compareTo(new BigInteger(b))
        : a.compareTo(b);
  }

  private static boolean isNumber(String part) {
    return part.charAt(0) >= '0' && part.charAt(0) <= '9'; // as \d, other digits are text
  }

  /** Whether a name has no number. */
  static boolean isUnnumbered(String name) {
    return parts(name).stream().noneMatch(SliceNames::isNumber);
  }

  /**
   * Which number two names differ in, if they are equal apart from one: its place among the parts
   * of the names; -1 if they differ in text, or in more than one number.
   */
  static int onlyDifferentNumber(String a, String b) {
    List<String> partsA = parts(a);
    List<String> partsB = parts(b);
    int different = -1;
    for (int i = 0; i < partsA.size() && partsA.size() == partsB.size(); i++) {
      String partA = partsA.get(i);
      String partB = partsB.get(i);
      if (!partA.equals(partB)) {
        if (different >= 0 || !isNumber(partA) || !isNumber(partB)) {
          return -1;
        }
        different = i;
      }
    }
    return different;
  }

  /** Whether two neighbours differ in one number alone, and by another amount than 1. */
  static boolean leaveGap(String before, String after) {
    int at = onlyDifferentNumber(before, after);
    return at >= 0 && !number(after, at).subtract(number(before, at)).equals(BigInteger.ONE);
  }

  private static BigInteger number(String name, int part) {
    return new BigInteger(parts(name).get(part));
  }

  private static List<String> parts(String name) {
    return PART.matcher(name).results().map(MatchResult::group).toList();
  }
}
