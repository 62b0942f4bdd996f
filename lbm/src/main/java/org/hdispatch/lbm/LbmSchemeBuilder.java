package org.hdispatch.lbm;

import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.KernelException;

/** Settings of a scheme; all but the lattice have a default. */
public final class LbmSchemeBuilder {
  final Lattice lattice;
  VelocitySet set = VelocitySet.D3Q19;
  Relaxation relaxation = Relaxation.trt(1);
  Equilibrium equilibrium = Equilibrium.QUADRATIC;
  BodyForce force = BodyForce.NONE;
  private Optional<BundleSize> size = Optional.empty();
  Streaming streaming = Streaming.IN_PLACE;
  Storage storage = Storage.DOUBLE;
  KernelForm form = KernelForm.fastest();
  Immersion immersion;
  final boolean[] symmetric = new boolean[3];
  int pressureAxis = -1;
  double firstDensity = 1;
  double lastDensity = 1;

  LbmSchemeBuilder(Lattice lattice) {
    this.lattice = Objects.requireNonNull(lattice, "lattice");
  }

  /** Sets the velocity set. Default: D3Q19. */
  public LbmSchemeBuilder velocitySet(VelocitySet velocitySet) {
    set = Objects.requireNonNull(velocitySet, "velocitySet");
    return this;
  }

  /** Sets the relaxation rates. Default: TRT with magic number 3/16 at tau 1. */
  public LbmSchemeBuilder relaxation(Relaxation rates) {
    relaxation = Objects.requireNonNull(rates, "rates");
    return this;
  }

  /** Sets the equilibrium. Default: quadratic. */
  public LbmSchemeBuilder equilibrium(Equilibrium form) {
    equilibrium = Objects.requireNonNull(form, "form");
    return this;
  }

  /** Sets the body force. Default: none. */
  public LbmSchemeBuilder force(BodyForce bodyForce) {
    force = Objects.requireNonNull(bodyForce, "bodyForce");
    return this;
  }

  /** Sets the size of the bundles. Default: {@link BundleSize#fitting}. */
  public LbmSchemeBuilder bundleSize(BundleSize bundleSize) {
    size = Optional.of(Objects.requireNonNull(bundleSize, "bundleSize"));
    return this;
  }

  BundleSize bundleSize() {
    return size.orElseGet(() -> BundleSize.fitting(lattice));
  }

  /** Sets how populations move. Default: in place. */
  public LbmSchemeBuilder streaming(Streaming how) {
    streaming = Objects.requireNonNull(how, "how");
    return this;
  }

  /** Sets the precision in which populations are stored. Default: double. */
  public LbmSchemeBuilder storage(Storage precision) {
    storage = Objects.requireNonNull(precision, "precision");
    return this;
  }

  /**
   * Sets the form of the kernel. Default: the fastest that this JVM can run.
   *
   * @throws IllegalStateException from {@link #build} if this JVM cannot run it
   */
  public LbmSchemeBuilder kernel(KernelForm kernelForm) {
    form = Objects.requireNonNull(kernelForm, "kernelForm");
    return this;
  }

  /** Sets what lies in the flow. Default: nothing. */
  public LbmSchemeBuilder immersion(Immersion bodies) {
    immersion = Objects.requireNonNull(bodies, "bodies");
    return this;
  }

  /**
   * Puts a symmetry face at both ends of an axis in place of a wall, half a spacing outside the
   * last nodes: as if the mirror image of lattice, force and flow lay beyond it. Fluid slips along
   * it. The axis must have {@code OPEN} ends.
   *
   * @param axis 0, 1 or 2
   * @throws IndexOutOfBoundsException if there is no such axis
   * @throws IllegalArgumentException from {@link #build} if its ends are periodic
   */
  public LbmSchemeBuilder symmetryFaces(int axis) {
    symmetric[Objects.checkIndex(axis, symmetric.length)] = true;
    return this;
  }

  /**
   * Opens both ends of an axis to a plenum of given density, so of given pressure rho/3: a face in
   * place of a wall, half a spacing outside the last nodes, where the density is that of the plenum
   * and fluid passes at right angles. It is as if the mirror image of the lattice lay beyond, with
   * the same flow through it and the pressure falling on. The axis must have {@code OPEN} ends, the
   * equilibrium must be linear. A body force may act as well.
   *
   * @param axis 0, 1 or 2; the last one told counts
   * @param first density before the first nodes
   * @param last density behind the last nodes
   * @throws IndexOutOfBoundsException if there is no such axis
   * @throws IllegalArgumentException from {@link #build} if its ends are periodic, a density is not
   *     positive, or the equilibrium not linear
   */
  public LbmSchemeBuilder pressureFaces(int axis, double first, double last) {
    pressureAxis = Objects.checkIndex(axis, symmetric.length);
    firstDensity = first;
    lastDensity = last;
    return this;
  }

  /** Cuts the lattice into bundles and puts them at rest. */
  public LbmScheme build() {
    return new LbmScheme(this, SetUp.alone());
  }

  /**
   * Lets the workers of a dispatcher cut the lattice: the scheme is the same. Several of them ask
   * which nodes are fluid at the same time.
   *
   * @throws KernelException if a worker fails, out of memory say
   * @throws CancellationException if the caller was interrupted or the dispatcher closed meanwhile
   * @throws IllegalStateException if the dispatcher is running a loop already or is closed
   */
  public LbmScheme build(Dispatcher dispatcher) {
    return new LbmScheme(this, SetUp.by(dispatcher));
  }
}
