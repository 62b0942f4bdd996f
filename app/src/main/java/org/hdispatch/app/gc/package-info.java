/**
 * {@code gc-study} and {@code soak}: what enduring memory is worth, and the proof that long runs
 * leave nothing to the collector.
 */
package org.hdispatch.app.gc;
