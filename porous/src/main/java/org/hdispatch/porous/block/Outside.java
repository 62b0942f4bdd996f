package org.hdispatch.porous.block;

/** What is done with a block that reaches outside the sample. */
public enum Outside {
  /** It is flagged, and nothing is computed. */
  FLAG,
  /** Its voxels outside are solid, and do not count in porosity. */
  CUT
}
