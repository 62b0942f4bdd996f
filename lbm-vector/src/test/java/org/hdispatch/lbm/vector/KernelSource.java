package org.hdispatch.lbm.vector;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hdispatch.lbm.Equilibrium;
import org.hdispatch.lbm.VelocitySet;

/**
 * Writes the kernels from the lattice's table: the formulas of the reference kernel, straight-line,
 * once with vectors and once for the nodes that are left over.
 *
 * <p>{@code main} writes the files; {@code KernelSourceTest} compares them with what this class
 * writes.
 */
final class KernelSource {
  private final VelocitySet set;
  private final boolean quadratic;
  private final StringBuilder text = new StringBuilder();
  private String margin = "";
  private boolean vectors; // else single nodes
  private String out; // arrays written to: "in" in place, else "out"

  private KernelSource(VelocitySet set, Equilibrium equilibrium) {
    this.set = set;
    quadratic = equilibrium == Equilibrium.QUADRATIC;
  }

  /**
   * Writes all kernels.
   *
   * @param folder of the sources of the package
   */
  public static void main(String[] folder) throws IOException {
    for (VelocitySet set : VelocitySet.values()) {
      for (Equilibrium equilibrium : Equilibrium.values()) {
        Path file = Path.of(folder[0]).resolve(className(set, equilibrium) + ".java");
        Files.writeString(file, of(set, equilibrium));
      }
    }
  }

  static String className(VelocitySet set, Equilibrium equilibrium) {
    return set + (equilibrium == Equilibrium.QUADRATIC ? "Quadratic" : "Linear") + "Kernel";
  }

  /** Source text of the kernel of a lattice and an equilibrium. */
  static String of(VelocitySet set, Equilibrium equilibrium) {
    return new KernelSource(set, equilibrium).write(className(set, equilibrium));
  }

  private String write(String name) {
    line("package org.hdispatch.lbm.vector;");
    line("");
    line("import jdk.incubator.vector.DoubleVector;");
    line("import jdk.incubator.vector.VectorSpecies;");
    line("import org.hdispatch.lbm.CollisionCoefficients;");
    line("");
    String form = quadratic ? "quadratic" : "linear";
    line("/** " + set + ", " + form + " equilibrium. Written by KernelSource: do not edit. */");
    open("final class " + name + " extends VectorKernel");
    line("private static final VectorSpecies<Double> DOUBLES = Lanes.DOUBLES;");
    line("");
    line("private final CollisionCoefficients c;");
    line("");
    open(name + "(CollisionCoefficients coefficients)");
    line("super(coefficients.set());");
    line("c = coefficients;");
    close();
    line("");
    methods();
    close();
    return text.toString();
  }

  private void methods() {
    String arrays = "double[][] ";
    String places = arrays + "in, int[] inAt, " + arrays + "out, int[] outAt, ";
    line("@Override");
    line("public void collide(");
    open("    " + places + "int n, int rows, int pitch)");
    line("int whole = DOUBLES.loopBound(n);");
    open("if (in == out && inAt == outAt)");
    line("inPlace(in, inAt, whole, rows, pitch);");
    margin = margin.substring(2);
    open("} else");
    line("apart(in, inAt, out, outAt, whole, rows, pitch);");
    close();
    open("if (whole < n)");
    line("rest(in, inAt, out, outAt, n, rows, pitch);");
    close();
    close();
    line("");
    vectors = true;
    out = "in";
    open("private void inPlace(" + arrays + "in, int[] inAt, int n, int rows, int pitch)");
    loops("0", "n", "DOUBLES.length()");
    close();
    line("");
    out = "out";
    line("private void apart(");
    open("    " + places + "int n, int rows, int pitch)");
    loops("0", "n", "DOUBLES.length()");
    close();
    line("");
    vectors = false;
    line("private void rest(");
    open("    " + places + "int n, int rows, int pitch)");
    line("final int done = DOUBLES.loopBound(n);");
    loops("done", "n", "1");
    close();
  }

  private void loops(String from, String to, String step) {
    constants();
    open("for (int row = 0, first = 0; row < rows; row++, first += pitch)");
    String begin = from.equals("0") ? "first" : "first + " + from;
    String next = step.equals("1") ? "k++" : "k += " + step;
    open("for (int k = " + begin + "; k < first + " + to + "; " + next + ")");
    node();
    close();
    close();
  }

  private void constants() {
    for (String rows : out.equals("in") ? List.of("in") : List.of("in", "out")) {
      for (int i = 0; i < set.size(); i++) {
        line("final double[] " + rows + i + " = " + rows + "[" + i + "];");
        line("final int " + rows + "At" + i + " = " + rows + "At[" + i + "];");
      }
    }
    constant("keepRest", "c.keepRest");
    constant("keep", "c.keep");
    constant("cross", "c.cross");
    for (String axis : List.of("X", "Y", "Z")) {
      constant("half" + axis, "c.force" + axis + "() / 2");
    }
    if (quadratic) {
      for (String name : List.of("omegaPlus", "curvature", "squares", "work")) {
        constant(name, "c." + name);
      }
      for (String axis : List.of("X", "Y", "Z")) {
        constant("force" + axis, "c.force" + axis + "()");
      }
      constant("one", "1");
    }
    for (int p = 0; p <= set.pairs(); p++) {
      if (first(p) == p) {
        constant("even" + p, "c.even[" + p + "]");
        if (p > 0) {
          constant("odd" + p, "c.odd[" + p + "]");
        }
      }
    }
    for (int p = 1; p <= set.pairs(); p++) {
      constant("push" + p, "c.push[" + p + "]");
      if (quadratic) {
        constant("along" + p, "c.along[" + p + "]");
      }
    }
  }

  private void constant(String name, String value) {
    if (vectors) {
      line("final DoubleVector " + name + " = DoubleVector.broadcast(DOUBLES, " + value + ");");
    } else {
      line("final double " + name + " = " + value + ";");
    }
  }

  /** The first pair with the weight of this one. */
  private int first(int p) {
    int first = p;
    for (int q = 1; q < p && first == p; q++) {
      first = set.weight(2 * q) == set.weight(2 * p) ? q : p;
    }
    return first;
  }

  private void node() {
    for (int i = 0; i < set.size(); i++) {
      value("f" + i, load(i));
    }
    String density = "f0";
    String[] momentum = {"halfX", "halfY", "halfZ"};
    for (int p = 1; p <= set.pairs(); p++) {
      int i = 2 * p - 1;
      value("dif" + p, subtract("f" + i, "f" + (i + 1)));
      density = value("d" + p, add(density, add("f" + i, "f" + (i + 1))));
      for (int axis : set.axes(i)) {
        String j = "j" + "xyz".charAt(axis);
        String dif = "dif" + p;
        boolean positive = set.component(i, axis) > 0;
        momentum[axis] =
            value(j + p, positive ? add(momentum[axis], dif) : subtract(momentum[axis], dif));
      }
    }
    if (quadratic) {
      moments(density, momentum);
    }
    String form = quadratic ? "base" : density;
    store(0, fma("keepRest", "f0", multiply("even0", form)));
    for (int p = 1; p <= set.pairs(); p++) {
      pair(p, form, momentum);
    }
  }

  private void moments(String density, String[] j) {
    value("v", divide("one", add("one", density)));
    value("jj2", fma(j[1], j[1], multiply(j[2], j[2])));
    value("jj", fma(j[0], j[0], "jj2"));
    value("jf2", fma("forceY", j[1], multiply("forceZ", j[2])));
    value("jf", fma("forceX", j[0], "jf2"));
    value("bend", fma("squares", "jj", multiply("work", "jf")));
    value("base", fma("omegaPlus", density, multiply("v", "bend")));
  }

  private void pair(int p, String form, String[] momentum) {
    int i = 2 * p - 1;
    String along = project(p, i, momentum);
    String even;
    if (quadratic) {
      value("bend" + p, fma("curvature", along, "along" + p));
      value("form" + p, fma(multiply("v", along), "bend" + p, form));
      even = multiply("even" + first(p), "form" + p);
    } else {
      if (first(p) == p) {
        value("rise" + p, multiply("even" + p, form));
      }
      even = "rise" + first(p);
    }
    value("e" + p, even);
    value("o" + p, fma("odd" + first(p), along, "push" + p));
    String forth = "f" + i;
    String back = "f" + (i + 1);
    store(i, subtract(fma("keep", back, fma("cross", forth, "e" + p)), "o" + p));
    store(i + 1, add(fma("keep", forth, fma("cross", back, "e" + p)), "o" + p));
  }

  /** c . j over the components that are not 0, in order. */
  private String project(int p, int i, String[] momentum) {
    String sum = null;
    for (int axis : set.axes(i)) {
      boolean positive = set.component(i, axis) > 0;
      String j = momentum[axis];
      if (sum == null) {
        sum = positive ? j : negate(j);
      } else {
        sum = positive ? add(sum, j) : subtract(sum, j);
      }
    }
    return set.axes(i).length == 1 && sum.equals(momentum[set.axes(i)[0]])
        ? sum
        : value("cj" + p, sum);
  }

  private String value(String name, String expression) {
    line((vectors ? "DoubleVector " : "double ") + name + " = " + expression + ";");
    return name;
  }

  private String load(int i) {
    String place = "in" + i + ", inAt" + i + " + k";
    if (!vectors) {
      return "in" + i + "[inAt" + i + " + k]";
    }
    return "DoubleVector.fromArray(DOUBLES, " + place + ")";
  }

  private void store(int i, String expression) {
    String place = out + i + ", " + out + "At" + i + " + k";
    if (!vectors) {
      line(out + i + "[" + out + "At" + i + " + k] = " + expression + ";");
    } else {
      line(expression + ".intoArray(" + place + ");");
    }
  }

  private String add(String a, String b) {
    return vectors ? a + ".add(" + b + ")" : a + " + " + group(b);
  }

  private String subtract(String a, String b) {
    return vectors ? a + ".sub(" + b + ")" : a + " - " + group(b);
  }

  private String multiply(String a, String b) {
    return vectors ? a + ".mul(" + b + ")" : a + " * " + group(b);
  }

  private String divide(String a, String b) {
    return vectors ? a + ".div(" + b + ")" : a + " / " + group(b);
  }

  private String negate(String a) {
    return vectors ? a + ".neg()" : "-" + a;
  }

  private String fma(String a, String b, String c) {
    return vectors
        ? group(a) + ".fma(" + b + ", " + c + ")"
        : "Math.fma(" + a + ", " + b + ", " + c + ")";
  }

  private String group(String a) {
    return !vectors && a.contains(" ") && !a.startsWith("Math") ? "(" + a + ")" : a;
  }

  private void open(String head) {
    line(head + " {");
    margin += "  ";
  }

  private void close() {
    margin = margin.substring(2);
    line("}");
  }

  private void line(String content) {
    text.append(content.isEmpty() ? "" : margin + content).append('\n');
  }
}
