/**
 * The lattice as the paper describes it, a dictionary of bundles which are dictionaries of nodes
 * (Leonardi et al. 2011), beside the flat bundles of this library: what is the layout worth?
 */
package org.hdispatch.bench.paper;
