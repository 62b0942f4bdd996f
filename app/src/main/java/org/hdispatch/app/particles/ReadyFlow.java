package org.hdispatch.app.particles;

import java.util.List;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.SphScheme;
import org.hdispatch.sph.SphSchemeBuilder;

/** A flow of particles, ready to run, of which something is known. */
interface ReadyFlow {
  /** Settings of the scheme. */
  SphSchemeBuilder settings();

  /** The particles to begin with. */
  Particles particles();

  /** Distance of particles, in the flow's unit of length. */
  double spacing();

  /** Time after which all that is known can be compared, in the flow's unit. */
  double duration();

  /**
   * What is found, beside what is known. The first says best how right the flow is.
   *
   * @param scheme after its steps
   * @param time since the flow began
   */
  List<Finding> findings(SphScheme scheme, double time);

  /**
   * A quantity that is known.
   *
   * @param key of the quantity, for programs
   * @param name for people
   * @param found what the particles say
   * @param known what is right
   * @param error share by which it is wrong, of a quantity that the name tells
   */
  record Finding(String key, String name, double found, double known, double error) {
    /** A quantity whose error counts over itself. */
    static Finding of(String key, String name, double found, double known) {
      return new Finding(key, name, found, known, found / known - 1);
    }

    /** A quantity of which a bound is known: it is wrong by what it lies above. */
    static Finding notAbove(String key, String name, double found, double bound) {
      return new Finding(key, name, found, bound, Math.max(0, found / bound - 1));
    }
  }
}
