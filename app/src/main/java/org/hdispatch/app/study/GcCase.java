package org.hdispatch.app.study;

/**
 * One run of the study.
 *
 * @param java version of the JVM, such as {@code 17.0.15}
 * @param collector of that JVM
 * @param policy who keeps scratch
 * @param workload what is stepped
 * @param scratchBytes size of a scratch
 * @param heapFactor size of the heap, in multiples of the smallest that runs
 */
public record GcCase(
    String java,
    Collector collector,
    ScratchPolicy policy,
    Workload workload,
    int scratchBytes,
    double heapFactor) {}
