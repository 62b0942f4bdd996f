package org.hdispatch.porous.survey;

import java.util.Locale;

/** What became of a job. */
public enum SurveyStatus {
  /** There is a permeability. */
  DONE,
  /** Nothing spans the block: k = 0. */
  DOES_NOT_PERCOLATE,
  /** There is a k, but its error estimate did not come below the tolerance. */
  NOT_CONVERGED,
  /** The block touches voxels outside the sample; nothing was computed. */
  OUTSIDE,
  /** There is no result; the row says why. A restart tries again. */
  FAILED;

  /** Whether there is a permeability that may be relied on, be it 0. */
  public boolean hasPermeability() {
    return this == DONE || this == DOES_NOT_PERCOLATE;
  }

  /** As the row says it: {@code does-not-percolate}. */
  public String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /**
   * The status of a word.
   *
   * @throws IllegalArgumentException if there is none
   */
  static SurveyStatus of(String word) {
    for (SurveyStatus each : values()) {
      if (each.word().equals(word)) {
        return each;
      }
    }
    throw new IllegalArgumentException("status must be known: status=" + word);
  }
}
