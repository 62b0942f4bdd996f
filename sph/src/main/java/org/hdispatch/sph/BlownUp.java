package org.hdispatch.sph;

/** What a run says that blows up; apart from the passes, which then hold no text. */
final class BlownUp {
  private BlownUp() {}

  static BlownUpException tooFast(ParticleArrays particles, int n, double distance, double edge) {
    return new BlownUpException(
        "particle must not move farther than a cell in a step: distance="
            + distance
            + ", edge="
            + edge
            + where(particles, n));
  }

  static BlownUpException leftTheBox(ParticleArrays particles, int n) {
    return new BlownUpException(
        "particle must stay in the box, whose end is open there" + where(particles, n));
  }

  static BlownUpException crowded(int particles) {
    return new BlownUpException(
        "cell and those around it must hold at most "
            + Neighbourhood.MOST
            + " particles: particles="
            + particles);
  }

  private static String where(ParticleArrays particles, int n) {
    return ": particle="
        + particles.id[n]
        + ", x="
        + particles.x[n]
        + ", y="
        + particles.y[n]
        + ", z="
        + particles.z[n];
  }
}
