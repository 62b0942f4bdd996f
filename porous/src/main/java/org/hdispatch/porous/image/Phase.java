package org.hdispatch.porous.image;

/** What a voxel is made of: the two phases of dry rock. */
public enum Phase {
  /** Void that a fluid can fill. */
  PORE,
  /** Mineral: no fluid enters. */
  SOLID
}
