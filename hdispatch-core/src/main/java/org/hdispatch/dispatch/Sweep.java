package org.hdispatch.dispatch;

/** One pass of a loop, step after step. */
final class Sweep {
  private final Crew crew;
  private final Handout handout;
  private final String name;
  private final Task task;
  private final HeaviestFirst order; // null: key order
  private final int[] segmentEnds;
  private final Events.PassDone event = new Events.PassDone();
  private int cells;

  Sweep(Crew crew, Handout handout, PassTask<?, ?> pass) {
    this.crew = crew;
    this.handout = handout;
    name = pass.name();
    if (handout == Handout.HEAVIEST_FIRST) {
      order = new HeaviestFirst(crew.size());
      task = new HeaviestFirstTask(pass, order);
      segmentEnds = order.segmentEnds();
    } else {
      order = null;
      task = pass;
      segmentEnds = new int[crew.size()];
    }
  }

  /** The cells are other ones now. */
  void reset(int newCells) {
    cells = newCells;
    if (order == null) {
      PullTickets.cut(cells, segmentEnds);
    } else {
      order.reset(cells);
    }
  }

  /** Processes every cell; failure and early end as {@link Crew#dispatch}. */
  void pass(Crew.Run run, long step) {
    boolean recorded = event.isEnabled();
    if (recorded) {
      event.begin();
    }
    crew.dispatch(task, segmentEnds, handout, run);
    if (order != null) {
      order.passed();
    }
    if (recorded) {
      event.end();
      event.step = step;
      event.pass = name;
      event.cells = cells;
      event.commit();
    }
  }
}
