/** How many steps do particles make in a second? */
package org.hdispatch.bench.sph;
