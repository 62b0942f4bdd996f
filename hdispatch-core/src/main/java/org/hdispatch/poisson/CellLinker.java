package org.hdispatch.poisson;

import java.util.Arrays;

/**
 * Collects the links of one cell, node after node, adds up those between the same two nodes, and
 * writes them into the cell. Serves for one cell after the other.
 */
final class CellLinker {
  private GraphCell cell;
  private int node; // in work
  private double ground;
  private double diagonal;

  private final Rows lower = new Rows();
  private final Rows upper = new Rows();
  private int[] lowerStart = {};
  private int[] upperStart = {};

  // To other cells, in the order in which they came; the rows serve again for the next cell.
  private GraphCell[] others = new GraphCell[8];
  private Rows[] halo = new Rows[8];
  private int haloCells;

  /** Links as they come: own node, other node, mobility. */
  private static final class Rows {
    int[] row = new int[64];
    int[] to = new int[64];
    double[] mobility = new double[64];
    int size;
    int begin; // of the row in work

    /** Adds to a link of the row in work, or makes it. */
    void add(int from, int end, double value) {
      if (size == 0 || row[size - 1] != from) {
        begin = size;
      }
      for (int n = begin; n < size; n++) {
        if (to[n] == end) {
          mobility[n] += value;
          return;
        }
      }
      put(from, end, value);
    }

    void put(int from, int end, double value) {
      if (size == to.length) {
        row = Arrays.copyOf(row, 2 * size);
        to = Arrays.copyOf(to, 2 * size);
        mobility = Arrays.copyOf(mobility, 2 * size);
      }
      row[size] = from;
      to[size] = end;
      mobility[size++] = value;
    }

    /** Ends the row in work, and fills its last triple up. */
    int fill(int from) {
      while (size % 3 != 0) {
        put(from, from, 0);
      }
      return size / 3;
    }
  }

  /** Starts a cell, at its first node. */
  void begin(GraphCell next) {
    cell = next;
    node = 0;
    ground = 0;
    diagonal = 0;
    Arrays.fill(others, 0, haloCells, null);
    haloCells = 0;
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
    diagonal += mobility;
    Rows rows = other != cell ? haloRows(other) : otherNode < node ? lower : upper;
    rows.add(node, otherNode, mobility);
  }

  /** The rows of links to another cell; there are few such cells. */
  private Rows haloRows(GraphCell other) {
    int c = 0;
    while (c < haloCells && others[c] != other) {
      c++;
    }
    if (c == haloCells) {
      if (c == others.length) {
        others = Arrays.copyOf(others, 2 * c);
        halo = Arrays.copyOf(halo, 2 * c);
      }
      if (halo[c] == null) {
        halo[c] = new Rows();
      }
      others[c] = other;
      halo[c].size = 0;
      haloCells++;
    }
    return halo[c];
  }

  /** A link of the node in work to a fixed side. */
  void ground(double mobility) {
    ground += mobility;
    diagonal += mobility;
  }

  /** Ends the node in work and goes on to the next. */
  void nextNode() {
    if (ground > 0) {
      if (cell.ground == null) {
        cell.ground = new double[cell.nodes];
      }
      cell.ground[node] = ground;
    }
    cell.inverseDiagonal[node] = diagonal > 0 ? 1 / diagonal : 0;
    ground = 0;
    diagonal = 0;
    lowerStart[node + 1] = lower.fill(node);
    upperStart[node + 1] = upper.fill(node);
    node++;
  }

  /** Ends the cell. */
  void end() {
    cell.lower = links(lowerStart, lower);
    cell.upper = links(upperStart, upper);
    GraphCell[] cells = Arrays.copyOf(others, haloCells);
    int[] end = new int[haloCells];
    int links = 0;
    for (int c = 0; c < haloCells; c++) {
      links += halo[c].size;
      end[c] = links;
    }
    char[] row = new char[links];
    char[] to = new char[links];
    double[] mobility = new double[links];
    int next = 0;
    for (int c = 0; c < haloCells; c++) {
      Rows rows = halo[c];
      for (int n = 0; n < rows.size; n++) {
        row[next] = (char) rows.row[n];
        to[next] = (char) rows.to[n];
        mobility[next++] = rows.mobility[n];
      }
    }
    cell.halo = new HaloLinks(cells, end, row, to, mobility);
  }

  private static Links links(int[] start, Rows rows) {
    char[] to = new char[rows.size];
    for (int n = 0; n < to.length; n++) {
      to[n] = (char) rows.to[n];
    }
    return new Links(start, to, Arrays.copyOf(rows.mobility, rows.size));
  }
}
