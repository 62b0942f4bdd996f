/**
 * Smoothing kernels W(r, h) of smoothed particle hydrodynamics.
 *
 * <p>A kernel is judged by what it makes of a simple-cubic lattice of spacing dx: its number
 * density and its viscosity (Laplacian) should both be 1. The quintic spline at h = dx errs by 0.1
 * % in viscosity with 92 neighbours in 3-D, and is therefore the first choice; the cubic spline at
 * h = dx errs by 2 %, Wendland C2 by 5 % unless h is 1.5 dx.
 */
package org.hdispatch.sph;
