/**
 * The sums over neighbours of smoothed particle hydrodynamics in the JDK's Vector API, found by
 * {@link java.util.ServiceLoader} and used when the JVM has {@code --add-modules
 * jdk.incubator.vector} and vectors of four doubles. Bit by bit the same as the plain ones.
 *
 * <p>The loops of each smoothing kernel are written by {@code SumsSource} (among the tests), which
 * holds their text once; a test compares the two.
 */
package org.hdispatch.sph.vector;
