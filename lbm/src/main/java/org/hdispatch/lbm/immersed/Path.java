package org.hdispatch.lbm.immersed;

/** A prescribed motion. */
@FunctionalInterface
public interface Path {
  /**
   * Puts a body where it is at a time.
   *
   * @param time in time steps
   * @param body to be placed
   */
  void at(double time, Body body);

  /** Motion at constant velocity and spin. */
  static Path straight(Point start, Point velocity, Point spin) {
    return (time, body) -> {
      body.moveTo(
          start.x() + velocity.x() * time,
          start.y() + velocity.y() * time,
          start.z() + velocity.z() * time);
      body.moveAt(velocity.x(), velocity.y(), velocity.z());
      body.spinAt(spin.x(), spin.y(), spin.z());
    };
  }
}
