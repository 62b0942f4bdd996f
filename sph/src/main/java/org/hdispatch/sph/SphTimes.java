package org.hdispatch.sph;

/**
 * Wall time by kind of work, summed over workers.
 *
 * @param search re-hashing, gathering and listing of neighbours, s
 * @param density sums of densities, s
 * @param force sums of forces and moving on, s
 */
public record SphTimes(double search, double density, double force) {}
