package org.hdispatch.bench.paper;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.lbm.BodyForce;
import org.hdispatch.lbm.BundleSize;
import org.hdispatch.lbm.Collision;
import org.hdispatch.lbm.Equilibrium;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.Relaxation;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.Streaming;
import org.hdispatch.lbm.VelocitySet;

/** How nodes are stored and streamed, from the most literal form of the paper to the fastest. */
public enum PaperForm {
  /** Dictionaries of nodes whose populations are objects too. */
  NODES_BOXED(Streaming.PULL, NodeLayout.BOXED_POPULATIONS),
  /** {@link #NODES_PULL}, a plain loop on the caller's thread, whatever the number of workers. */
  NODES_SEQUENTIAL(Streaming.PULL, NodeLayout.DICTIONARY),
  /** Dictionaries of nodes, pull-collide. */
  NODES_PULL(Streaming.PULL, NodeLayout.DICTIONARY),
  /** Dictionaries of nodes, collide-push. */
  NODES_PUSH(Streaming.PUSH, NodeLayout.DICTIONARY),
  /** {@link #NODES_PULL} with keys that are numbers, as .NET has them. */
  NODES_PRIMITIVE_KEYS(Streaming.PULL, NodeLayout.PRIMITIVE_KEYS),
  /** Flat bundles, collided node by node like the dictionaries: the layout alone. */
  FLAT_REFERENCE(Streaming.PULL, Storage.DOUBLE, KernelForm.REFERENCE),
  /** Flat bundles, pull-collide. */
  FLAT_PULL(Streaming.PULL, Storage.DOUBLE, null),
  /** Flat bundles, collide-push. */
  FLAT_PUSH(Streaming.PUSH, Storage.DOUBLE, null),
  /** Flat bundles, one copy of the populations. */
  FLAT_IN_PLACE(Streaming.IN_PLACE, Storage.DOUBLE, null),
  /** The same in single precision. */
  FLAT_SINGLE(Streaming.IN_PLACE, Storage.SINGLE, null);

  private static final BodyForce FORCE = new BodyForce(1e-7, 0, 0);
  private static final Relaxation RELAXATION = Relaxation.trt(1);

  private final Streaming streaming;
  private final NodeLayout layout; // null: flat
  private final Storage storage;
  private final KernelForm kernel; // null: that of the benchmark

  PaperForm(Streaming streaming, NodeLayout layout) {
    this.streaming = streaming;
    this.layout = layout;
    storage = null;
    kernel = null;
  }

  PaperForm(Streaming streaming, Storage storage, KernelForm kernel) {
    this.streaming = streaming;
    layout = null;
    this.storage = storage;
    this.kernel = kernel;
  }

  /**
   * Makes the nodes.
   *
   * @param fastest kernel of the flat forms that do not name one
   */
  Scheme<?, ?> scheme(Lattice lattice, VelocitySet set, BundleSize bundle, KernelForm fastest) {
    if (layout != null) {
      Collision collision = new Collision(set, RELAXATION, Equilibrium.QUADRATIC, FORCE);
      return new NodeScheme(lattice, collision, bundle, streaming, layout);
    }
    return LbmScheme.on(lattice)
        .velocitySet(set)
        .bundleSize(bundle)
        .relaxation(RELAXATION)
        .force(FORCE)
        .streaming(streaming)
        .storage(storage)
        .kernel(kernel == null ? fastest : kernel)
        .build();
  }

  /** Starts the threads that step a scheme of this form. */
  Stepper start(Scheme<?, ?> scheme, int workers) {
    if (this == NODES_SEQUENTIAL) {
      return new Stepper(steps -> alone((NodeScheme) scheme, steps), () -> {});
    }
    Dispatcher dispatcher = Dispatcher.withWorkers(workers);
    return new Stepper(dispatcher.loop(scheme)::run, dispatcher::close);
  }

  private static void alone(NodeScheme scheme, int steps) {
    for (int step = 0; step < steps; step++) {
      scheme.stepAlone();
    }
  }
}
