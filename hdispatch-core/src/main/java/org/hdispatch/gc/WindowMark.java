package org.hdispatch.gc;

import jdk.jfr.Category;
import jdk.jfr.Description;
import jdk.jfr.Event;
import jdk.jfr.Label;
import jdk.jfr.Name;
import jdk.jfr.StackTrace;

/**
 * Edge between two windows of a {@link GcWatch}, on the clock of the recording itself: the clock of
 * {@code Instant.now()} may differ from it by more than a short window lasts.
 */
@Name(WindowMark.NAME)
@Label("Window Mark")
@Description("A new window of a GC watch begins")
@Category("H-Dispatch")
@StackTrace(false)
final class WindowMark extends Event {

  static final String NAME = "org.hdispatch.gc.WindowMark";

  @Label("Watch")
  long watch;

  static void emit(long watch) {
    WindowMark mark = new WindowMark();
    mark.watch = watch;
    mark.commit();
  }
}
