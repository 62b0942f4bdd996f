/**
 * Smoothed particle hydrodynamics of slow flows between walls of any shape: {@link
 * org.hdispatch.sph.SphScheme}, made by its builder of a {@link org.hdispatch.sph.ParticleBox}, a
 * {@link org.hdispatch.sph.SmoothingKernel}, {@link org.hdispatch.sph.Phase}s and {@link
 * org.hdispatch.sph.Particles}.
 *
 * <p>A kernel is judged by what it makes of a simple-cubic lattice of spacing dx: its number
 * density and its viscosity (Laplacian) should both be 1. The quintic spline at h = dx errs by 0.1
 * % in viscosity with 92 neighbours in 3-D, and is therefore the first choice; the cubic spline at
 * h = dx errs by 2 %, Wendland C2 by 5 % unless h is 1.5 dx.
 */
package org.hdispatch.sph;
