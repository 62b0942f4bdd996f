/**
 * The lattice Boltzmann method over nodal bundles.
 *
 * <p>One step of one bundle: populations are read from the slots of the neighbours or from the
 * nodes' own, collided by a {@link org.hdispatch.lbm.CollisionKernel}, and written to the slots of
 * the neighbours or to their own, as {@link org.hdispatch.lbm.Streaming} says; {@code StreamPlan}
 * knows the neighbours' slots, walls and periodic ends included.
 *
 * <p>Populations are kept as deviations from their weights, f_i - w_i: a fluid at rest with density
 * 1 is all zeros. Lattice units throughout: node spacing 1, time step 1, mean density 1.
 *
 * <p>Source: Leonardi, Holmes, Williams, Tilke, HPC 2011, and the works named at each formula.
 */
package org.hdispatch.lbm;
