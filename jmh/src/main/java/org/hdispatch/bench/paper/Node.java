package org.hdispatch.bench.paper;

/** A lattice point as an object: two copies of its populations, less their weights. */
interface Node {
  /** Population i of a copy. */
  double get(int copy, int i);

  /** Sets population i of a copy. */
  void set(int copy, int i, double population);

  /** Populations in arrays of numbers. */
  final class Plain implements Node {
    private final double[][] copies;

    Plain(int velocities) {
      copies = new double[2][velocities];
    }

    @Override
    public double get(int copy, int i) {
      return copies[copy][i];
    }

    @Override
    public void set(int copy, int i, double population) {
      copies[copy][i] = population;
    }
  }

  /** Populations in arrays of objects: each that is set is a new one. */
  final class Boxed implements Node {
    private final Double[][] copies;

    Boxed(int velocities) {
      copies = new Double[2][velocities];
    }

    @Override
    public double get(int copy, int i) {
      return copies[copy][i];
    }

    @Override
    public void set(int copy, int i, double population) {
      copies[copy][i] = population;
    }
  }
}
