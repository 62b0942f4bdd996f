package org.hdispatch.bench.peer;

import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Handout;
import org.hdispatch.dispatch.WaitPolicy;

/** What can sweep cells: the dispatcher in its forms, and what else the JDK offers. */
public enum Peer {
  /** The dispatcher, workers pull. */
  PULL((workers, cells, task) -> dispatcher(workers, Handout.PULL, null, cells, task)),

  /** The dispatcher, workers pull, idle ones park at once. */
  PULL_PARK(
      (workers, cells, task) -> dispatcher(workers, Handout.PULL, WaitPolicy.PARK, cells, task)),

  /** The dispatcher, workers pull the heaviest cells first. */
  HEAVIEST_FIRST(
      (workers, cells, task) -> dispatcher(workers, Handout.HEAVIEST_FIRST, null, cells, task)),

  /** The dispatcher, each worker gets its segment and nothing else. */
  STATIC((workers, cells, task) -> dispatcher(workers, Handout.STATIC, null, cells, task)),

  /** A bare static partition: see {@link ScatterSweeper}. */
  SCATTER(ScatterSweeper::new),

  /** {@code IntStream.range(0, cells).parallel()}: see {@link StreamSweeper}. */
  STREAM(StreamSweeper::new),

  /** Fork and join down to single cells: see {@link ForkJoinSweeper}. */
  FORK_JOIN(ForkJoinSweeper::new),

  /** {@code CyclicBarrier} and a shared {@code AtomicInteger}: see {@link BarrierSweeper}. */
  BARRIER_COUNTER(BarrierSweeper::overCounter),

  /** {@code CyclicBarrier} and a {@code ConcurrentLinkedQueue<Long>}: see {@link QueueOfKeys}. */
  BARRIER_QUEUE(BarrierSweeper::overQueue),

  /** {@code ExecutorService.invokeAll} with a task per cell: see {@link InvokeAllSweeper}. */
  INVOKE_ALL(InvokeAllSweeper::new),

  /** A virtual thread per cell, from JDK 21: see {@link VirtualThreadSweeper}. */
  VIRTUAL_THREADS(VirtualThreadSweeper::new),

  /** A loop on the caller's thread, whatever the number of workers: what the tasks cost. */
  SEQUENTIAL((workers, cells, task) -> new SequentialSweeper(cells, task));

  private final Start start;

  Peer(Start start) {
    this.start = start;
  }

  /** Makes a sweeper. */
  private interface Start {
    Sweeper start(int workers, int cells, CellTask task);
  }

  /**
   * Starts its threads.
   *
   * @param workers threads that process cells
   * @param cells their number
   * @param task the work on each
   * @throws UnavailablePeerException if this JVM does not offer it
   * @throws IllegalArgumentException if its threads are the JVM's and not as many
   */
  public Sweeper start(int workers, int cells, CellTask task) {
    return start.start(workers, cells, task);
  }

  private static Sweeper dispatcher(
      int workers, Handout handout, WaitPolicy waitPolicy, int cells, CellTask task) {
    Dispatcher.Builder settings = Dispatcher.builder().workers(workers).handout(handout);
    if (waitPolicy != null) {
      settings.waitPolicy(waitPolicy);
    }
    return new DispatcherSweeper(settings, cells, task);
  }
}
