package org.hdispatch.sph;

/** What a run says that blows up; apart from the passes, which then hold no text. */
final class BlownUp {
  private BlownUp() {}

  static IllegalStateException tooFast(
      ParticleArrays particles, int n, double distance, double edge) {
    return new IllegalStateException(
        "particle must not move farther than a cell in a step: distance="
            + distance
            + ", edge="
            + edge
            + where(particles, n));
  }

  static IllegalStateException leftTheBox(ParticleArrays particles, int n) {
    return new IllegalStateException(
        "particle must stay in the box, whose end is open there" + where(particles, n));
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
