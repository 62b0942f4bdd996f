package org.hdispatch.lbm.vector;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hdispatch.lbm.Equilibrium;
import org.hdispatch.lbm.VelocitySet;

/**
 * Writes the fast kernels from the lattice's table: the formulas of the reference kernel,
 * straight-line. Those of this module do whole vectors of nodes; those of {@code lbm} do node by
 * node, on any JVM, and here what is left over.
 *
 * <p>{@code main} writes the files; {@code KernelSourceTest} compares them with what this class
 * writes.
 */
final class KernelSource {
  private static final Path MAIN = Path.of("src/main/java/org/hdispatch/lbm");

  private final VelocitySet set;
  private final boolean quadratic;
  private final boolean vectors; // else node by node
  private final StringBuilder text = new StringBuilder();
  private String margin = "";
  private String type; // of a number: "double" or "float"
  private String out; // arrays written to: "in" in place, else "out"

  private KernelSource(VelocitySet set, Equilibrium equilibrium, boolean vectors) {
    this.set = set;
    this.vectors = vectors;
    quadratic = equilibrium == Equilibrium.QUADRATIC;
  }

  /** Writes all kernels; to be run in the folder of this module. */
  public static void main(String[] none) throws IOException {
    for (VelocitySet set : VelocitySet.values()) {
      for (Map.Entry<Path, String> file : files(set).entrySet()) {
        Files.writeString(file.getKey(), file.getValue());
      }
    }
  }

  /** Source text of the kernels of a lattice, by file. */
  static Map<Path, String> files(VelocitySet set) {
    Map<Path, String> files = new LinkedHashMap<>();
    for (Equilibrium equilibrium : Equilibrium.values()) {
      String name = set + (equilibrium == Equilibrium.QUADRATIC ? "Quadratic" : "Linear");
      files.put(
          Path.of("../lbm").resolve(MAIN).resolve("Scalar" + name + ".java"),
          new KernelSource(set, equilibrium, false).scalar("Scalar" + name));
      files.put(
          MAIN.resolve("vector").resolve("Vector" + name + ".java"),
          new KernelSource(set, equilibrium, true).vector("Vector" + name));
    }
    return files;
  }

  private String scalar(String name) {
    line("package org.hdispatch.lbm;");
    line("");
    line("/** " + title() + ", node by node. Written by KernelSource: do not edit. */");
    open("final class " + name + " implements CollisionKernel");
    line("private final CollisionCoefficients c;");
    line("");
    open(name + "(CollisionCoefficients coefficients)");
    line("c = coefficients;");
    close();
    for (String each : List.of("double", "float")) {
      type = each;
      out = "out";
      line("");
      line("@Override");
      line("public void collide(");
      open("    " + places() + ", int n, int rows, int pitch)");
      loops("1");
      close();
    }
    close();
    return text.toString();
  }

  private String vector(String name) {
    line("package org.hdispatch.lbm.vector;");
    line("");
    line("import jdk.incubator.vector.DoubleVector;");
    line("import jdk.incubator.vector.FloatVector;");
    line("import jdk.incubator.vector.VectorSpecies;");
    line("import org.hdispatch.lbm.CollisionCoefficients;");
    line("");
    line("/** " + title() + ". Written by KernelSource: do not edit. */");
    open("final class " + name + " extends VectorKernel");
    line("private static final VectorSpecies<Double> DOUBLES = VectorKernel.DOUBLES;");
    line("private static final VectorSpecies<Float> FLOATS = VectorKernel.FLOATS;");
    line("");
    line("private final CollisionCoefficients c;");
    line("");
    open(name + "(CollisionCoefficients coefficients)");
    line("super(coefficients);");
    line("c = coefficients;");
    close();
    for (String each : List.of("double", "float")) {
      type = each;
      out = "in";
      line("");
      line("@Override");
      open("void inPlace(" + type + "[][] in, int[] inAt, int n, int rows, int pitch)");
      loops(species() + ".length()");
      close();
    }
    close();
    return text.toString();
  }

  private String title() {
    return set + ", " + (quadratic ? "quadratic" : "linear") + " equilibrium";
  }

  private String places() {
    return type + "[][] in, int[] inAt, " + type + "[][] out, int[] outAt";
  }

  private String species() {
    return type.equals("double") ? "DOUBLES" : "FLOATS";
  }

  private String vectorType() {
    return type.equals("double") ? "DoubleVector" : "FloatVector";
  }

  private void loops(String step) {
    constants();
    open("for (int row = 0, first = 0; row < rows; row++, first += pitch)");
    open("for (int k = first; k < first + n; " + (step.equals("1") ? "k++" : "k += " + step) + ")");
    node();
    close();
    close();
  }

  private void constants() {
    for (String rows : out.equals("in") ? List.of("in") : List.of("in", "out")) {
      for (int i = 0; i < set.size(); i++) {
        line("final " + type + "[] " + rows + i + " = " + rows + "[" + i + "];");
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
    String own = type.equals("double") ? value : "(float) " + group(value);
    if (vectors) {
      String broadcast = vectorType() + ".broadcast(" + species() + ", " + own + ")";
      line("final " + vectorType() + " " + name + " = " + broadcast + ";");
    } else {
      line("final " + type + " " + name + " = " + own + ";");
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
    line((vectors ? vectorType() : type) + " " + name + " = " + expression + ";");
    return name;
  }

  private String load(int i) {
    String place = "in" + i + ", inAt" + i + " + k";
    if (!vectors) {
      return "in" + i + "[inAt" + i + " + k]";
    }
    return vectorType() + ".fromArray(" + species() + ", " + place + ")";
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
    return a.contains(" ") && !a.startsWith("Math") ? "(" + a + ")" : a;
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
