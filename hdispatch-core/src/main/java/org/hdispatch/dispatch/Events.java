package org.hdispatch.dispatch;

import jdk.jfr.Category;
import jdk.jfr.DataAmount;
import jdk.jfr.Description;
import jdk.jfr.Enabled;
import jdk.jfr.Event;
import jdk.jfr.Label;
import jdk.jfr.Name;
import jdk.jfr.StackTrace;

/**
 * What a loop tells a JDK Flight Recording that asks for it by name. Each loop fills the same few
 * objects again and again: events that are not recorded cost a look at a flag and no byte.
 */
final class Events {
  private Events() {}

  /** A step that was completed, from {@code beforeStep} to the change of the cells. */
  @Name("org.hdispatch.Step")
  @Label("Step")
  @Description("A completed step of a time loop")
  @Category("H-Dispatch")
  @StackTrace(false)
  @Enabled(false)
  static final class StepDone extends Event {
    @Label("Step")
    long step;

    @Label("Cells")
    int cells;
  }

  /** A pass over all cells that was completed. */
  @Name("org.hdispatch.Pass")
  @Label("Pass")
  @Description("A completed pass over all cells")
  @Category("H-Dispatch")
  @StackTrace(false)
  @Enabled(false)
  static final class PassDone extends Event {
    @Label("Step")
    long step;

    @Label("Pass")
    String pass;

    @Label("Cells")
    int cells;
  }

  /** Workers have allocated in a step: scratch or cells have grown. */
  @Name("org.hdispatch.Growth")
  @Label("Growth")
  @Description("The workers allocated in a step")
  @Category("H-Dispatch")
  @StackTrace(false)
  @Enabled(false)
  static final class Growth extends Event {
    @Label("Step")
    long step;

    @Label("Bytes")
    @DataAmount
    long bytes;
  }

  /** Cells were added or removed. */
  @Name("org.hdispatch.CellsChanged")
  @Label("Cells Changed")
  @Description("Cells were added or removed after a step")
  @Category("H-Dispatch")
  @StackTrace(false)
  @Enabled(false)
  static final class CellsChanged extends Event {
    @Label("Step")
    long step;

    @Label("Cells Before")
    int before;

    @Label("Cells After")
    int after;
  }
}
