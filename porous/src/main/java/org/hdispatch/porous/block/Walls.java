package org.hdispatch.porous.block;

/** How the walls of the pores are made. */
public enum Walls {
  /** Half-way bounce-back between pore and solid voxels. */
  BOUNCE_BACK,
  /** Immersed moving boundaries: voxels may be solid in part. */
  IMB
}
