/** How many lattice nodes are updated in a second? */
package org.hdispatch.bench.lbm;
