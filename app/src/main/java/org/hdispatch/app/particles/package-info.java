/**
 * {@code sph} and {@code search-study}: smoothed particle hydrodynamics, how right it is and how
 * fast.
 */
package org.hdispatch.app.particles;
