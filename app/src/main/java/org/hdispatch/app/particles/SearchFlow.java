package org.hdispatch.app.particles;

import java.util.function.Supplier;
import org.hdispatch.sph.Particles;
import org.hdispatch.sph.SphSchemeBuilder;

/**
 * Particles at a distance of 1 that searches of neighbours are compared on, in steps of 1.
 *
 * @param name for people
 * @param settings makes settings of the scheme, of which the search and its cells may be chosen
 * @param particles the particles
 */
record SearchFlow(String name, Supplier<SphSchemeBuilder> settings, Particles particles) {}
