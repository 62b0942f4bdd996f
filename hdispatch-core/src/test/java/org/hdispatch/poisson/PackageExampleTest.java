package org.hdispatch.poisson;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hdispatch.dispatch.Dispatcher;
import org.junit.jupiter.api.Test;

/** The example in the package's javadoc. */
class PackageExampleTest {
  @Test
  void fallsFromTheFirstSideToTheLast() {
    double[] pressure = new double[48 * 48 * 48];
    // [JAVADOC
    PoissonProblem problem =
        PoissonProblem.box(48, 48, 48)
            .mobility((x, y, z) -> x * y * z % 7 == 1 ? 0 : 1) // 0: no node there
            .fixed(Side.Z_FIRST, 1)
            .fixed(Side.Z_LAST, 0)
            .build();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      ConjugateGradients solver = ConjugateGradients.on(dispatcher, problem);
      solver.addSources((x, y, z) -> z == 24 ? 1e-3 : 0);
      Convergence end = solver.solve(1e-8, 100);
      solver.forEachNode((x, y, z, p) -> pressure[x + 48 * (y + 48 * z)] = p);
      // JAVADOC]
      assertTrue(end.converged());
    }
    assertEquals(0, pressure[1 + 48 * (1 + 48)], "no node, nothing set");
    assertTrue(pressure[0] > pressure[48 * 48 * 20] && pressure[48 * 48 * 30] > pressure[110591]);
  }

  @Test
  void javadocShowsThisExample() throws IOException {
    String javadoc =
        Files.readString(Path.of("src/main/java/org/hdispatch/poisson/package-info.java"));
    String source =
        Files.readString(Path.of("src/test/java/org/hdispatch/poisson/PackageExampleTest.java"));
    String example =
        source.substring(source.indexOf("// [JAVADOC\n") + 11, source.indexOf("// JAVADOC]"));
    assertTrue(
        javadoc
            .replaceAll("\\n \\* ", "\n")
            .replaceAll("\\s", "")
            .contains(example.replaceAll("\\s", "")),
        "package-info must show the example as it is compiled here");
  }
}
