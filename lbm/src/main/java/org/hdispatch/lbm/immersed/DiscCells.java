package org.hdispatch.lbm.immersed;

/** Area that a disc round the origin shares with a rectangle, exact. */
final class DiscCells {
  private DiscCells() {}

  /** Shared area of the disc of radius R and x0..x1 times y0..y1. */
  static double area(double radius, double x0, double x1, double y0, double y1) {
    if (x0 < 0 && x1 > 0) { // the formula below is for one quadrant
      return area(radius, 0, x1, y0, y1) + area(radius, 0, -x0, y0, y1);
    }
    if (y0 < 0 && y1 > 0) {
      return area(radius, x0, x1, 0, y1) + area(radius, x0, x1, 0, -y0);
    }
    double xl = Math.min(Math.abs(x0), Math.abs(x1));
    double xh = Math.max(Math.abs(x0), Math.abs(x1));
    double yl = Math.min(Math.abs(y0), Math.abs(y1));
    double yh = Math.max(Math.abs(y0), Math.abs(y1));
    double area =
        quadrant(radius, xl, yl)
            - quadrant(radius, xh, yl)
            - quadrant(radius, xl, yh)
            + quadrant(radius, xh, yh);
    return Math.max(0, Math.min(area, (xh - xl) * (yh - yl)));
  }

  /**
   * Area of the disc's part beyond x = a and y = b, both 0 or more: 2 A = R² (acos(a/R) -
   * asin(b/R)) - a sqrt(R² - a²) - b sqrt(R² - b²) + 2 a b.
   */
  private static double quadrant(double radius, double a, double b) {
    double square = radius * radius;
    if (a * a + b * b >= square) {
      return 0;
    }
    double sa = Math.sqrt(square - a * a);
    double sb = Math.sqrt(square - b * b);
    double angle = StrictMath.atan2(sa, a) - StrictMath.atan2(b, sb);
    return Math.max(0, (square * angle - a * sa - b * sb) / 2 + a * b);
  }
}
