package org.hdispatch.dispatch;

/** How cells reach the workers. It never changes a result. */
public enum Handout {
  /** Workers pull: each from its home segment of the order first, then from the others'. */
  PULL,
  /**
   * Workers pull, and the cells that took longest come first: for few cells of very uneven cost,
   * where one heavy cell begun last would hold everybody up. Costs are measured in every 64th step,
   * and anew when the set of cells has changed: of no use where it changes all the time.
   */
  HEAVIEST_FIRST,
  /** Each worker gets its home segment and nothing else: the control of scaling studies. */
  STATIC
}
