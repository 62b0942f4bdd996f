package org.hdispatch.poisson;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Collects the links of one cell, node after node, adds up those between the same two nodes, and
 * writes them into the cell. Serves for one cell after the other.
 */
final class CellLinker {
  private GraphCell cell;
  private int node; // in work
  private double ground;
  private double diagonal;

  private final List<GraphCell> haloCells = new ArrayList<>();
  private final List<int[]> haloPlaces = new ArrayList<>(); // by node of the halo cell; -1: none
  private int extent;

  // Links of the node in work: other ends and mobilities; place + 1 among them by other end.
  private int[] ends = new int[16];
  private double[] mobilities = new double[16];
  private int[] placeOf = new int[16];
  private int degree;

  private int[] lowerStart = {};
  private int[] upperStart = {};
  private final Growing lower = new Growing();
  private final Growing upper = new Growing();

  /** Links of one side of the rows, growing. */
  private static final class Growing {
    int[] to = new int[64];
    double[] mobility = new double[64];
    int size;

    void add(int end, double value) {
      if (size == to.length) {
        to = Arrays.copyOf(to, 2 * size);
        mobility = Arrays.copyOf(mobility, 2 * size);
      }
      to[size] = end;
      mobility[size++] = value;
    }
  }

  /** Starts a cell, at its first node. */
  void begin(GraphCell next) {
    cell = next;
    node = 0;
    degree = 0;
    ground = 0;
    diagonal = 0;
    haloCells.clear();
    haloPlaces.clear();
    extent = cell.nodes;
    lower.size = 0;
    upper.size = 0;
    lowerStart = new int[cell.nodes + 1];
    upperStart = new int[cell.nodes + 1];
    cell.inverseDiagonal = new double[cell.nodes];
    cell.ground = null;
  }

  /** A link of the node in work, to a node of any cell; to itself, or of mobility 0, it is none. */
  void link(GraphCell other, int otherNode, double mobility) {
    if (mobility == 0 || other == cell && otherNode == node) {
      return;
    }
    int end = other == cell ? otherNode : haloEnd(other, otherNode);
    if (end >= placeOf.length) {
      placeOf = Arrays.copyOf(placeOf, 2 * end);
    }
    diagonal += mobility;
    if (placeOf[end] > 0) {
      mobilities[placeOf[end] - 1] += mobility;
      return;
    }
    if (degree == ends.length) {
      ends = Arrays.copyOf(ends, 2 * degree);
      mobilities = Arrays.copyOf(mobilities, 2 * degree);
    }
    ends[degree] = end;
    mobilities[degree++] = mobility;
    placeOf[end] = degree;
  }

  /** A link of the node in work to a fixed side. */
  void ground(double mobility) {
    ground += mobility;
    diagonal += mobility;
  }

  private int haloEnd(GraphCell other, int otherNode) {
    int at = haloCells.indexOf(other);
    if (at < 0) {
      at = haloCells.size();
      haloCells.add(other);
      int[] places = new int[other.nodes];
      Arrays.fill(places, -1);
      haloPlaces.add(places);
    }
    int[] places = haloPlaces.get(at);
    if (places[otherNode] < 0) {
      places[otherNode] = extent++;
    }
    return places[otherNode];
  }

  /** Ends the node in work and goes on to the next. */
  void nextNode() {
    for (int n = 0; n < degree; n++) {
      (ends[n] < node ? lower : upper).add(ends[n], mobilities[n]);
      placeOf[ends[n]] = 0;
    }
    if (ground > 0) {
      if (cell.ground == null) {
        cell.ground = new double[cell.nodes];
      }
      cell.ground[node] = ground;
    }
    cell.inverseDiagonal[node] = diagonal > 0 ? 1 / diagonal : 0;
    degree = 0;
    ground = 0;
    diagonal = 0;
    node++;
    lowerStart[node] = lower.size;
    upperStart[node] = upper.size;
  }

  /** Ends the cell: its halo is sorted by cell and node, so that it is gathered in runs. */
  void end() {
    int[] sorted = new int[extent];
    for (int n = 0; n < cell.nodes; n++) {
      sorted[n] = n;
    }
    cell.haloCells = haloCells.toArray(new GraphCell[0]);
    cell.haloEnd = new int[cell.haloCells.length];
    cell.haloNodes = new char[extent - cell.nodes];
    int next = 0;
    for (int c = 0; c < cell.haloCells.length; c++) {
      int[] places = haloPlaces.get(c);
      for (int n = 0; n < places.length; n++) {
        if (places[n] >= 0) {
          sorted[places[n]] = cell.nodes + next;
          cell.haloNodes[next++] = (char) n;
        }
      }
      cell.haloEnd[c] = next;
    }
    cell.lower = links(lowerStart, lower, sorted);
    cell.upper = links(upperStart, upper, sorted);
  }

  private static Links links(int[] start, Growing links, int[] sorted) {
    char[] to = new char[links.size];
    for (int n = 0; n < to.length; n++) {
      to[n] = (char) sorted[links.to[n]];
    }
    return new Links(start, to, Arrays.copyOf(links.mobility, links.size));
  }
}
