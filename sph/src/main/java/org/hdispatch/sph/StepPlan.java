package org.hdispatch.sph;

/** What the step in progress does; set by the caller's thread before it, read by all workers. */
final class StepPlan {
  /** Buffer that the last step has written. */
  int from;

  /** Buffer that densities and forces read: the other one after re-hashing. */
  int at;

  /** Buffer that is written. */
  int to;

  /** Whether particles go to the cells they are in now, and lists are made anew. */
  boolean rehash;

  /** Time by which forces change velocities. */
  double kick;

  double timeStep;

  // acceleration of all fluid
  double gx;
  double gy;
  double gz;

  void begin(int written, boolean anew) {
    from = written;
    rehash = anew;
    at = anew ? 1 - written : written;
    to = 1 - at;
  }
}
