/**
 * Cells, the units of hand-out: their keys, the grid they lie on and the hash map that owns them.
 */
package org.hdispatch.cell;
