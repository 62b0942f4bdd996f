package org.hdispatch.example;

import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.poisson.ConjugateGradients;
import org.hdispatch.poisson.Convergence;
import org.hdispatch.poisson.PoissonProblem;
import org.hdispatch.poisson.Side;

/** Poisson's equation between two plates: a channel with even sources, whose p is a parabola. */
public final class Chamber {
  private Chamber() {}

  public static void main(String[] args) {
    int n = 64;
    PoissonProblem problem =
        PoissonProblem.box(n, n, n)
            .ends(Ends.PERIODIC, Ends.PERIODIC, Ends.OPEN)
            .fixed(Side.Z_FIRST, 0)
            .fixed(Side.Z_LAST, 0)
            .build();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      ConjugateGradients solver = ConjugateGradients.on(dispatcher, problem);
      solver.addSources((x, y, z) -> 1);
      Convergence end = solver.solve(1e-8, 50);
      double middle = solver.value(n / 2, n / 2, n / 2);
      System.out.printf("p in the middle: %.3f, %s%n", middle, end);
      if (!end.converged() || Math.abs(middle - n * n / 8.0) > 1) {
        throw new AssertionError("p must be z (n - z) / 2"); // at z = n / 2, to half a spacing
      }
    }
  }
}
