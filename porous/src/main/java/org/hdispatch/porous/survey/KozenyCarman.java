package org.hdispatch.porous.survey;

import java.util.Optional;
import org.hdispatch.porous.darcy.Permeability;

/**
 * The Kozeny-Carman relation laid through points: k = C phi³/(1 - phi)². Its one constant is that
 * of the mean logarithm of k (1 - phi)²/phi³.
 *
 * <p>The same relation for a packing of spheres of diameter d is k = d² phi³/(180 (1 - phi)²)
 * (Carman 1937, Trans. Inst. Chem. Eng. 15, 150-166).
 *
 * @param points how many there are
 * @param constant C, mD
 * @param error standard error of ln C, which is about that of C as a share of it; NaN of one point
 * @param scatter standard deviation of ln k about the curve; NaN of one point
 */
public record KozenyCarman(int points, double constant, double error, double scatter) {
  /** Of a packing of spheres (Carman 1937). */
  private static final double SPHERES = 180;

  /** Formula and sources, for legends and tables. */
  public static final String SOURCE =
      "k = C phi^3/(1 - phi)^2 (Kozeny 1927, Carman 1937), C fitted here: mean of ln(k (1 -"
          + " phi)^2/phi^3) over the points drawn";

  private static double shape(double porosity) {
    return porosity * porosity * porosity / ((1 - porosity) * (1 - porosity));
  }

  /**
   * The relation through some points.
   *
   * @param porosity fractions
   * @param permeability of the same points, mD
   * @return empty if there is no point that has a logarithm: 0 &lt; phi &lt; 1 and k &gt; 0
   */
  public static Optional<KozenyCarman> fit(double[] porosity, double[] permeability) {
    int count = 0;
    double sum = 0;
    double[] logs = new double[porosity.length];
    for (int n = 0; n < porosity.length; n++) {
      boolean hasLog = porosity[n] > 0 && porosity[n] < 1 && permeability[n] > 0;
      if (hasLog) {
        logs[count] = Math.log(permeability[n] / shape(porosity[n]));
        sum += logs[count++];
      }
    }
    if (count == 0) {
      return Optional.empty();
    }
    double mean = sum / count;
    double squares = 0;
    for (int n = 0; n < count; n++) {
      squares += (logs[n] - mean) * (logs[n] - mean);
    }
    double scatter = count > 1 ? Math.sqrt(squares / (count - 1)) : Double.NaN;
    return Optional.of(
        new KozenyCarman(count, Math.exp(mean), scatter / Math.sqrt(count), scatter));
  }

  /**
   * Permeability on the curve, mD.
   *
   * @param porosity a fraction below 1
   */
  public double permeability(double porosity) {
    return constant * shape(porosity);
  }

  /** Diameter of the spheres whose packing has this constant, m. */
  public double sphereDiameter() {
    return Math.sqrt(SPHERES * constant * 1e-3 * Permeability.DARCY);
  }
}
