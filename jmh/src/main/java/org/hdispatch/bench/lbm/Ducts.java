package org.hdispatch.bench.lbm;

import org.hdispatch.cell.Ends;
import org.hdispatch.lbm.Lattice;

/** Square ducts along x. */
public final class Ducts {
  private Ducts() {}

  /** A cube of nodes, periodic along x, walls at the ends of y and z. */
  public static Lattice square(int side) {
    return Lattice.empty(side, side, side, Ends.PERIODIC, Ends.OPEN, Ends.OPEN);
  }
}
