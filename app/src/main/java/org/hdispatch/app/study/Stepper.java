package org.hdispatch.app.study;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ThreadFactory;
import java.util.stream.LongStream;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.ScratchLifetime;
import org.hdispatch.dispatch.TimeLoop;

/** Steps a workload, with its scratch kept as a policy says. */
final class Stepper implements AutoCloseable {
  private static final String WORKERS = "gc-study-";

  /** How the JDK calls the platform threads that carry virtual threads. */
  private static final String CARRIERS = "ForkJoinPool-";

  private final Dispatcher dispatcher;
  private final ExecutorService executor; // null: none
  private final TimeLoop loop;
  private final long caller = Thread.currentThread().getId();

  private Stepper(
      Dispatcher dispatcher, ExecutorService executor, Scheme<?, ?> scheme, ScratchLifetime life) {
    this.dispatcher = dispatcher;
    this.executor = executor;
    loop = dispatcher.loop(scheme, life);
  }

  /**
   * Makes one, whose steps this thread asks for.
   *
   * @param threads that work at the same time
   * @throws UnsupportedOperationException if this JVM has no virtual threads and needs them
   */
  static Stepper of(Work<?, ?> work, ScratchPolicy policy, int threads) {
    return of(work.scheme(), policy, threads);
  }

  private static <C, S> Stepper of(Scheme<C, S> scheme, ScratchPolicy policy, int threads) {
    return switch (policy) {
      case ENDURING -> on(threads, scheme, ScratchLifetime.ENDURING);
      case PER_STEP -> on(threads, scheme, ScratchLifetime.PER_STEP);
      case PER_CELL -> on(threads, scheme, ScratchLifetime.PER_CELL);
      case OBJECT_POOL -> on(threads, new PooledScheme<>(scheme), ScratchLifetime.ENDURING);
      case THREAD_LOCAL_POOL -> {
        ThreadFactory factory = task -> daemon(task, WORKERS + "pool");
        yield by(Executors.newFixedThreadPool(threads, factory), scheme);
      }
      case THREAD_LOCAL_VIRTUAL -> by(virtualThreads(), scheme);
    };
  }

  private static Stepper on(int threads, Scheme<?, ?> scheme, ScratchLifetime life) {
    return new Stepper(
        Dispatcher.builder().workers(threads).name(WORKERS + "enduring").build(),
        null,
        scheme,
        life);
  }

  private static <C, S> Stepper by(ExecutorService executor, Scheme<C, S> scheme) {
    return new Stepper(
        Dispatcher.withWorkers(1),
        executor,
        new ExecutorScheme<>(scheme, executor),
        ScratchLifetime.ENDURING);
  }

  private static Thread daemon(Runnable task, String name) {
    Thread thread = new Thread(task, name);
    thread.setDaemon(true);
    return thread;
  }

  /** Of Java 21; this is compiled for 17. */
  private static ExecutorService virtualThreads() {
    try {
      return (ExecutorService)
          Executors.class.getMethod("newVirtualThreadPerTaskExecutor").invoke(null);
    } catch (ReflectiveOperationException e) {
      throw new UnsupportedOperationException(
          "JVM must have virtual threads: java=" + System.getProperty("java.version"), e);
    }
  }

  /** Makes a step. */
  void step() {
    loop.run(1);
  }

  /**
   * The platform threads that step: this one, the workers, and those that carry virtual threads,
   * whose processor time and allocation the JVM counts for the carrier.
   */
  long[] threads() {
    ThreadMXBean bean = ManagementFactory.getThreadMXBean();
    LongStream others =
        Arrays.stream(bean.getThreadInfo(bean.getAllThreadIds()))
            .filter(info -> info != null && steps(info))
            .mapToLong(ThreadInfo::getThreadId);
    return LongStream.concat(LongStream.of(caller), others).distinct().toArray();
  }

  private static boolean steps(ThreadInfo thread) {
    return thread.getThreadName().startsWith(WORKERS)
        || thread.getThreadName().startsWith(CARRIERS);
  }

  /** Ends its threads. */
  @Override
  public void close() {
    dispatcher.close();
    if (executor != null) {
      executor.shutdownNow();
    }
  }
}
