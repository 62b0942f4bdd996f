package org.hdispatch.dispatch;

/** How cells reach the workers. It never changes a result. */
public enum Handout {
  /** Workers pull: each from its home segment of the order first, then from the others'. */
  PULL,
  /** Each worker gets its home segment and nothing else: the control of scaling studies. */
  STATIC
}
