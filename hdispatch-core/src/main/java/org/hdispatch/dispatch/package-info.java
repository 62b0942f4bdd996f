/**
 * Enduring threads that pull cells from a dispatcher, pass after pass.
 *
 * <pre>
 *   caller = worker 0        worker 1 ... worker n-1        (one thread each, for good)
 *        |                        |
 *   opens a pass: one segment of tickets per worker, pending = number of cells
 *        |------- announce ------>|
 *   pull, process, pull ...  pull, process, pull ...        own segment first, then the others'
 *        |                        |
 *   pending -= done          pending -= done                whoever brings it to 0 wakes the caller
 *        |
 *   next pass; after the last one: cells are added and removed, previous and current change places
 * </pre>
 *
 * Threads meet in three classes only: {@code PullTickets} (who processes which cell, and when all
 * are done), {@code Signals} (the threads: spin, park, wake) and {@code Crew} (a pass from its
 * opening to its end). What a method may do inside a pass is said in {@link
 * org.hdispatch.dispatch.CellKernel}.
 *
 * <p>Source: Holmes, Williams, Tilke, Computer Physics Communications 181(2), 2010, 341-354;
 * Leonardi, Holmes, Williams, Tilke, HPC 2011.
 */
package org.hdispatch.dispatch;
