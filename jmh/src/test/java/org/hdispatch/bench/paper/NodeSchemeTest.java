package org.hdispatch.bench.paper;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.Consumer;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.lbm.BodyForce;
import org.hdispatch.lbm.BundleSize;
import org.hdispatch.lbm.Collision;
import org.hdispatch.lbm.Equilibrium;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.Relaxation;
import org.hdispatch.lbm.Streaming;
import org.hdispatch.lbm.VelocitySet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** A baseline that computed another flow would be worth nothing. */
class NodeSchemeTest {
  private static final int NX = 9;
  private static final int NY = 7;
  private static final int NZ = 11;
  private static final int STEPS = 31; // odd: the other copy
  private static final Lattice DUCT =
      Lattice.empty(NX, NY, NZ, Ends.PERIODIC, Ends.OPEN, Ends.OPEN);
  private static final Relaxation RELAXATION = Relaxation.trt(0.8);
  private static final BodyForce FORCE = new BodyForce(1e-4, 3e-5, -2e-5);

  private static NodeScheme nodes(VelocitySet set, Streaming streaming, NodeLayout layout) {
    Collision collision = new Collision(set, RELAXATION, Equilibrium.QUADRATIC, FORCE);
    return new NodeScheme(DUCT, collision, BundleSize.cube(4), streaming, layout);
  }

  private static LbmScheme flat(VelocitySet set, Streaming streaming) {
    return LbmScheme.on(DUCT)
        .velocitySet(set)
        .relaxation(RELAXATION)
        .force(FORCE)
        .bundleSize(BundleSize.cube(5))
        .streaming(streaming)
        .build();
  }

  private static void run(Scheme<?, ?> scheme) {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      dispatcher.loop(scheme).run(STEPS);
    }
  }

  /** Density and velocity of every node by its place. */
  private static double[] state(Consumer<LbmScheme.NodeVisitor> forEachNode) {
    double[] state = new double[4 * NX * NY * NZ];
    forEachNode.accept(
        (x, y, z, density, ux, uy, uz) -> {
          int at = 4 * (x + NX * (y + NY * z));
          state[at] = density;
          state[at + 1] = ux;
          state[at + 2] = uy;
          state[at + 3] = uz;
        });
    return state;
  }

  @ParameterizedTest
  @CsvSource({"D3Q15, PULL", "D3Q15, PUSH", "D3Q19, PULL", "D3Q19, PUSH"})
  void sameBitsAsTheFlatBundles(VelocitySet set, Streaming streaming) {
    LbmScheme flat = flat(set, streaming);
    double[] rest = state(flat::forEachNode);
    run(flat);
    double[] expected = state(flat::forEachNode);
    int centre = 4 * (NX / 2 + NX * (NY / 2 + NY * (NZ / 2)));
    assertTrue(expected[centre + 1] > 1e-4, "flows: ux=" + expected[centre + 1]);
    for (NodeLayout layout : NodeLayout.values()) {
      NodeScheme nodes = nodes(set, streaming, layout);
      assertEquals(flat.nodes(), nodes.nodes());
      assertArrayEquals(rest, state(nodes::forEachNode), layout + " at rest");
      run(nodes);
      assertArrayEquals(expected, state(nodes::forEachNode), layout::toString);
    }
  }

  @ParameterizedTest
  @EnumSource(names = "IN_PLACE", mode = EnumSource.Mode.EXCLUDE)
  void sameBitsWithoutTheDispatcher(Streaming streaming) {
    NodeScheme dispatched = nodes(VelocitySet.D3Q15, streaming, NodeLayout.DICTIONARY);
    run(dispatched);
    NodeScheme alone = nodes(VelocitySet.D3Q15, streaming, NodeLayout.DICTIONARY);
    for (int step = 0; step < STEPS; step++) {
      alone.stepAlone();
    }
    assertArrayEquals(state(dispatched::forEachNode), state(alone::forEachNode));
  }

  @Test
  void refusesToStreamInPlace() {
    assertThrows(
        IllegalArgumentException.class,
        () -> nodes(VelocitySet.D3Q15, Streaming.IN_PLACE, NodeLayout.DICTIONARY));
  }
}
