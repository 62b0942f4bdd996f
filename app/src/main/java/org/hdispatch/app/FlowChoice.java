package org.hdispatch.app;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.porous.flow.FlowListener;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.flow.LbmFlow;
import org.hdispatch.porous.flow.SphFlow;
import org.hdispatch.porous.flow.SphOptions;
import org.hdispatch.porous.flow.SteadyFlow;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.PoreSpace;

/**
 * A method and its settings, ready for any rock.
 *
 * @param method by which flows are computed
 * @param options settings of the flow
 * @param particles what belongs to particles alone
 */
record FlowChoice(Method method, FlowOptions options, SphOptions particles) {
  /**
   * The choice of the user; what was not given follows from the method and the walls.
   *
   * @throws UsageException if options do not go together, or one is out of its bounds
   */
  static FlowChoice of(MethodOptions method, FlowSettings settings, Given given) {
    if (method.method() == Method.SPH) {
      MethodOptions.LBM_NAMES.forEach(name -> given.refuse(name, "--method lbm"));
    } else {
      MethodOptions.SPH_NAMES.forEach(name -> given.refuse(name, "--method sph"));
    }
    if (settings.walls() != Walls.IMB) {
      given.refuse("--solid-fraction-range", "--walls imb");
    }
    if (settings.solidFractionRange().isPresent()) {
      given.refuse("--pore-value", "a segmented image, not --solid-fraction-range");
    }
    FlowOptions options = settings.options();
    if (method.method() == Method.SPH && !given.has("--tolerance")) {
      options = options.withTolerance(MethodOptions.SPH_TOLERANCE);
    }
    if (settings.walls() == Walls.IMB) {
      if (!given.has("--lattice")) {
        options = options.withVelocitySet(FlowOptions.IMMERSED.velocitySet());
      }
      if (!given.has("--collision")) {
        options = options.withCollision(FlowOptions.IMMERSED.collision());
      }
    }
    FlowChoice choice = new FlowChoice(method.method(), options, method.particles());
    return UsageException.orRefused(choice::checked);
  }

  private FlowChoice checked() {
    if (method == Method.SPH) {
      SphFlow.check(options);
    }
    return this;
  }

  /** The same along another axis. */
  FlowChoice along(Axis axis) {
    return with(options.withAxis(axis));
  }

  /** The same method with other settings of the flow. */
  FlowChoice with(FlowOptions others) {
    return new FlowChoice(method, others, particles);
  }

  /**
   * Heap that a flow needs, that of its rock included, bytes.
   *
   * @throws UsageException if the method cannot compute it
   */
  double estimatedBytes(Rock rock) {
    PoreSpace space = rock.space();
    long flow = // refused: rock without any wall
        UsageException.orRefused(
            () ->
                method == Method.SPH
                    ? SphFlow.estimatedBytes(space, options)
                    : rock.solid().isPresent()
                        ? LbmFlow.estimatedBytes(rock.solid().get(), options)
                        : LbmFlow.estimatedBytes(space, options));
    return flow + (double) space.voxels() * Rock.BYTES_PER_VOXEL;
  }

  /**
   * Checks that a flow will fit.
   *
   * @throws HeapException if it will not
   * @throws UsageException if the method cannot compute it
   */
  void requireHeap(Rock rock, Host host) {
    host.requireHeap(
        "the flow of " + rock.space().poreVoxels() + " pore voxels", estimatedBytes(rock));
  }

  /** Computes the steady flow through a rock. */
  SteadyFlow solve(Dispatcher dispatcher, Rock rock, FlowListener listener) {
    if (method == Method.SPH) {
      return SphFlow.solve(dispatcher, rock.space(), options, particles, listener);
    }
    return rock.solid().isPresent()
        ? LbmFlow.solve(dispatcher, rock.solid().get(), options, listener)
        : LbmFlow.solve(dispatcher, rock.space(), options, listener);
  }
}
