/**
 * What else the JDK offers to run a task per cell on a fixed number of threads, step after step:
 * the peers that the dispatcher is measured against.
 */
package org.hdispatch.bench.peer;
