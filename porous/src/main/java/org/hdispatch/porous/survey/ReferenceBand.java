package org.hdispatch.porous.survey;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Permeability against porosity as laboratories found it in many samples, to lay points over. */
public enum ReferenceBand {
  /**
   * Lucia's rock-fabric numbers L of carbonates; his classes are L = 0.5 to 1.5 (1: grainstone), to
   * 2.5 (2: grain-dominated packstone) and to 4 (3: mud-dominated). The global transform of
   * Jennings and Lucia (2003):
   *
   * <pre>
   *   log10 k[mD] = (9.7982 - 12.0838 log10 L) + (8.6711 - 8.2965 log10 L) log10 phi
   * </pre>
   *
   * The constants are as quoted elsewhere, not compared with the paper. A second quotation, in
   * natural logarithms, has the same 12.08, 8.671 and 3.603 = 8.2965/ln 10, and 27.56 for 9.7982 ln
   * 10 = 22.56, which looks like a misprint.
   */
  LUCIA(
      "Lucia, rock-fabric number L (carbonates)",
      "Jennings & Lucia 2003, SPE Res. Eval. Eng. 6(4), 215-225, global transform: log10 k[mD] ="
          + " (9.7982 - 12.0838 log10 L) + (8.6711 - 8.2965 log10 L) log10 phi, phi interparticle"
          + " porosity; constants as quoted elsewhere, not compared with the paper") {
    @Override
    public List<Curve> curves() {
      List<Curve> curves = new ArrayList<>();
      for (int number = 1; number <= 4; number++) {
        double log = Math.log10(number);
        curves.add(
            new Curve(
                "L = " + number,
                List.of(new Power(Math.pow(10, 9.7982 - 12.0838 * log), 8.6711 - 8.2965 * log)),
                0,
                1));
      }
      return curves;
    }
  },

  /**
   * Fontainebleau sandstone, grains of about 250 um, porosity 2 to 30 %, phi in percent:
   *
   * <pre>
   *   k[mD] = 2.75e-5 phi^7.33 below about 8 %, 0.303 phi^3.05 above
   * </pre>
   *
   * The two cross at 8.8 %; there one goes over into the other here (at 8 % there would be a step
   * by a factor of 1.5).
   */
  FONTAINEBLEAU(
      "Fontainebleau sandstone",
      "Bourbie & Zinszner 1985, J. Geophys. Res. 90, 11524-11532, as quoted by Wangen, Physical"
          + " Principles of Sedimentary Basin Analysis, p. 17: k[mD] = 0.303 phi^3.05 above about"
          + " 8 %, 2.75e-5 phi^7.33 below, phi in percent, 2 to 30 %; joined where they cross,"
          + " 8.8 %") {
    @Override
    public List<Curve> curves() {
      return List.of(
          new Curve(
              "Fontainebleau",
              List.of(
                  new Power(2.75e-5 * Math.pow(100, 7.33), 7.33),
                  new Power(0.303 * Math.pow(100, 3.05), 3.05)),
              0.02,
              0.30));
    }
  };

  private final String title;
  private final String source;

  ReferenceBand(String title, String source) {
    this.title = title;
    this.source = source;
  }

  /**
   * A power law, k = factor phi^exponent.
   *
   * @param factor mD
   * @param exponent of the porosity, a fraction
   */
  private record Power(double factor, double exponent) {
    double permeability(double porosity) {
      return factor * Math.pow(porosity, exponent);
    }
  }

  /** Permeability against porosity; of several power laws, the least counts. */
  public static final class Curve {
    private final String name;
    private final List<Power> laws;
    private final double least;
    private final double most;

    private Curve(String name, List<Power> laws, double least, double most) {
      this.name = name;
      this.laws = laws;
      this.least = least;
      this.most = most;
    }

    /** What it is called, {@code L = 2}. */
    public String name() {
      return name;
    }

    /** Whether it says anything about rocks of this porosity. */
    public boolean reaches(double porosity) {
      return porosity >= least && porosity <= most;
    }

    /**
     * Permeability, mD.
     *
     * @param porosity a fraction
     */
    public double permeability(double porosity) {
      return laws.stream().mapToDouble(law -> law.permeability(porosity)).min().orElseThrow();
    }
  }

  /** As the command line has it. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** What it is. */
  public String title() {
    return title;
  }

  /** Where it comes from, with its formula. */
  public String source() {
    return source;
  }

  /** Its curves, the most permeable first. */
  public abstract List<Curve> curves();
}
