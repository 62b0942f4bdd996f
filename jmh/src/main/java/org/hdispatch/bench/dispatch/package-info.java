/**
 * What does it cost to hand a cell to a worker, and what does the hand-out win?
 *
 * <p>Every benchmark has one method, {@code step}: the variant is the parameter {@code peer}, so
 * that one table of parameters holds them all and each variant still has forks of its own.
 */
package org.hdispatch.bench.dispatch;
