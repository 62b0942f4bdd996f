package org.hdispatch.sph;

/** The viscosity that two particles of unlike phases share. */
public enum ViscosityMean {
  /** (mu_i + mu_j)/2 (Morris, Fox, Zhu 1997). */
  ARITHMETIC,
  /** 2 mu_i mu_j/(mu_i + mu_j): the stress is the same on both sides (Hu, Adams 2006). */
  HARMONIC
}
