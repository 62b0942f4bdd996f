package org.hdispatch.sph.vector;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * Writes the loops over quads: one class a smoothing kernel, in it one loop for densities and one a
 * model of the viscosity. What they share stands here once.
 *
 * <p>{@code main} writes the files; {@code SumsSourceTest} compares them with what this class
 * writes.
 */
enum SumsSource {
  QUINTIC(
      "the quintic spline",
      """
          DoubleVector a = constant(3).sub(q);
          DoubleVector b = constant(2).sub(q);
          DoubleVector c = constant(1).sub(q);
          a = a.add(a.abs());
          b = b.add(b.abs());
          c = c.add(c.abs());
          DoubleVector a2 = a.mul(a);
          DoubleVector b2 = b.mul(b);
          DoubleVector c2 = c.mul(c);
      """,
      """
          DoubleVector a5 = a2.mul(a2).mul(a);
          DoubleVector sum2 = b2.mul(b2).mul(b).fma(constant(-6), a5);
          DoubleVector shape = c2.mul(c2).mul(c).fma(constant(15), sum2);
      """,
      """
          DoubleVector sum2 = b2.mul(b2).fma(constant(-6), a2.mul(a2));
          DoubleVector slope = c2.mul(c2).fma(constant(15), sum2).div(q);
      """),
  CUBIC(
      "the cubic spline",
      """
          DoubleVector a = constant(2).sub(q);
          DoubleVector b = constant(1).sub(q);
          a = a.add(a.abs());
          b = b.add(b.abs());
      """,
      """
          DoubleVector shape = b.mul(b).mul(b).fma(constant(-4), a.mul(a).mul(a));
      """,
      """
          DoubleVector slope = b.mul(b).fma(constant(-4), a.mul(a)).div(q);
      """),
  WENDLAND(
      "the Wendland C2 kernel",
      """
          DoubleVector a = q.fma(constant(-0.5), constant(1));
          a = a.add(a.abs());
      """,
      """
          DoubleVector a2 = a.mul(a);
          DoubleVector line = q.fma(constant(2), constant(1));
          DoubleVector shape = a2.mul(a2).mul(line);
      """,
      """
          DoubleVector slope = a.mul(a).mul(a);
      """);

  private static final Path MAIN = Path.of("src/main/java/org/hdispatch/sph/vector");

  private static final String FILE =
      """
      package org.hdispatch.sph.vector;

      import static org.hdispatch.sph.Neighbourhood.DEPTH;
      import static org.hdispatch.sph.Neighbourhood.LANES;
      import static org.hdispatch.sph.Neighbourhood.PRESSURE;
      import static org.hdispatch.sph.Neighbourhood.UX;
      import static org.hdispatch.sph.Neighbourhood.UY;
      import static org.hdispatch.sph.Neighbourhood.UZ;
      import static org.hdispatch.sph.Neighbourhood.VISCOSITY;
      import static org.hdispatch.sph.Neighbourhood.VOLUME;
      import static org.hdispatch.sph.Neighbourhood.Y;
      import static org.hdispatch.sph.Neighbourhood.Z;

      import jdk.incubator.vector.DoubleVector;
      import jdk.incubator.vector.VectorOperators;
      import org.hdispatch.sph.PairModel;

      /** Sums with KERNEL. Written by SumsSource: do not edit. */
      final class NAME extends VectorSums {
        private final double inverseLength;

        NAME(PairModel model) {
          super(model);
          inverseLength = model.kernel().inverseLength();
        }

        @Override
        double density(double[] v, int stride, int own, char[] quads, int from, int to) {
          int ys = Y * stride;
          int zs = Z * stride;
          DoubleVector x = constant(v[own]);
          DoubleVector y = constant(v[ys + own]);
          DoubleVector z = constant(v[zs + own]);
          DoubleVector scale = constant(inverseLength);
          DoubleVector least = constant(LEAST_SQUARE);
          DoubleVector sum = constant(0);
          DoubleVector q = constant(FAR);
          for (int entry = from; entry < to; entry++) {
            int n = quads[entry] * LANES;
      LOOPED      DoubleVector dx = DoubleVector.fromArray(QUAD, v, n).sub(x);
            DoubleVector dy = DoubleVector.fromArray(QUAD, v, ys + n).sub(y);
            DoubleVector dz = DoubleVector.fromArray(QUAD, v, zs + n).sub(z);
            q = dz.fma(dz, dy.fma(dy, dx.fma(dx, least))).sqrt().mul(scale);
            sum = sum.add(shape);
          }
      LAST    sum = sum.add(shape);
          return (sum.lane(0) + sum.lane(1)) + (sum.lane(2) + sum.lane(3));
        }
      UNIFORMARITHMETICHARMONIC}
      """;

  private static final String FORCE =
      """

        @Override
        void METHOD(
      PARAMETERS) {
          int ys = Y * stride;
          int zs = Z * stride;
          int uxs = UX * stride;
          int uys = UY * stride;
          int uzs = UZ * stride;
          int volumes = VOLUME * stride;
          int pressures = PRESSURE * stride;
      PLANES    DoubleVector x = constant(v[own]);
          DoubleVector y = constant(v[ys + own]);
          DoubleVector z = constant(v[zs + own]);
          DoubleVector ux = constant(v[uxs + own]);
          DoubleVector uy = constant(v[uys + own]);
          DoubleVector uz = constant(v[uzs + own]);
          DoubleVector pressure = constant(v[pressures + own]);
      CONSTANTS    DoubleVector scale = constant(inverseLength);
          DoubleVector least = constant(LEAST_SQUARE);
          DoubleVector sumX = constant(0);
          DoubleVector sumY = constant(0);
          DoubleVector sumZ = constant(0);
      SPLIT    DoubleVector dx = constant(0);
          DoubleVector dy = constant(0);
          DoubleVector dz = constant(0);
          DoubleVector q = constant(FAR);
          int last = own / LANES * LANES; // of the quad whose dx, dy, dz and q are known
          for (int entry = from; entry < to; entry++) {
            int n = quads[entry] * LANES;
      LOOPED      dx = DoubleVector.fromArray(QUAD, v, n).sub(x);
            dy = DoubleVector.fromArray(QUAD, v, ys + n).sub(y);
            dz = DoubleVector.fromArray(QUAD, v, zs + n).sub(z);
            q = dz.fma(dz, dy.fma(dy, dx.fma(dx, least))).sqrt().mul(scale);
            last = n;
          }
      STEP    sums[0] = (sumX.lane(0) + sumX.lane(1)) + (sumX.lane(2) + sumX.lane(3));
          sums[1] = (sumY.lane(0) + sumY.lane(1)) + (sumY.lane(2) + sumY.lane(3));
          sums[2] = (sumZ.lane(0) + sumZ.lane(1)) + (sumZ.lane(2) + sumZ.lane(3));
      REST  }
      """;

  /** Adds what the last quad does to the sums. */
  private static final String STEP =
      """
      SLOPE    DoubleVector volumeJ = DoubleVector.fromArray(QUAD, v, volumes + last);
      DRAG    DoubleVector pressureJ = DoubleVector.fromArray(QUAD, v, pressures + last);
          DoubleVector p = pressure.add(pressureJ).mul(slope);
      ADD""";

  private static final String DRAG =
      """
          DoubleVector drag = volume.mul(volumeJ).mul(slope);
      """;

  private static final String ADD =
      """
          sumX = ux.sub(DoubleVector.fromArray(QUAD, v, uxs + last)).fma(drag, dx.fma(p, sumX));
          sumY = uy.sub(DoubleVector.fromArray(QUAD, v, uys + last)).fma(drag, dy.fma(p, sumY));
          sumZ = uz.sub(DoubleVector.fromArray(QUAD, v, uzs + last)).fma(drag, dz.fma(p, sumZ));
      """;

  private static final String DRAG_AT_WALLS =
      """
          DoubleVector depth = DoubleVector.fromArray(QUAD, v, depths + last);
          DoubleVector free = depth.fma(near, constant(1));
          DoubleVector wall = free.blend(most, free.compare(VectorOperators.GT, most));
          DoubleVector other = DoubleVector.fromArray(QUAD, v, viscosities + last);
          DoubleVector touched = other.blend(viscosity, other.compare(VectorOperators.EQ, zero));
          DoubleVector mu = touched.add(viscosity);
          DoubleVector bare = volume.mul(volumeJ).mul(slope);
          DoubleVector pair = bare.mul(PAIR);
          DoubleVector drag = pair.mul(wall);
          bend = bend.add(pair.mul(free).mul(free.sub(constant(1))));
      """;

  private static final String ADD_AT_WALLS =
      """
          sumX = dx.fma(p, sumX);
          sumY = dy.fma(p, sumY);
          sumZ = dz.fma(p, sumZ);
          dragX = ux.sub(DoubleVector.fromArray(QUAD, v, uxs + last)).fma(drag, dragX);
          dragY = uy.sub(DoubleVector.fromArray(QUAD, v, uys + last)).fma(drag, dragY);
          dragZ = uz.sub(DoubleVector.fromArray(QUAD, v, uzs + last)).fma(drag, dragZ);
      """;

  private static final String SPLIT_AT_WALLS =
      """
          DoubleVector dragX = constant(0);
          DoubleVector dragY = constant(0);
          DoubleVector dragZ = constant(0);
          DoubleVector bend = constant(0);
      """;

  private static final String REST_AT_WALLS =
      """
          sums[3] = (dragX.lane(0) + dragX.lane(1)) + (dragX.lane(2) + dragX.lane(3));
          sums[4] = (dragY.lane(0) + dragY.lane(1)) + (dragY.lane(2) + dragY.lane(3));
          sums[5] = (dragZ.lane(0) + dragZ.lane(1)) + (dragZ.lane(2) + dragZ.lane(3));
          sums[6] = (bend.lane(0) + bend.lane(1)) + (bend.lane(2) + bend.lane(3));
      """;

  private final String kernel;
  private final String common;
  private final String shape;
  private final String slope;

  SumsSource(String kernel, String common, String shape, String slope) {
    this.kernel = kernel;
    this.common = common;
    this.shape = shape;
    this.slope = slope;
  }

  /** Writes all classes; to be run in the folder of this module. */
  public static void main(String[] none) throws IOException {
    for (SumsSource each : values()) {
      Files.writeString(each.file(), each.text());
    }
  }

  /** Where the class stands. */
  Path file() {
    return MAIN.resolve(className() + ".java");
  }

  private String className() {
    return name().charAt(0) + name().substring(1).toLowerCase(Locale.ROOT) + "Sums";
  }

  /** What it says. */
  String text() {
    return FILE.replace("KERNEL", kernel)
        .replace("NAME", className())
        .replace("LOOPED", (common + shape).indent(2))
        .replace("LAST", common + shape)
        .replace("UNIFORM", uniform())
        .replace("ARITHMETIC", walled("arithmetic", "mu"))
        .replace("HARMONIC", walled("harmonic", "constant(4).div(mu)"))
        .replace("constant(", "DoubleVector.broadcast(QUAD, ");
  }

  private String uniform() {
    return force("uniform", DRAG, ADD, "twiceViscosity")
        .replace("PLANES", "")
        .replace("SPLIT", "")
        .replace("REST", "")
        .replace(
            "CONSTANTS",
            "    DoubleVector volume = constant(twiceViscosity * v[volumes + own]);\n");
  }

  private String walled(String name, String pair) {
    return force(name, DRAG_AT_WALLS.replace("PAIR", pair), ADD_AT_WALLS, "nearness", "wallFactor")
        .replace("SPLIT", SPLIT_AT_WALLS)
        .replace("REST", REST_AT_WALLS)
        .replace(
            "PLANES",
            """
                int viscosities = VISCOSITY * stride;
                int depths = DEPTH * stride;
            """)
        .replace(
            "CONSTANTS",
            """
                DoubleVector volume = constant(v[volumes + own]);
                DoubleVector viscosity = constant(v[viscosities + own]);
                DoubleVector near = constant(nearness);
                DoubleVector most = constant(wallFactor);
                DoubleVector zero = constant(0);
            """);
  }

  private String force(String name, String drag, String add, String... last) {
    String step = STEP.replace("SLOPE", common + slope).replace("DRAG", drag).replace("ADD", add);
    return FORCE
        .replace("METHOD", name)
        .replace("PARAMETERS", parameters(last))
        .replace("LOOPED", step.indent(2))
        .replace("STEP", step);
  }

  private static String parameters(String... last) {
    String first = "double[] v, int stride, int own, char[] quads, int from, int to";
    String all = first + ", double " + String.join(", double ", last);
    return all.length() + 6 <= 100 ? "      " + all : "      " + all.replace(", ", ",\n      ");
  }
}
