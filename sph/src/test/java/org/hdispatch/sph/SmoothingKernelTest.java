package org.hdispatch.sph;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.DoubleUnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What every smoothing kernel promises: normalised, smooth, of compact support, slope = dW/dr. */
class SmoothingKernelTest {

  /** Not 1, so that a forgotten power of h shows. */
  private static final double H = 0.7;

  static Stream<SmoothingKernel> kernels() {
    return Stream.of(2, 3)
        .flatMap(
            dimensions ->
                Stream.of(
                    new QuinticSpline(H, dimensions),
                    new CubicSpline(H, dimensions),
                    new WendlandC2(H, dimensions)));
  }

  @ParameterizedTest
  @MethodSource("kernels")
  void integratesToOne(SmoothingKernel kernel) {
    DoubleUnaryOperator shell =
        kernel.dimensions() == 2 ? r -> 2 * Math.PI * r : r -> 4 * Math.PI * r * r;
    double integral = 0;
    for (int piece = 0; (piece + 0.5) * H < kernel.supportRadius(); piece++) { // between knots
      integral +=
          simpson(r -> kernel.w(r) * shell.applyAsDouble(r), piece * H, (piece + 1) * H, 200);
    }
    assertEquals(1, integral, 1e-9); // Simpson on smooth pieces, O((1/200)^4)
  }

  @ParameterizedTest
  @MethodSource("kernels")
  void slopeIsTheDerivativeOfTheValue(SmoothingKernel kernel) {
    double step = 1e-6 * H;
    double scale = kernel.w(0) / H;
    for (double r = 0.01 * H; r < 1.1 * kernel.supportRadius(); r += 0.013 * H) {
      double numeric = (kernel.w(r + step) - kernel.w(r - step)) / (2 * step);
      assertEquals(
          numeric, kernel.dwdr(r), 1e-8 * scale, "r=" + r); // round-off, 1e-16 / 1e-6, and some
    }
    assertEquals(0, kernel.dwdr(0), 1e-14 * scale); // round-off
  }

  @ParameterizedTest
  @MethodSource("kernels")
  void isExactlyZeroAtAndBeyondTheSupport(SmoothingKernel kernel) {
    for (double factor : new double[] {1, 1 + 1e-12, 1.5, 2, 1e6}) {
      assertEquals(0, Math.abs(kernel.w(factor * kernel.supportRadius())));
      assertEquals(0, Math.abs(kernel.dwdr(factor * kernel.supportRadius())));
    }
    assertTrue(kernel.w(0.99 * kernel.supportRadius()) > 0);
  }

  @ParameterizedTest
  @MethodSource("kernels")
  void decreasesWithoutAJump(SmoothingKernel kernel) {
    double step = 1e-3 * H;
    for (double r = 0; r < kernel.supportRadius(); r += step) {
      double fall = kernel.w(r) - kernel.w(r + step);
      assertTrue(fall >= 0, "r=" + r);
      // no kernel here is steeper than 1.1 W(0)/h, nor its slope than 5.1 W(0)/h^2
      assertTrue(fall < 1.1e-3 * kernel.w(0), "r=" + r);
      double bend = kernel.dwdr(r + step) - kernel.dwdr(r);
      assertTrue(Math.abs(bend) < 5.1e-3 * kernel.w(0) / H, "r=" + r);
    }
  }

  @Test
  void supportIsAFixedMultipleOfTheSmoothingLength() {
    assertEquals(3 * H, new QuinticSpline(H, 3).supportRadius());
    assertEquals(2 * H, new CubicSpline(H, 3).supportRadius());
    assertEquals(2 * H, new WendlandC2(H, 3).supportRadius());
    assertEquals("quintic spline, h=0.7, 3-D, support=3 h", new QuinticSpline(H, 3).toString());
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY, 1e-200})
  void refusesASmoothingLengthThatCannotScale(double smoothingLength) {
    assertThrows(IllegalArgumentException.class, () -> new QuinticSpline(smoothingLength, 2));
    assertThrows(IllegalArgumentException.class, () -> new CubicSpline(smoothingLength, 2));
    assertThrows(IllegalArgumentException.class, () -> new WendlandC2(smoothingLength, 2));
  }

  @Test
  void namesTheDimensionsItRefuses() {
    Exception e = assertThrows(IllegalArgumentException.class, () -> new CubicSpline(1, 1));
    assertEquals("dimensions must be 2 or 3: dimensions=1", e.getMessage());
  }

  private static double simpson(DoubleUnaryOperator f, double from, double to, int pairs) {
    double half = (to - from) / (2 * pairs);
    double sum = f.applyAsDouble(from) + f.applyAsDouble(to);
    for (int i = 1; i < 2 * pairs; i++) {
      sum += (i % 2 == 1 ? 4 : 2) * f.applyAsDouble(from + i * half);
    }
    return sum * half / 3;
  }
}
