/** Set-ups ready to run: a box, its fluids and walls, and what is known of the flow in it. */
package org.hdispatch.sph.cases;
