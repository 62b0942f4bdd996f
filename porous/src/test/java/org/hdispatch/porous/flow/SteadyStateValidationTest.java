package org.hdispatch.porous.flow;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.PoreSpace;
import org.hdispatch.porous.pore.RandomSpheres;
import org.hdispatch.porous.pore.SpherePacking;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** "Converged to the tolerance" is true: against runs to a tolerance a hundred times smaller. */
@Tag("validation")
class SteadyStateValidationTest {
  private static PoreSpace rubble(int n, double radius, double porosity, long seed) {
    return new RandomSpheres(radius, seed).poreSpace(n, porosity);
  }

  private static Map<String, PoreSpace> rocks() {
    Map<String, PoreSpace> rocks = new LinkedHashMap<>();
    for (double porosity : new double[] {0.15, 0.25, 0.4, 0.7}) {
      for (double radius : new double[] {4, 8}) {
        rocks.put(porosity + " of " + radius, rubble(40, radius, porosity, 2011));
      }
    }
    rocks.put("tight", rubble(48, 3, 0.12, 7));
    rocks.put("spheres", SpherePacking.SC.poreSpace(32, 0.343));
    rocks.put("dense spheres", SpherePacking.FCC.poreSpace(32, 0.6));
    rocks.put("slit", PoreSpace.of(30, 9, 30, (x, y, z) -> y < 8));
    rocks.put(
        "two tubes",
        PoreSpace.of(
            24, 16, 40, (x, y, z) -> x > 1 && x < 14 && y > 1 && y < 14 || x == 18 && y == 8));
    PoreSpace matrix = rubble(40, 4, 0.2, 5);
    rocks.put("fracture", PoreSpace.of(40, 40, 40, (x, y, z) -> y == 20 || matrix.isPore(x, y, z)));
    return rocks;
  }

  @Test
  void trueErrorIsBelowTheTolerance() {
    List<String> wrong = new ArrayList<>();
    Map<String, Long> steps = new TreeMap<>();
    try (Dispatcher dispatcher = Dispatcher.builder().build()) {
      rocks()
          .forEach(
              (name, rock) -> {
                for (Axis axis : List.of(Axis.X, Axis.Z)) {
                  FlowOptions options = FlowOptions.DEFAULT.withAxis(axis);
                  SteadyFlow flow = solve(dispatcher, rock, options);
                  if (!flow.percolation().percolates()) {
                    continue;
                  }
                  double truth =
                      solve(dispatcher, rock, options.withTolerance(1e-5)).permeability();
                  double error = Math.abs(flow.permeability() / truth - 1);
                  String text = name + " along " + axis;
                  steps.put(text, flow.work().steps());
                  if (!flow.converged() || error > options.tolerance()) {
                    wrong.add(text + ": " + error + " after " + flow.work().steps());
                  }
                  SteadyFlow plain = solve(dispatcher, rock, options.withApproach(Approach.PLAIN));
                  double plainError = Math.abs(plain.permeability() / truth - 1);
                  if (!plain.converged() || plainError > options.tolerance()) {
                    wrong.add(text + ", plain: " + plainError + " after " + plain.work().steps());
                  }
                }
              });
    }
    assertTrue(wrong.isEmpty(), wrong + " of " + steps);
    assertTrue(steps.size() >= 20, "cases that percolate: " + steps);
    List<Long> sorted = steps.values().stream().sorted().toList();
    assertTrue(sorted.get(sorted.size() / 2) <= 300, "steps: " + steps);
  }

  private static SteadyFlow solve(Dispatcher dispatcher, PoreSpace rock, FlowOptions options) {
    return LbmFlow.solve(dispatcher, rock, options, FlowListener.NONE);
  }
}
