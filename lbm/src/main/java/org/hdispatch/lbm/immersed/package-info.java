/**
 * Bodies in the flow by immersed moving boundaries: each node counts as solid to the share that a
 * body takes of its cell.
 *
 * <p>Source: Noble, Torczynski, International Journal of Modern Physics C 9, 1998, 1189; used by
 * Leonardi, Holmes, Williams, Tilke, HPC 2011.
 */
package org.hdispatch.lbm.immersed;
