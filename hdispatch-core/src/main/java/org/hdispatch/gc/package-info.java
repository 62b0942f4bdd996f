/**
 * Meters of the garbage that a run makes and of what reclaiming it costs; they use nothing else of
 * this library.
 *
 * <p>{@link org.hdispatch.gc.AllocationMeter} reads, exactly, how many bytes given threads have
 * allocated. {@link org.hdispatch.gc.GcWatch} records, for each window of a run, three kinds of
 * stop that must not be mixed up:
 *
 * <ul>
 *   <li><b>pauses</b>: what the collector itself reports as stop-the-world work;
 *   <li><b>safepoints</b>: every time all threads were stopped, for whatever reason, from the
 *       request until they ran again; under G1 or ZGC this can be many times the pauses;
 *   <li><b>stalls</b>: single threads held up because ZGC could not yet give them memory; no pause
 *       counts them.
 * </ul>
 */
package org.hdispatch.gc;
