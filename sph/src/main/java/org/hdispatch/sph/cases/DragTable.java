package org.hdispatch.sph.cases;

/** A smooth function known at some places, by the cubic through the four nearest of them. */
final class DragTable {
  private final double[] places;
  private final double[] values;

  /** A table of ascending places, four at least. */
  DragTable(double[] places, double[] values) {
    this.places = places;
    this.values = values;
  }

  double at(double place) {
    int first = 0;
    while (first + 4 < places.length && places[first + 2] < place) {
      first++;
    }
    double sum = 0;
    for (int n = first; n < first + 4; n++) {
      double term = values[n];
      for (int m = first; m < first + 4; m++) {
        term *= m == n ? 1 : (place - places[m]) / (places[n] - places[m]);
      }
      sum += term;
    }
    return sum;
  }
}
