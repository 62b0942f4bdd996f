package org.hdispatch.sph;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class SavedStateTest {
  private static final SmoothingKernel KERNEL = new QuinticSpline(1, 2);
  private static final int LENGTH = 24;

  /** A drop on its way through a periodic channel: cells come and go, particles cross its ends. */
  private static SphSchemeBuilder drop(SearchMode mode) {
    return drop(mode, KERNEL);
  }

  private static SphSchemeBuilder drop(SearchMode mode, SmoothingKernel kernel) {
    EquationOfState state = EquationOfState.linear(1, 5, 2);
    Phase fluid = Phase.fluid("drop", 1, 0.3, state);
    return SphScheme.builder(ParticleBox.plane(LENGTH, LENGTH, Ends.PERIODIC, Ends.OPEN), kernel)
        .phase(fluid)
        .phase(Phase.wallOf(fluid))
        .walls((x, y, z) -> y - 4)
        .pairForces(MeanField.onLattice(kernel, 1, PairProfile.cosine()).drop(1, 90))
        .search(mode)
        .timeStep(0.02);
  }

  private static Particles particles(double speed) {
    Random random = new Random(5);
    Particles particles = new Particles();
    for (int j = 0; j < 4; j++) {
      for (int i = 0; i < LENGTH; i++) {
        particles.add(1, i + 0.5, j + 0.5, 0);
      }
    }
    for (int j = 4; j < 12; j++) {
      for (int i = 6; i < 16; i++) {
        double u = speed * (1 + 0.1 * random.nextDouble());
        particles.add(0, i + 0.5, j + 0.5, 0, u, 0.1 * random.nextDouble(), 0);
      }
    }
    return particles;
  }

  /** All that is shown, in the order in which it is. */
  private static double[] shown(SphScheme scheme) {
    List<Double> values = new ArrayList<>();
    scheme.forEachParticle(
        (id, phase, x, y, z, u, v, w, n, p) ->
            values.addAll(List.of((double) id, (double) phase, x, y, z, u, v, w, n, p)));
    values.add(scheme.fastest());
    double[] compression = scheme.compression();
    values.add(compression[0]);
    values.add(compression[1]);
    return values.stream().mapToDouble(value -> value).toArray();
  }

  private static byte[] saved(SphScheme scheme) throws IOException {
    ByteArrayOutputStream saved = new ByteArrayOutputStream();
    scheme.save(new DataOutputStream(saved));
    return saved.toByteArray();
  }

  private static void restore(SphScheme scheme, byte[] saved) throws IOException {
    scheme.restore(new DataInputStream(new ByteArrayInputStream(saved)));
  }

  @ParameterizedTest
  @EnumSource(SearchMode.class)
  void goesOnWithTheSameBits(SearchMode mode) throws IOException {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      for (int before : new int[] {0, 1, 201}) {
        SphScheme whole = drop(mode).build(particles(3));
        TimeLoop loop = dispatcher.loop(whole);
        loop.run(before);
        byte[] saved = saved(whole);
        SphScheme rest = drop(mode).build(particles(3));
        dispatcher.loop(rest).run(57); // cells are others than those of the state
        restore(rest, saved);
        assertArrayEquals(shown(whole), shown(rest));
        assertTrue(Double.isNaN(rest.neighboursMean())); // no step yet from here
        loop.run(150);
        dispatcher.loop(rest).run(150);
        assertArrayEquals(shown(whole), shown(rest));
        assertArrayEquals(saved(whole), saved(rest));
      }
    }
  }

  /** Lists that would have been kept are made anew, in the run that goes on as well. */
  @Test
  void savingMakesTheNextStepSearch() throws IOException {
    SphScheme scheme = drop(SearchMode.VERLET).build(particles(0));
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      TimeLoop loop = dispatcher.loop(scheme);
      loop.run(2);
      assertEquals(1, scheme.rebuilds());
      saved(scheme);
      loop.run(1);
      assertEquals(2, scheme.rebuilds());
    }
  }

  @Test
  void refusesTheStateOfAnotherScheme() throws IOException {
    byte[] saved = saved(drop(SearchMode.SINGLE).build(particles(1)));
    Particles more = particles(1).add(0, 12, 20, 0);
    for (SphScheme other :
        List.of(
            drop(SearchMode.SINGLE).build(more),
            drop(SearchMode.SINGLE).timeStep(0.01).build(particles(1)),
            drop(SearchMode.SINGLE).cellEdge(6).build(particles(1)))) {
      String message =
          assertThrows(IllegalArgumentException.class, () -> restore(other, saved)).getMessage();
      assertTrue(message.startsWith("state must be of the same box, cells, kernel"), message);
    }
    byte[] cubic = saved(drop(SearchMode.SINGLE, new CubicSpline(1.5, 2)).build(particles(1)));
    SphScheme wendland = drop(SearchMode.SINGLE, new WendlandC2(1.5, 2)).build(particles(1));
    assertThrows(IllegalArgumentException.class, () -> restore(wendland, cubic));
    SphScheme same = drop(SearchMode.SINGLE).build(particles(2)); // other velocities
    restore(same, saved);
    assertArrayEquals(shown(drop(SearchMode.SINGLE).build(particles(1))), shown(same));
  }

  @Test
  void refusesAStateThatEndsTooEarly() throws IOException {
    SphScheme scheme = drop(SearchMode.VERLET).build(particles(1));
    byte[] saved = saved(scheme);
    byte[] half = Arrays.copyOf(saved, saved.length / 2);
    assertThrows(EOFException.class, () -> restore(scheme, half));
  }
}
