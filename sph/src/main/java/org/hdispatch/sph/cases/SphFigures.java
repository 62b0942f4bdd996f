package org.hdispatch.sph.cases;

import org.hdispatch.dispatch.LoopStats;
import org.hdispatch.sph.SphTimes;

/**
 * What was measured while particles were stepped.
 *
 * @param particles how many there are, those of solids included
 * @param fluidParticles how many of them move
 * @param cells cells that hold them, after the last step
 * @param threads workers
 * @param warmUpSteps steps before the first that was measured
 * @param stats what the workers did in the measured steps
 * @param seconds wall time of the measured steps by kind of work: the mean of the workers
 * @param rebuilds how often neighbours were searched for in the measured steps
 * @param neighboursMean mean number of neighbours of a fluid particle in the last step, itself not
 *     counted
 * @param heldBytes bytes held for the particles, the workers' scratch apart
 */
public record SphFigures(
    int particles,
    int fluidParticles,
    int cells,
    int threads,
    long warmUpSteps,
    LoopStats stats,
    SphTimes seconds,
    long rebuilds,
    double neighboursMean,
    long heldBytes) {

  /** Wall time of all measured steps, s. */
  public double wallSeconds() {
    return 1e-9 * stats.nanos();
  }

  /** Steps of a fluid particle per second: those of solids do not count. */
  public double particleStepsPerSecond() {
    return fluidParticles * (double) stats.steps() / wallSeconds();
  }

  /** Pairs summed up per second: a pair of fluid particles counts once for each of the two. */
  public double pairsPerSecond() {
    return particleStepsPerSecond() * neighboursMean;
  }

  /** Bytes held for a particle. */
  public double bytesPerParticle() {
    return (double) heldBytes / particles;
  }
}
