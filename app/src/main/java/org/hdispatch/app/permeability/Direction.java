package org.hdispatch.app.permeability;

import java.util.List;
import org.hdispatch.porous.image.Axis;

/** Along which axes a rock is flown through. */
enum Direction {
  /** Along x. */
  X(List.of(Axis.X)),
  /** Along y. */
  Y(List.of(Axis.Y)),
  /** Along z. */
  Z(List.of(Axis.Z)),
  /** Along one after the other: the permeability tensor. */
  ALL(List.of(Axis.values()));

  private final List<Axis> axes;

  Direction(List<Axis> axes) {
    this.axes = axes;
  }

  List<Axis> axes() {
    return axes;
  }
}
