/**
 * From the permeabilities of blocks side by side to that of the sample they make up: Darcy's law
 * between the blocks, and bounds that need no solution.
 */
package org.hdispatch.porous.upscale;
