package org.hdispatch.sph;

import java.util.Arrays;
import org.hdispatch.cell.Ends;

/**
 * Distance from spheres, or from cylinders along z. The box is cut into bins; each knows the bodies
 * and images that may be the nearest somewhere in it: those whose surface is at most a diagonal of
 * the bin farther from its middle than the nearest one's.
 */
final class RoundWalls implements WallDistance {
  private static final int MOST_BINS = 64; // along an axis
  private static final int BODY = 4; // x, y, z, radius

  private final ParticleBox box;
  private final boolean flat; // z does not matter
  private final double[] edges = new double[3]; // of a bin
  private final int[] bins = new int[3];
  private final int[] first; // candidate of each bin
  private double[] candidates = new double[64 * BODY];

  RoundWalls(ParticleBox box, boolean flat, double[][] bodies) {
    if (bodies.length == 0) {
      throw new IllegalArgumentException("there must be a cylinder or sphere: bodies=0");
    }
    this.box = box;
    this.flat = flat;
    double along = Math.pow(bodies.length, flat ? 1.0 / 2 : 1.0 / 3);
    int most = (int) Math.min(MOST_BINS, 2 + Math.ceil(2 * along));
    double[] lengths = {box.lx(), box.ly(), flat ? 0 : box.lz()};
    for (int axis = 0; axis < 3; axis++) {
      bins[axis] = axis == 2 && flat ? 1 : most;
      edges[axis] = lengths[axis] / bins[axis];
    }
    double[][] images = images(bodies, lengths);
    first = new int[bins[0] * bins[1] * bins[2] + 1];
    double[] distances = new double[images.length];
    int count = 0;
    for (int bin = 0; bin + 1 < first.length; bin++) {
      count = choose(bin, images, distances, count);
      first[bin + 1] = count;
    }
    candidates = Arrays.copyOf(candidates, count * BODY);
  }

  private double[][] images(double[][] bodies, double[] lengths) {
    int i = box.x() == Ends.PERIODIC ? 1 : 0;
    int j = box.y() == Ends.PERIODIC ? 1 : 0;
    int k = !flat && box.z() == Ends.PERIODIC ? 1 : 0;
    double[][] images = new double[bodies.length * (2 * i + 1) * (2 * j + 1) * (2 * k + 1)][];
    int count = 0;
    for (double[] body : bodies) {
      double x = wrapped(body[0], lengths[0], box.x());
      double y = wrapped(body[1], lengths[1], box.y());
      double z = flat ? 0 : wrapped(body[2], lengths[2], box.z());
      for (int c = -k; c <= k; c++) {
        for (int b = -j; b <= j; b++) {
          for (int a = -i; a <= i; a++) {
            images[count++] =
                new double[] {x + a * lengths[0], y + b * lengths[1], z + c * lengths[2], body[3]};
          }
        }
      }
    }
    return images;
  }

  private int choose(int bin, double[][] images, double[] distances, int count) {
    double x = (bin % bins[0] + 0.5) * edges[0];
    double y = (bin / bins[0] % bins[1] + 0.5) * edges[1];
    double z = (bin / bins[0] / bins[1] + 0.5) * edges[2];
    double least = Double.POSITIVE_INFINITY;
    for (int n = 0; n < images.length; n++) {
      double[] body = images[n];
      distances[n] = length(x - body[0], y - body[1], z - body[2]) - body[3];
      least = Math.min(least, distances[n]);
    }
    double diagonal = length(edges[0], edges[1], edges[2]) * (1 + 1e-9);
    int chosen = count;
    for (int n = 0; n < images.length; n++) {
      if (distances[n] <= least + diagonal) {
        if (BODY * (chosen + 1) > candidates.length) {
          candidates = Arrays.copyOf(candidates, 2 * candidates.length);
        }
        System.arraycopy(images[n], 0, candidates, BODY * chosen, BODY);
        chosen++;
      }
    }
    return chosen;
  }

  @Override
  public double at(double x, double y, double z) {
    double px = wrapped(x, box.lx(), box.x());
    double py = wrapped(y, box.ly(), box.y());
    double pz = flat ? 0 : wrapped(z, box.lz(), box.z());
    int bin = bin(px, 0) + bins[0] * (bin(py, 1) + bins[1] * (flat ? 0 : bin(pz, 2)));
    double least = Double.POSITIVE_INFINITY;
    double[] bodies = candidates;
    int end = BODY * first[bin + 1];
    for (int n = BODY * first[bin]; n < end; n += BODY) {
      double distance = length(px - bodies[n], py - bodies[n + 1], pz - bodies[n + 2]);
      least = Math.min(least, distance - bodies[n + 3]);
    }
    return least;
  }

  private static double wrapped(double place, double length, Ends ends) {
    return ends == Ends.PERIODIC ? place - length * Math.floor(place / length) : place;
  }

  private int bin(double place, int axis) {
    return Math.max(0, Math.min(bins[axis] - 1, (int) (place / edges[axis])));
  }

  private static double length(double dx, double dy, double dz) {
    return Math.sqrt(dx * dx + dy * dy + dz * dz);
  }
}
