package org.hdispatch.lbm;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Handout;
import org.hdispatch.dispatch.ScratchLifetime;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.gc.GcWatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class LbmSchemeTest {
  private static final int NX = 23;
  private static final int NY = 11;
  private static final int NZ = 14;

  /** Two thirds fluid, at random, periodic along x. */
  private static Lattice rubble() {
    boolean[] fluid = new boolean[NX * NY * NZ];
    Random random = new Random(1992);
    for (int n = 0; n < fluid.length; n++) {
      fluid[n] = random.nextInt(3) > 0;
    }
    return new Lattice(
        NX,
        NY,
        NZ,
        Ends.PERIODIC,
        Ends.OPEN,
        Ends.PERIODIC,
        (x, y, z) -> fluid[x + NX * (y + NY * z)]);
  }

  private static LbmSchemeBuilder flow(VelocitySet set, Equilibrium form) {
    return LbmScheme.on(rubble())
        .velocitySet(set)
        .equilibrium(form)
        .relaxation(Relaxation.trt(0.7))
        .force(new BodyForce(1e-4, -2e-5, 3e-5));
  }

  /** State of every node by its place, whatever the bundles. */
  private static double[] run(
      LbmScheme scheme, int workers, Handout handout, ScratchLifetime lifetime) {
    try (Dispatcher dispatcher = Dispatcher.builder().workers(workers).handout(handout).build()) {
      TimeLoop loop = dispatcher.loop(scheme, lifetime);
      loop.run(41);
      return state(scheme);
    }
  }

  private static double[] state(LbmScheme scheme) {
    double[] state = new double[4 * NX * NY * NZ];
    scheme.forEachNode(
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
  @EnumSource(Equilibrium.class)
  void sameBitsForAnyWorkersHandoutScratchAndBundleSize(Equilibrium form) {
    for (VelocitySet set : VelocitySet.values()) {
      double[] reference = run(flow(set, form).build(), 1, Handout.PULL, ScratchLifetime.ENDURING);
      for (int workers : new int[] {2, 3, 5}) {
        for (Handout handout : Handout.values()) {
          LbmScheme small = flow(set, form).bundleSize(BundleSize.cube(5)).build();
          assertArrayEquals(reference, run(small, workers, handout, ScratchLifetime.ENDURING));
        }
      }
      LbmScheme rows = flow(set, form).bundleSize(new BundleSize(64, 1, 3)).build();
      assertArrayEquals(reference, run(rows, 2, Handout.PULL, ScratchLifetime.PER_CELL));
      LbmScheme columns = flow(set, form).bundleSize(new BundleSize(1, 4, 2)).build();
      assertArrayEquals(reference, run(columns, 2, Handout.PULL, ScratchLifetime.PER_STEP));
    }
  }

  /** Each against the reference kernel on two lattices, odd sizes, walls, solids, periodic ends. */
  @ParameterizedTest
  @EnumSource(Storage.class)
  void sameBitsForAnyKernelAndStreaming(Storage storage) {
    for (VelocitySet set : VelocitySet.values()) {
      for (Equilibrium form : Equilibrium.values()) {
        LbmSchemeBuilder pull = flow(set, form).storage(storage).streaming(Streaming.PULL);
        double[] reference =
            run(
                disturbed(pull.kernel(KernelForm.REFERENCE)),
                1,
                Handout.PULL,
                ScratchLifetime.ENDURING);
        for (Streaming streaming : Streaming.values()) {
          for (KernelForm kernel : List.of(KernelForm.REFERENCE, KernelForm.SCALAR)) {
            for (BundleSize size : List.of(BundleSize.cube(6), new BundleSize(64, 3, 5))) {
              LbmSchemeBuilder other =
                  flow(set, form)
                      .storage(storage)
                      .streaming(streaming)
                      .kernel(kernel)
                      .bundleSize(size);
              assertArrayEquals(
                  reference,
                  run(disturbed(other), 2, Handout.PULL, ScratchLifetime.ENDURING),
                  () -> set + " " + form + " " + streaming + " " + kernel + " " + size);
            }
          }
        }
      }
    }
  }

  /** A random state, the same whatever the order of the nodes. */
  private static LbmScheme disturbed(LbmSchemeBuilder builder) {
    LbmScheme scheme = builder.build();
    scheme.initialise(
        (x, y, z, state) -> {
          Random random = new Random(x + 31L * (y + 31L * z));
          state.density = 1 + 0.02 * random.nextDouble();
          state.ux = 0.05 * random.nextDouble();
          state.uy = -0.04 * random.nextDouble();
          state.uz = 0.03 * random.nextDouble();
        });
    return scheme;
  }

  /** Sums, products and quotients only: IEEE 754 fixes every bit, on any JVM and processor. */
  @ParameterizedTest
  @CsvSource({
    "D3Q15, QUADRATIC, 1574054682",
    "D3Q15, LINEAR, -2006285166",
    "D3Q19, QUADRATIC, -826614961",
    "D3Q19, LINEAR, -1505265315"
  })
  void sameBitsOnEveryJvm(VelocitySet set, Equilibrium form, int hash) {
    double[] state = run(flow(set, form).build(), 2, Handout.PULL, ScratchLifetime.ENDURING);
    assertEquals(hash, Arrays.hashCode(state));
  }

  @ParameterizedTest
  @EnumSource(Equilibrium.class)
  void conservesMassUnderAForce(Equilibrium form) {
    LbmScheme scheme = flow(VelocitySet.D3Q19, form).build();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(scheme);
      loop.run(10_000);
      double mass = Flows.sum(scheme, loop, u -> u[3]);
      assertEquals(1, mass / scheme.nodes(), 1e-12);
    }
  }

  /** Without walls the fluid falls freely: u = g t, half the force accounted for. */
  @ParameterizedTest
  @EnumSource(Equilibrium.class)
  void freeFluidFallsLikeAStone(Equilibrium form) {
    Lattice box = Lattice.empty(4, 3, 5, Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC);
    BodyForce g = new BodyForce(1e-5, -2e-5, 4e-5);
    LbmScheme scheme = LbmScheme.on(box).equilibrium(form).force(g).build();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      TimeLoop loop = dispatcher.loop(scheme);
      for (int steps : new int[] {0, 1, 2, 100}) {
        loop.run(steps - loop.tick().step());
        scheme.forEachNode(
            (x, y, z, density, ux, uy, uz) -> {
              assertEquals(steps * g.x(), ux, 1e-15);
              assertEquals(steps * g.y(), uy, 1e-15);
              assertEquals(steps * g.z(), uz, 1e-15);
              assertEquals(1, density, 1e-14);
            });
      }
    }
  }

  /**
   * The even part of Guo's force: the second moment of uniform flow relaxes to uu, and the force
   * adds (1 - omega+/2)(uF + Fu), with the velocity halfway through the force.
   */
  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void forceAddsToTheMomentumFluxAsGuoHasIt(VelocitySet set) {
    double[] start = {0.02, -0.01, 0.03};
    double[] f = {1e-3, 2e-3, -1e-3};
    Lattice box = Lattice.empty(2, 2, 2, Ends.PERIODIC, Ends.PERIODIC, Ends.PERIODIC);
    LbmScheme scheme =
        LbmScheme.on(box)
            .velocitySet(set)
            .relaxation(Relaxation.trt(0.8))
            .streaming(Streaming.PULL)
            .force(new BodyForce(f[0], f[1], f[2]))
            .build();
    scheme.initialise(
        (x, y, z, state) -> {
          state.ux = start[0];
          state.uy = start[1];
          state.uz = start[2];
        });
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      TimeLoop loop = dispatcher.loop(scheme);
      loop.run(1);
      NodalBundle bundle = scheme.cells().cellAt(0);
      Populations populations = bundle.populations(loop.tick().previous());
      double omega = scheme.relaxation().omegaPlus();
      for (int a = 0; a < 3; a++) {
        for (int b = 0; b < 3; b++) {
          double flux = 0;
          for (int i = 0; i < set.size(); i++) {
            int[] c = {set.cx(i), set.cy(i), set.cz(i)};
            flux += c[a] * c[b] * populations.get(set.opposite(i), 0);
          }
          double ua = start[a] + f[a]; // half the force before, half the force after streaming
          double ub = start[b] + f[b];
          double before = start[a] * start[b];
          double expected =
              before - omega * (before - ua * ub) + (1 - omega / 2) * (ua * f[b] + f[a] * ub);
          assertEquals(expected, flux, 1e-16);
        }
      }
    }
  }

  /** Wherever the populations stand: in each streaming, after none, one, two and three steps. */
  @ParameterizedTest
  @EnumSource(Storage.class)
  void addsDensityAndMomentumBetweenSteps(Storage storage) {
    double within = storage == Storage.DOUBLE ? 1e-15 : 1e-8; // 2^-24 of populations near 1e-2
    for (Streaming streaming : Streaming.values()) {
      LbmScheme scheme =
          disturbed(
              flow(VelocitySet.D3Q19, Equilibrium.QUADRATIC)
                  .streaming(streaming)
                  .storage(storage)
                  .bundleSize(BundleSize.cube(6)));
      LbmScheme.Scratch scratch = scheme.newScratch();
      try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
        TimeLoop loop = dispatcher.loop(scheme);
        for (int steps = 0; steps < 4; steps++) {
          double[] before = state(scheme);
          for (int n = 0; n < scheme.cells().size(); n++) {
            scheme.add(
                scheme.cells().cellAt(n),
                scratch,
                (x, y, z, change) -> {
                  change.density = 1e-4 * x;
                  change.ux = 2e-4 * y;
                  change.uy = -1e-4 * z;
                  change.uz = 3e-4;
                });
          }
          scheme.forEachNode(
              (x, y, z, density, ux, uy, uz) -> {
                int at = 4 * (x + NX * (y + NY * z));
                assertEquals(before[at] + 1e-4 * x, density, within);
                assertEquals(before[at + 1] + 2e-4 * y, ux, within);
                assertEquals(before[at + 2] - 1e-4 * z, uy, within);
                assertEquals(before[at + 3] + 3e-4, uz, within);
              });
          loop.run(1);
        }
      }
    }
  }

  /** After an even and an odd number of steps, in both phases of the pattern in place. */
  @ParameterizedTest
  @CsvSource({"40", "41"})
  void goesOnFromASavedStateWithTheSameBits(int steps) throws IOException {
    BundleSize size = BundleSize.cube(6);
    for (Streaming before : Streaming.values()) {
      for (Streaming after : Streaming.values()) {
        LbmScheme whole =
            disturbed(
                flow(VelocitySet.D3Q19, Equilibrium.QUADRATIC).streaming(before).bundleSize(size));
        LbmScheme rest =
            flow(VelocitySet.D3Q19, Equilibrium.QUADRATIC)
                .streaming(after)
                .bundleSize(size)
                .build();
        try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
          TimeLoop loop = dispatcher.loop(whole);
          loop.run(steps);
          byte[] saved = saved(whole);
          loop.run(7);
          restore(rest, saved);
          dispatcher.loop(rest).run(7);
          assertArrayEquals(state(whole), state(rest), before + " " + after);
        }
      }
    }
  }

  @ParameterizedTest
  @EnumSource(Storage.class)
  void isMadeAtRestHalfwayThroughTheForce(Storage storage) throws IOException {
    double roundOff = storage == Storage.DOUBLE ? 1e-19 : 1e-11; // of populations of 1e-5
    for (Streaming streaming : Streaming.values()) {
      LbmScheme scheme =
          flow(VelocitySet.D3Q19, Equilibrium.QUADRATIC)
              .storage(storage)
              .streaming(streaming)
              .build();
      byte[] made = saved(scheme);
      scheme.forEachNode(
          (x, y, z, density, ux, uy, uz) -> {
            assertEquals(1, density, roundOff);
            assertEquals(0, ux, roundOff);
            assertEquals(0, uy, roundOff);
            assertEquals(0, uz, roundOff);
          });
      scheme.initialise((x, y, z, state) -> {});
      assertArrayEquals(saved(scheme), made);
    }
  }

  @ParameterizedTest
  @EnumSource(Streaming.class)
  void isTheSameWhoeverMakesIt(Streaming streaming) throws IOException {
    LbmSchemeBuilder builder =
        flow(VelocitySet.D3Q19, Equilibrium.LINEAR)
            .streaming(streaming)
            .symmetryFaces(1)
            .bundleSize(BundleSize.cube(5));
    LbmScheme alone = builder.build();
    double[] reference = run(alone, 1, Handout.PULL, ScratchLifetime.ENDURING);
    for (int workers = 1; workers <= 3; workers++) {
      try (Dispatcher dispatcher = Dispatcher.withWorkers(workers)) {
        LbmScheme scheme = builder.build(dispatcher);
        assertEquals(alone.bytes(), scheme.bytes());
        assertArrayEquals(saved(builder.build()), saved(scheme));
        assertArrayEquals(reference, run(scheme, 2, Handout.PULL, ScratchLifetime.ENDURING));
      }
    }
  }

  @Test
  void refusesAnInitialStateThatIsNone() {
    LbmScheme scheme = LbmScheme.on(Flows.duct(3)).build();
    IllegalArgumentException e =
        assertThrows(
            IllegalArgumentException.class,
            () -> scheme.initialise((x, y, z, state) -> state.density = y == 1 ? 0 : 1));
    assertEquals(
        "initial density must be positive and velocity finite:"
            + " node=(0, 1, 0), density=0.0, ux=0.0, uy=0.0, uz=0.0",
        e.getMessage());
    assertThrows(
        IllegalArgumentException.class,
        () -> scheme.initialise((x, y, z, state) -> state.density = Double.NaN));
    assertThrows(
        IllegalArgumentException.class,
        () -> scheme.initialise((x, y, z, state) -> state.uz = Double.NaN));
  }

  private static byte[] saved(LbmScheme scheme) throws IOException {
    ByteArrayOutputStream saved = new ByteArrayOutputStream();
    scheme.save(new DataOutputStream(saved));
    return saved.toByteArray();
  }

  private static void restore(LbmScheme scheme, byte[] saved) throws IOException {
    scheme.restore(new DataInputStream(new ByteArrayInputStream(saved)));
  }

  @Test
  void takesUpTheStateOfAnotherStorage() throws IOException {
    for (BundleSize size : List.of(BundleSize.cube(6), new BundleSize(64, 3, 5))) {
      LbmSchemeBuilder builder = flow(VelocitySet.D3Q15, Equilibrium.LINEAR).bundleSize(size);
      LbmScheme single = disturbed(builder.storage(Storage.SINGLE));
      LbmScheme wide = builder.storage(Storage.DOUBLE).build();
      restore(wide, saved(single));
      assertArrayEquals(state(single), state(wide));
    }
  }

  /** All of the same number of nodes, at the same positions of one bundle. */
  @Test
  void refusesTheStateOfOtherNodesAndLattices() throws IOException {
    Lattice box = Lattice.empty(6, 6, 1, Ends.OPEN, Ends.OPEN, Ends.OPEN);
    byte[] saved = saved(LbmScheme.on(box).build());
    for (Lattice other :
        List.of(
            Lattice.empty(6, 1, 6, Ends.OPEN, Ends.OPEN, Ends.OPEN),
            Lattice.empty(6, 6, 1, Ends.OPEN, Ends.PERIODIC, Ends.OPEN),
            new Lattice(6, 7, 1, Ends.OPEN, Ends.OPEN, Ends.OPEN, (x, y, z) -> y < 6),
            new Lattice(6, 7, 1, Ends.OPEN, Ends.OPEN, Ends.OPEN, (x, y, z) -> y > 0))) {
      LbmScheme scheme = LbmScheme.on(other).build();
      assertThrows(IllegalArgumentException.class, () -> restore(scheme, saved), other::toString);
    }
    LbmScheme cut = LbmScheme.on(box).bundleSize(BundleSize.cube(3)).build();
    assertThrows(IllegalArgumentException.class, () -> restore(cut, saved));
    LbmScheme corners = LbmScheme.on(box).velocitySet(VelocitySet.D3Q15).build();
    assertThrows(IllegalArgumentException.class, () -> restore(corners, saved));
    restore(LbmScheme.on(box).build(), saved);
  }

  @Test
  void makesNoBundleOfSolidNodesOnly() {
    Lattice half =
        new Lattice(16, 16, 16, Ends.OPEN, Ends.OPEN, Ends.OPEN, (x, y, z) -> x < 4 && y == 9);
    LbmScheme scheme = LbmScheme.on(half).bundleSize(BundleSize.cube(4)).build();
    assertEquals(4, scheme.cells().size());
    assertEquals(4 * 16, scheme.nodes());
    for (int n = 0; n < 4; n++) {
      assertEquals(0, CellKey.i(scheme.cells().keyAt(n)));
      assertEquals(2, CellKey.j(scheme.cells().keyAt(n)));
    }
  }

  @Test
  void bundlesKnowWhereTheirNodesLie() {
    LbmScheme scheme = LbmScheme.on(rubble()).bundleSize(new BundleSize(7, 4, 5)).build();
    Lattice lattice = rubble();
    List<Integer> seen = new ArrayList<>();
    for (int n = 0; n < scheme.cells().size(); n++) {
      NodalBundle bundle = scheme.cells().cellAt(n);
      for (int node = 0; node < bundle.nodes(); node++) {
        assertTrue(lattice.fluid(bundle.x(node), bundle.y(node), bundle.z(node)));
        assertEquals(0, (bundle.x(node) - bundle.first(0)) / bundle.extent(0));
        assertEquals(0, (bundle.y(node) - bundle.first(1)) / bundle.extent(1));
        assertEquals(0, (bundle.z(node) - bundle.first(2)) / bundle.extent(2));
        seen.add(bundle.x(node) + NX * (bundle.y(node) + NY * bundle.z(node)));
      }
    }
    int fluid = 0;
    for (int n = 0; n < NX * NY * NZ; n++) {
      fluid += lattice.fluid(n % NX, n / NX % NY, n / (NX * NY)) ? 1 : 0;
    }
    assertEquals(fluid, scheme.nodes());
    assertEquals(fluid, seen.size());
    assertEquals(fluid, seen.stream().distinct().count());
  }

  @ParameterizedTest
  @EnumSource(Equilibrium.class)
  void tenThousandStepsAllocateNothingAndCollectNothing(Equilibrium form) {
    LbmScheme scheme = flow(VelocitySet.D3Q19, form).bundleSize(BundleSize.cube(6)).build();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2);
        GcWatch watch = GcWatch.start()) {
      TimeLoop loop = dispatcher.loop(scheme);
      loop.run(3_000);
      watch.mark();
      assertTrue(loop.warmUp(10_000, 4), () -> loop.stats().toString());
      assertEquals(0, watch.stop().get(1).collections());
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {Float.BYTES, Double.BYTES})
  void paddedRowsStartAtDifferentPlacesOfAPage(int bytes) {
    for (int nodes = 1; nodes < 5_000; nodes++) {
      int place = Populations.paddedLength(nodes, bytes) * bytes % 4096;
      assertTrue(place >= 200 && place <= 4096 - 200, "nodes=" + nodes + ", place=" + place);
    }
  }

  @Test
  void refusesForcesThatAreNotFinite() {
    assertThrows(IllegalArgumentException.class, () -> new BodyForce(Double.NaN, 0, 0));
  }
}
