package org.hdispatch.porous.block;

import java.io.Serializable;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.porous.flow.FlowListener;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.flow.LbmFlow;
import org.hdispatch.porous.flow.SphFlow;
import org.hdispatch.porous.flow.SphOptions;
import org.hdispatch.porous.flow.SteadyFlow;
import org.hdispatch.porous.image.Axis;

/**
 * A method and its settings, ready for any rock.
 *
 * @param method by which flows are computed
 * @param options settings of the flow
 * @param particles what belongs to particles alone
 */
public record FlowChoice(Method method, FlowOptions options, SphOptions particles)
    implements Serializable {
  /** The lattice Boltzmann method as {@link FlowOptions#DEFAULT} says. */
  public static final FlowChoice DEFAULT =
      new FlowChoice(Method.LBM, FlowOptions.DEFAULT, SphOptions.DEFAULT);

  /**
   * Checks that the method can do what is asked for.
   *
   * @throws IllegalArgumentException if it cannot
   */
  public FlowChoice {
    if (method == Method.SPH) {
      SphFlow.check(options);
    }
  }

  /** The same along another axis. */
  public FlowChoice along(Axis axis) {
    return with(options.withAxis(axis));
  }

  /** The same method with other settings of the flow. */
  public FlowChoice with(FlowOptions others) {
    return new FlowChoice(method, others, particles);
  }

  /**
   * Heap that a flow needs, that of its rock included, bytes.
   *
   * @throws IllegalArgumentException if the method cannot compute it
   */
  public double estimatedBytes(Pores pores) {
    long flow =
        method == Method.SPH
            ? SphFlow.estimatedBytes(pores.space(), options, particles)
            : pores.solid().isPresent()
                ? LbmFlow.estimatedBytes(pores.solid().get(), options)
                : LbmFlow.estimatedBytes(pores.space(), options);
    return flow + (double) pores.space().voxels() * Pores.BYTES_PER_VOXEL;
  }

  /**
   * Checks that a flow will fit.
   *
   * @throws HeapException if it will not
   * @throws IllegalArgumentException if the method cannot compute it
   */
  public void requireHeap(Pores pores, HeapLimit heap) {
    heap.require(
        "the flow of " + pores.space().poreVoxels() + " pore voxels", estimatedBytes(pores));
  }

  /** Computes the steady flow through a rock. */
  public SteadyFlow solve(Dispatcher dispatcher, Pores pores, FlowListener listener) {
    if (method == Method.SPH) {
      return SphFlow.solve(dispatcher, pores.space(), options, particles, listener);
    }
    return pores.solid().isPresent()
        ? LbmFlow.solve(dispatcher, pores.solid().get(), options, listener)
        : LbmFlow.solve(dispatcher, pores.space(), options, listener);
  }
}
