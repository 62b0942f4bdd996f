package org.hdispatch.app.study;

/**
 * The smallest heap that a workload runs in: with Serial, and scratch made for every cell.
 *
 * @param workload what is stepped
 * @param scratchBytes size of a scratch
 * @param java version of the JVM it was found with
 * @param bytes {@code -Xms} and {@code -Xmx}
 * @param build hash of the code that ran
 */
public record SmallestHeap(
    Workload workload, int scratchBytes, String java, long bytes, String build) {}
