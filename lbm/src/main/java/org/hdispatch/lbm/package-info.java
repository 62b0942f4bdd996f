/**
 * The lattice Boltzmann method over nodal bundles, two copies of the populations, pull order.
 *
 * <p>One step of one bundle: the previous populations of the nodes' neighbours are gathered into
 * the worker's scratch ({@code StreamPlan}: runs of nodes, walls and periodic sides included),
 * collided there ({@link org.hdispatch.lbm.Collision}), and stored as the bundle's current
 * populations.
 *
 * <p>Populations are kept as deviations from their weights, f_i - w_i: a fluid at rest with density
 * 1 is all zeros. Lattice units throughout: node spacing 1, time step 1, mean density 1.
 *
 * <p>Source: Leonardi, Holmes, Williams, Tilke, HPC 2011, and the works named at each formula.
 */
package org.hdispatch.lbm;
