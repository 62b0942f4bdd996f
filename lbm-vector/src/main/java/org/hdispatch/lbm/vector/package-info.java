/**
 * The collision kernels of the lattice Boltzmann method in the JDK's Vector API, found by {@link
 * java.util.ServiceLoader} and used when the JVM has {@code --add-modules jdk.incubator.vector}.
 * Bit by bit the same as the plain ones.
 *
 * <p>The kernels themselves are written by {@code KernelSource} (among the tests) from the tables
 * of {@link org.hdispatch.lbm.VelocitySet}; a test compares the two.
 */
package org.hdispatch.lbm.vector;
