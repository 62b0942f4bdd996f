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
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.hdispatch.cell.Ends;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.TimeLoop;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class FacesTest {
  private static final int[] EXTENT = {11, 7, 9};
  private static final Ends[] OPEN = {Ends.OPEN, Ends.OPEN, Ends.OPEN};

  /** Three quarters fluid, at random. */
  private static boolean[] rubble() {
    boolean[] fluid = new boolean[EXTENT[0] * EXTENT[1] * EXTENT[2]];
    Random random = new Random(2008);
    for (int n = 0; n < fluid.length; n++) {
      fluid[n] = random.nextInt(4) > 0;
    }
    return fluid;
  }

  private static Lattice lattice(Ends... ends) {
    boolean[] fluid = rubble();
    return new Lattice(
        EXTENT[0],
        EXTENT[1],
        EXTENT[2],
        ends[0],
        ends[1],
        ends[2],
        (x, y, z) -> fluid[x + EXTENT[0] * (y + EXTENT[1] * z)]);
  }

  /** The rubble beside its mirror image along some axes, periodic along those. */
  private static Lattice mirrored(boolean... doubled) {
    boolean[] fluid = rubble();
    int[] n = new int[3];
    Ends[] ends = new Ends[3];
    for (int axis = 0; axis < 3; axis++) {
      n[axis] = doubled[axis] ? 2 * EXTENT[axis] : EXTENT[axis];
      ends[axis] = doubled[axis] ? Ends.PERIODIC : Ends.OPEN;
    }
    return new Lattice(
        n[0],
        n[1],
        n[2],
        ends[0],
        ends[1],
        ends[2],
        (x, y, z) -> fluid[fold(x, 0) + EXTENT[0] * (fold(y, 1) + EXTENT[1] * fold(z, 2))]);
  }

  private static int fold(int coordinate, int axis) {
    return coordinate < EXTENT[axis] ? coordinate : 2 * EXTENT[axis] - 1 - coordinate;
  }

  private static LbmSchemeBuilder stokes(Lattice lattice, VelocitySet set) {
    return LbmScheme.on(lattice)
        .velocitySet(set)
        .equilibrium(Equilibrium.LINEAR)
        .relaxation(Relaxation.trt(0.8));
  }

  private static BodyForce along(int axis, double g) {
    return new BodyForce(axis == 0 ? g : 0, axis == 1 ? g : 0, axis == 2 ? g : 0);
  }

  /** State {rho, ux, uy, uz} of the nodes of the rubble itself, by their places. */
  private static double[] state(LbmScheme scheme) {
    double[] state = new double[4 * EXTENT[0] * EXTENT[1] * EXTENT[2]];
    scheme.forEachNode(
        (x, y, z, density, ux, uy, uz) -> {
          if (x < EXTENT[0] && y < EXTENT[1] && z < EXTENT[2]) {
            int at = 4 * (x + EXTENT[0] * (y + EXTENT[1] * z));
            state[at] = density;
            state[at + 1] = ux;
            state[at + 2] = uy;
            state[at + 3] = uz;
          }
        });
    return state;
  }

  private static double[] run(LbmScheme scheme, int workers, int steps) {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(workers)) {
      dispatcher.loop(scheme).run(steps);
    }
    return state(scheme);
  }

  /** Where plates guide the flow, TRT at magic 3/16 is exact at the nodes, faces included. */
  @ParameterizedTest
  @CsvSource({"D3Q15, 0.6", "D3Q15, 1", "D3Q15, 3", "D3Q19, 0.6", "D3Q19, 1", "D3Q19, 3"})
  void pressureDropDrivesTheParabolaAndFallsLinearly(VelocitySet set, double tau) {
    int length = 12;
    int width = 9;
    double first = 1.001;
    double last = 0.999;
    LbmScheme scheme =
        stokes(Lattice.empty(length, width, 2, Ends.OPEN, Ends.OPEN, Ends.PERIODIC), set)
            .relaxation(Relaxation.trt(tau))
            .pressureFaces(0, first, last)
            .build();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      Flows.toSteadyState(dispatcher, scheme, 1e-12);
    }
    double nu = scheme.relaxation().viscosity();
    double gradient = (first - last) / (3 * length);
    double top = gradient * width * width / (8 * nu);
    scheme.forEachNode(
        (x, y, z, density, ux, uy, uz) -> {
          double fromWall = y + 0.5;
          double exact = gradient / (2 * nu) * fromWall * (width - fromWall);
          assertEquals(exact, ux, 1e-6 * top, "x=" + x + ", y=" + y);
          assertEquals(0, uy, 1e-9 * top);
          assertEquals(first + (last - first) * (x + 0.5) / length, density, 1e-12);
        });
  }

  /** In each step, not only in the end: the mirrored halves of a doubled lattice stay mirrored. */
  @ParameterizedTest
  @CsvSource({"D3Q15, 0", "D3Q15, 1", "D3Q15, 2", "D3Q19, 0", "D3Q19, 1", "D3Q19, 2"})
  void facesAreWhatAMirrorImageWouldBe(VelocitySet set, int axis) {
    int beside = (axis + 1) % 3;
    boolean[] doubled = new boolean[3];
    doubled[axis] = true;
    doubled[beside] = true;
    BodyForce force = along(axis, 1e-4);
    LbmScheme whole = stokes(mirrored(doubled), set).force(force).build();
    LbmScheme half =
        stokes(lattice(OPEN), set)
            .force(force)
            .pressureFaces(axis, 1, 1)
            .symmetryFaces(beside)
            .bundleSize(BundleSize.cube(4))
            .build();
    double[] exact = run(whole, 1, 300);
    assertTrue(Arrays.stream(exact).filter(u -> Math.abs(u) < 0.5).max().orElseThrow() > 1e-5);
    assertArrayEquals(exact, run(half, 1, 300), 1e-13);
  }

  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void symmetryFacesHoldForTheQuadraticEquilibriumToo(VelocitySet set) {
    BodyForce force = new BodyForce(2e-3, 0, 0);
    LbmScheme whole =
        LbmScheme.on(mirrored(false, true, true)).velocitySet(set).force(force).build();
    LbmScheme half =
        LbmScheme.on(lattice(OPEN))
            .velocitySet(set)
            .force(force)
            .symmetryFaces(1)
            .symmetryFaces(2)
            .build();
    assertArrayEquals(run(whole, 1, 200), run(half, 1, 200), 1e-12);
  }

  /** They differ by a linear pressure, which the linear equilibrium does not see. */
  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void forceAndPressureDropDriveTheSameFlow(VelocitySet set) {
    double g = 1e-5;
    double drop = 3 * g * EXTENT[2];
    LbmScheme pushed = stokes(lattice(OPEN), set).force(along(2, g)).pressureFaces(2, 1, 1).build();
    LbmScheme drawn =
        stokes(lattice(OPEN), set).pressureFaces(2, 1 + drop / 2, 1 - drop / 2).build();
    double[] byForce = run(pushed, 1, 6000);
    double[] byDrop = run(drawn, 1, 6000);
    double most = 0;
    for (int n = 0; n < byForce.length; n++) {
      most = Math.max(most, n % 4 == 0 ? 0 : Math.abs(byForce[n]));
    }
    for (int n = 0; n < byForce.length; n++) {
      int z = n / 4 / (EXTENT[0] * EXTENT[1]);
      double beside = n % 4 == 0 && byForce[n] != 0 ? drop / 2 - 3 * g * (z + 0.5) : 0;
      assertEquals(byForce[n] + beside, byDrop[n], 1e-7 * most, "n=" + n);
    }
  }

  /** Walls, symmetry and periodic ends beside pressure faces. */
  private static List<LbmSchemeBuilder> flows(VelocitySet set) {
    return List.of(
        stokes(lattice(Ends.OPEN, Ends.OPEN, Ends.PERIODIC), set)
            .pressureFaces(0, 1.01, 0.98)
            .force(new BodyForce(0, 2e-5, 1e-4)),
        stokes(lattice(Ends.PERIODIC, Ends.OPEN, Ends.OPEN), set)
            .pressureFaces(1, 0.99, 1.02)
            .symmetryFaces(2),
        stokes(lattice(OPEN), set).pressureFaces(2, 1.01, 1).symmetryFaces(0).symmetryFaces(1));
  }

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

  @ParameterizedTest
  @EnumSource(Storage.class)
  void sameBitsForAnyStreamingKernelBundleSizeAndWorkers(Storage storage) {
    for (VelocitySet set : VelocitySet.values()) {
      for (int flow = 0; flow < 3; flow++) {
        LbmSchemeBuilder pull = flows(set).get(flow).storage(storage).streaming(Streaming.PULL);
        double[] reference = run(disturbed(pull.kernel(KernelForm.REFERENCE)), 1, 31);
        for (Streaming streaming : Streaming.values()) {
          for (KernelForm kernel : List.of(KernelForm.REFERENCE, KernelForm.SCALAR)) {
            for (BundleSize size :
                List.of(BundleSize.cube(3), new BundleSize(64, 2, 5), new BundleSize(1, 4, 2))) {
              LbmSchemeBuilder other =
                  flows(set)
                      .get(flow)
                      .storage(storage)
                      .streaming(streaming)
                      .kernel(kernel)
                      .bundleSize(size);
              assertArrayEquals(
                  reference,
                  run(disturbed(other), 3, 31),
                  () -> set + " " + streaming + " " + kernel + " " + size);
            }
          }
        }
      }
    }
  }

  @ParameterizedTest
  @EnumSource(VelocitySet.class)
  void massFluxIsTheSameThroughAllSections(VelocitySet set) {
    for (Streaming streaming : Streaming.values()) {
      LbmScheme scheme =
          stokes(lattice(Ends.OPEN, Ends.OPEN, Ends.PERIODIC), set)
              .pressureFaces(0, 1.001, 0.999)
              .streaming(streaming)
              .bundleSize(BundleSize.cube(4))
              .build();
      run(scheme, 1, 6001);
      double[] flux = flux(scheme);
      assertTrue(flux[0] > 1e-6, "flux=" + flux[0]);
      for (double section : flux) {
        assertEquals(1, section / flux[0], 1e-9);
      }
    }
  }

  private static double[] flux(LbmScheme scheme) {
    double[] flux = new double[EXTENT[0]];
    LbmScheme.Scratch scratch = scheme.newScratch();
    for (int n = 0; n < scheme.cells().size(); n++) {
      scheme.forEachFlux(
          scheme.cells().cellAt(n), scratch, (x, y, z, density, ux, uy, uz) -> flux[x] += ux);
    }
    return flux;
  }

  /** After an even and an odd number of steps, in both phases of the pattern in place. */
  @ParameterizedTest
  @CsvSource({"20, DOUBLE", "21, DOUBLE", "20, SINGLE", "21, SINGLE"})
  void goesOnFromASavedStateWithTheSameBits(int steps, Storage storage) throws IOException {
    BundleSize size = BundleSize.cube(4);
    for (int flow = 0; flow < 3; flow++) {
      for (Streaming before : Streaming.values()) {
        for (Streaming after : Streaming.values()) {
          LbmSchemeBuilder builder = flows(VelocitySet.D3Q19).get(flow).storage(storage);
          LbmScheme whole = disturbed(builder.streaming(before).bundleSize(size));
          LbmScheme rest = builder.streaming(after).build();
          try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
            TimeLoop loop = dispatcher.loop(whole);
            loop.run(steps);
            ByteArrayOutputStream saved = new ByteArrayOutputStream();
            whole.save(new DataOutputStream(saved));
            loop.run(7);
            rest.restore(new DataInputStream(new ByteArrayInputStream(saved.toByteArray())));
            dispatcher.loop(rest).run(7);
            assertArrayEquals(state(whole), state(rest), before + " " + after);
          }
        }
      }
    }
  }

  /** Wherever the populations stand: in each streaming, after none, one, two and three steps. */
  @ParameterizedTest
  @EnumSource(Streaming.class)
  void addsToNodesAtTheFacesBetweenSteps(Streaming streaming) {
    LbmScheme scheme =
        disturbed(
            flows(VelocitySet.D3Q15).get(2).streaming(streaming).bundleSize(BundleSize.cube(4)));
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
                change.density = 1e-4 * (x + 1);
                change.uz = -2e-4 * y;
              });
        }
        scheme.forEachNode(
            (x, y, z, density, ux, uy, uz) -> {
              int at = 4 * (x + EXTENT[0] * (y + EXTENT[1] * z));
              assertEquals(before[at] + 1e-4 * (x + 1), density, 1e-15);
              assertEquals(before[at + 1], ux, 1e-15);
              assertEquals(before[at + 3] - 2e-4 * y, uz, 1e-15);
            });
        loop.run(1);
      }
    }
  }

  @Test
  void fluidTakesTheDensityOfThePlenumsWhenItIsChanged() {
    LbmScheme scheme =
        stokes(Lattice.empty(6, 5, 4, Ends.OPEN, Ends.OPEN, Ends.OPEN), VelocitySet.D3Q19)
            .pressureFaces(1, 1.001, 0.999)
            .build();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      TimeLoop loop = dispatcher.loop(scheme);
      loop.run(201);
      scheme.pressureFaces(1.02, 1.02);
      loop.run(4_000);
    }
    scheme.forEachNode(
        (x, y, z, density, ux, uy, uz) -> {
          assertEquals(1.02, density, 1e-12);
          assertEquals(0, uy, 1e-12);
        });
  }

  @Test
  void stepsAllocateNothing() {
    LbmScheme scheme = flows(VelocitySet.D3Q19).get(2).bundleSize(BundleSize.cube(4)).build();
    try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
      TimeLoop loop = dispatcher.loop(scheme);
      assertTrue(loop.warmUp(2_000, 10), () -> loop.stats().toString());
    }
  }

  @Test
  void refusesFacesThatCannotBe() {
    LbmSchemeBuilder quadratic = LbmScheme.on(lattice(OPEN)).pressureFaces(0, 1, 1);
    assertThrows(IllegalArgumentException.class, quadratic::build);
    Lattice periodic = lattice(Ends.PERIODIC, Ends.OPEN, Ends.OPEN);
    LbmSchemeBuilder around = LbmScheme.on(periodic).symmetryFaces(0);
    assertThrows(IllegalArgumentException.class, around::build);
    LbmSchemeBuilder both =
        stokes(lattice(OPEN), VelocitySet.D3Q19).symmetryFaces(1).pressureFaces(1, 1, 1);
    assertThrows(IllegalArgumentException.class, both::build);
    LbmSchemeBuilder empty = stokes(lattice(OPEN), VelocitySet.D3Q19).pressureFaces(1, 1, 0);
    assertThrows(IllegalArgumentException.class, empty::build);
    LbmSchemeBuilder plain = LbmScheme.on(lattice(OPEN));
    assertThrows(IndexOutOfBoundsException.class, () -> plain.symmetryFaces(3));
    assertThrows(IllegalStateException.class, () -> plain.build().pressureFaces(1, 1));
  }
}
