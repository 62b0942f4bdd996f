package org.hdispatch.dispatch;

/** One pass of a loop, step after step. */
final class Sweep {
  private final Crew crew;
  private final Handout handout;
  private final PassTask<?, ?> task;
  private final HeaviestFirst heaviestFirst; // null: in key order
  private final int[] equalSegments;
  private final Events.PassDone event = new Events.PassDone();
  private int cells;

  Sweep(Crew crew, Handout handout, PassTask<?, ?> task) {
    this.crew = crew;
    this.handout = handout;
    this.task = task;
    equalSegments = new int[crew.size()];
    heaviestFirst =
        handout == Handout.HEAVIEST_FIRST
            ? new HeaviestFirst(task, crew.size(), System::nanoTime)
            : null;
  }

  /** The cells are other ones now. */
  void reset(int newCells) {
    cells = newCells;
    PullTickets.cut(cells, equalSegments);
    if (heaviestFirst != null) {
      heaviestFirst.reset(cells);
    }
  }

  /** Processes every cell; failure and early end as {@link Crew#dispatch}. */
  void pass(Crew.Run run, long step) {
    boolean recorded = event.isEnabled();
    if (recorded) {
      event.begin();
    }
    if (heaviestFirst == null) {
      crew.dispatch(task, equalSegments, handout, run);
    } else {
      crew.dispatch(heaviestFirst, heaviestFirst.segmentEnds(), handout, run);
      heaviestFirst.passed();
    }
    if (recorded) {
      event.end();
      event.step = step;
      event.pass = task.name();
      event.cells = cells;
      event.commit();
    }
  }
}
