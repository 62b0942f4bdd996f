package org.hdispatch.dispatch;

/**
 * The work that one pass does on one cell.
 *
 * <p><b>What the dispatcher guarantees</b>
 *
 * <ol>
 *   <li>In one pass every cell is processed exactly once, by one worker (test: {@code
 *       DispatcherRandomStepsTest.everyCellExactlyOnce}).
 *   <li>What an earlier pass wrote, whichever worker wrote it, is visible (test: {@code
 *       DispatcherTest.everyPassSeesWhatTheLastOneWrote}).
 *   <li>A worker processes one cell at a time and always passes its own scratch: no other thread
 *       sees that scratch (test: {@code DispatcherTest.makesScratchOncePerWorkerOnItsOwnThread}).
 *   <li>{@code tick} and the set of cells do not change during the pass; the cells that kernels ask
 *       for come and go after the step (test: {@code
 *       MovingFrontTest.sameCellsAndBitsAsOnSortedMaps}).
 * </ol>
 *
 * <p><b>What the kernel must keep (the ownership rule)</b>
 *
 * <ol start="5">
 *   <li>It writes only data that no other cell's kernel reads or writes in the same pass: as a rule
 *       the <em>current</em> values of its own cell, and its scratch. It may read the
 *       <em>previous</em> values of any cell.
 *   <li>It takes nothing from the scratch that it did not write there for this cell: scratch holds
 *       rubbish on entry.
 *   <li>It adds nothing up across cells. A sum is stored per cell and added by {@link
 *       Scheme#afterStep} in key order.
 * </ol>
 *
 * <p>Then no lock is needed, and every bit of the result is the same for any number of workers and
 * any order of hand-out (test: {@code DispatcherTest.sameBitsForAnyWorkerCount}). A kernel that
 * stores no reference into an old object also spares the collector's card table: roll an index
 * ({@link Tick#previous}, {@link Tick#current}) instead.
 *
 * @param <C> type of a cell
 * @param <S> type of the scratch
 */
@FunctionalInterface
public interface CellKernel<C, S> {
  /**
   * Processes one cell.
   *
   * @param cell the cell this worker pulled
   * @param scratch this worker's scratch, with rubbish in it
   * @param tick the step, its buffers, and this worker's wishes for cells to come and go
   */
  void process(C cell, S scratch, Tick tick);
}
