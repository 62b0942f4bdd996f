/**
 * {@code duct} and {@code settle}: the lattice Boltzmann method without rock, how fast it is and
 * how right.
 */
package org.hdispatch.app.lattice;
