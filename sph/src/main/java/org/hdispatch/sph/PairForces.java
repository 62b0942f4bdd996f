package org.hdispatch.sph;

import java.util.Objects;

/**
 * Forces between pairs of particles that make surfaces contract and fluids wet walls (Tartakovsky,
 * Meakin 2005):
 *
 * <pre>
 * F_i&lt;-j = s_ij f(r/H) (r_i - r_j)/r
 * </pre>
 *
 * <p>with the support radius H. {@link MeanField} finds s for a surface tension and a contact
 * angle.
 */
public final class PairForces {
  private final PairProfile profile;
  private final double[][] strengths;

  /**
   * Forces of these strengths.
   *
   * @param profile f
   * @param strengths s by the numbers of the two phases, forces; those of two solids do nothing
   * @throws IllegalArgumentException if they are not a symmetric matrix of finite numbers
   */
  public PairForces(PairProfile profile, double[][] strengths) {
    this.profile = Objects.requireNonNull(profile, "profile");
    int size = strengths.length;
    this.strengths = new double[size][];
    for (int a = 0; a < size; a++) {
      if (strengths[a].length != size) {
        throw new IllegalArgumentException(
            "pair strengths must be a square matrix: rows="
                + size
                + ", columns="
                + strengths[a].length);
      }
      for (int b = 0; b < size; b++) {
        double s = strengths[a][b];
        if (!(Double.isFinite(s) && strengths[b].length == size && s == strengths[b][a])) {
          throw new IllegalArgumentException(
              "pair strengths must be finite and symmetric: s(" + a + ", " + b + ")=" + s);
        }
      }
      this.strengths[a] = strengths[a].clone();
    }
  }

  /** Shape of the force. */
  public PairProfile profile() {
    return profile;
  }

  /** s of two phases. */
  public double strength(int a, int b) {
    return strengths[a][b];
  }

  /** Number of phases. */
  public int phases() {
    return strengths.length;
  }

  /** s of a phase with all phases, in their order. */
  double[] strengths(int phase) {
    return strengths[phase];
  }
}
