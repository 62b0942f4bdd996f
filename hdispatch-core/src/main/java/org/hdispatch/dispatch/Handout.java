package org.hdispatch.dispatch;

/** How cells reach the workers. It never changes a result. */
public enum Handout {
  /** Workers pull: each from its home segment of the order first, then from the others'. */
  PULL,
  /**
   * Workers pull, and the cells that took longest come first: for few cells of very uneven cost,
   * where one heavy cell begun last would hold everybody up. Costs are measured in every 64th step
   * and after each change of the cells.
   */
  HEAVIEST_FIRST,
  /** Each worker gets its home segment and nothing else: the control of scaling studies. */
  STATIC
}
