package org.hdispatch.porous.io;

import java.math.BigInteger;
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
    return Character.isDigit(part.charAt(0));
  }

  /** Whether two neighbours differ in their last number alone, and by another amount than 1. */
  static boolean leaveGap(String before, String after) {
    String numbers = "(.*?)(\\d+)(\\D*)";
    Matcher a = Pattern.compile(numbers).matcher(before);
    Matcher b = Pattern.compile(numbers).matcher(after);
    return a.matches()
        && b.matches()
        && a.group(1).equals(b.group(1))
        && a.group(3).equals(b.group(3))
        && !new BigInteger(b.group(2)).subtract(new BigInteger(a.group(2))).equals(BigInteger.ONE);
  }
}
