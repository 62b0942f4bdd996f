package org.hdispatch.sph;

/** When neighbours are searched for. All modes find the same neighbours. */
public enum SearchMode {
  /** In every pass that needs them: nothing is stored. */
  DOUBLE,
  /** Once in a step: a list is kept from the sum of densities to that of forces. */
  SINGLE,
  /**
   * Seldom: neighbours are listed up to a skin beyond the support, and the list is kept until a
   * particle may have moved half of that (Verlet 1967).
   */
  VERLET
}
