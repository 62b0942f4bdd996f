package org.hdispatch.app.draw;

/** Colours as 0xRRGGBB. */
public final class ColourMap {
  /** Solid voxels in all pictures. */
  public static final int SOLID = 0xc8c8c8;

  /** Pore voxels that span the rock along some axis. */
  public static final int PORE = 0x1f5fa8;

  /** Pore voxels that do not. */
  public static final int ISOLATED = 0xe8890c;

  /** Viridis (S. van der Walt, N. Smith 2015, CC0) at nine equal steps from dark to bright. */
  private static final int[] VIRIDIS = {
    0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30, 0xfde725
  };

  private static final int[] PHASES = {PORE, ISOLATED, 0x2a9d5c, 0xb0357a};

  private ColourMap() {}

  /** The colour of a phase of several, by its number; four differ. */
  public static int phase(int number) {
    return PHASES[number % PHASES.length];
  }

  /** The colour of a value from 0 (dark) to 1 (bright). */
  public static int viridis(double value) {
    double place = Math.max(0, Math.min(1, value)) * (VIRIDIS.length - 1);
    int below = Math.min((int) place, VIRIDIS.length - 2);
    double share = place - below;
    int colour = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
      int from = VIRIDIS[below] >> shift & 0xff;
      int to = VIRIDIS[below + 1] >> shift & 0xff;
      colour |= (int) Math.round(from + share * (to - from)) << shift;
    }
    return colour;
  }
}
