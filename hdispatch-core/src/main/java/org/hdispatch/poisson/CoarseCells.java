package org.hdispatch.poisson;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.KeyOrder;

/**
 * Makes the cells of the next coarser level: their nodes are the aggregates of this one, the
 * mobility of a link the sum of those of all links between two aggregates.
 *
 * <p>A coarse cell has a box of twice the edge, or of the same where its nodes would be too many.
 */
final class CoarseCells {
  /** Most nodes of a cell: many cells make work for many workers, and 16 bits reach them. */
  private static final int MOST_NODES = 8_192;

  private final CellMap<GraphCell> fine;
  private final Map<GraphCell, char[]> places = new HashMap<>(); // of the aggregates
  private final int fineEdge;
  private boolean doubled = true;

  private CoarseCells(CellMap<GraphCell> fine, int fineEdge) {
    this.fine = fine;
    this.fineEdge = fineEdge;
  }

  /**
   * The coarser level.
   *
   * @param cells cells of a level
   * @param edge blocks to the edge of their boxes, even
   * @param nodes of the level
   * @return the cells and their edge; null if there is no use in it: no aggregate has a link, or
   *     there are nearly as many aggregates as nodes
   */
  static Coarser of(CellMap<GraphCell> cells, int edge, long nodes) {
    return new CoarseCells(cells, edge).build(nodes);
  }

  /** Cells of a level and the edge of their boxes, in blocks. */
  record Coarser(CellMap<GraphCell> cells, int edge) {}

  private Coarser build(long nodes) {
    Aggregation aggregation = new Aggregation(fineEdge);
    long aggregates = 0;
    Map<Long, Integer> counts = new HashMap<>();
    for (int n = 0; n < fine.size(); n++) {
      GraphCell cell = fine.cellAt(n);
      places.put(cell, aggregation.of(cell));
      aggregates += cell.restricted.length;
      counts.merge(coarseKey(cell.key), cell.restricted.length, Integer::sum);
    }
    doubled = counts.values().stream().allMatch(count -> count <= MOST_NODES);
    int edge = doubled ? fineEdge : fineEdge / 2;
    if (aggregates == 0 || aggregates > 0.9 * nodes || edge % 2 != 0) {
      forget();
      return null;
    }
    CellMap<GraphCell> coarse = family(edge);
    CellLinker linker = new CellLinker();
    for (int n = 0; n < coarse.size(); n++) {
      link(coarse.cellAt(n), linker);
    }
    return new Coarser(coarse, edge);
  }

  private void forget() {
    for (int n = 0; n < fine.size(); n++) {
      fine.cellAt(n).aggregate = null;
      fine.cellAt(n).restricted = null;
    }
  }

  private long coarseKey(long key) {
    return doubled ? CellKey.of(CellKey.i(key) / 2, CellKey.j(key) / 2, CellKey.k(key) / 2) : key;
  }

  /** Makes the cells, each with its children. */
  private CellMap<GraphCell> family(int edge) {
    Map<Long, GraphCell[]> children = new TreeMap<>();
    for (int n = 0; n < fine.size(); n++) {
      GraphCell cell = fine.cellAt(n);
      if (cell.restricted.length > 0) {
        children.merge(coarseKey(cell.key), new GraphCell[] {cell}, CoarseCells::together);
      }
    }
    long[] keys = children.keySet().stream().mapToLong(Long::longValue).toArray();
    return CellMap.fixed(keys, KeyOrder.MORTON, key -> parent(key, children.get(key), edge));
  }

  private static GraphCell[] together(GraphCell[] some, GraphCell[] more) {
    GraphCell[] all = Arrays.copyOf(some, some.length + more.length);
    System.arraycopy(more, 0, all, some.length, more.length);
    return all;
  }

  private GraphCell parent(long key, GraphCell[] children, int edge) {
    int nodes = Arrays.stream(children).mapToInt(child -> child.restricted.length).sum();
    char[] positions = new char[nodes];
    int node = 0;
    int half = fineEdge / 2;
    for (GraphCell child : children) {
      child.parentOffset = node;
      int x0 = doubled ? CellKey.i(child.key) % 2 * half : 0;
      int y0 = doubled ? CellKey.j(child.key) % 2 * half : 0;
      int z0 = doubled ? CellKey.k(child.key) % 2 * half : 0;
      for (char place : places.get(child)) {
        int x = x0 + place % half;
        int y = y0 + place / half % half;
        int z = z0 + place / (half * half);
        positions[node++] = (char) (x + edge * (y + edge * z));
      }
    }
    GraphCell cell = new GraphCell(key, positions);
    cell.children = children;
    for (GraphCell child : children) {
      child.parent = cell;
    }
    return cell;
  }

  private static void link(GraphCell coarse, CellLinker linker) {
    linker.begin(coarse);
    for (GraphCell child : coarse.children) {
      int[][] members = members(child);
      int[] haloOrder = inOrderOfRows(child);
      int[] haloStart = haloStart(child);
      for (int[] aggregate : members) {
        for (int node : aggregate) {
          link(child, node, child.lower, linker);
          link(child, node, child.upper, linker);
          for (int n = haloStart[node]; n < haloStart[node + 1]; n++) {
            int halo = haloOrder[n];
            link(child.halo.cell(halo), child.halo.to()[halo], child.halo.mobility()[halo], linker);
          }
          if (child.ground != null) {
            linker.ground(child.ground[node]);
          }
        }
        linker.nextNode();
      }
    }
    linker.end();
  }

  private static void link(GraphCell cell, int node, Links links, CellLinker linker) {
    for (int n = links.begin(node); n < links.end(node); n++) {
      if (links.mobility()[n] > 0) {
        link(cell, links.to()[n], links.mobility()[n], linker);
      }
    }
  }

  private static void link(GraphCell other, int node, double mobility, CellLinker linker) {
    linker.link(other.parent, other.parentOffset + other.aggregate[node], mobility);
  }

  /** First halo link of each row among those in the order of rows. */
  private static int[] haloStart(GraphCell cell) {
    int[] start = new int[cell.nodes + 1];
    for (char row : cell.halo.row()) {
      start[row + 1]++;
    }
    for (int m = 0; m < cell.nodes; m++) {
      start[m + 1] += start[m];
    }
    return start;
  }

  private static int[] inOrderOfRows(GraphCell cell) {
    int[] next = haloStart(cell);
    int[] order = new int[cell.halo.row().length];
    for (int n = 0; n < order.length; n++) {
      order[next[cell.halo.row()[n]]++] = n;
    }
    return order;
  }

  /** The nodes of each aggregate of a cell. */
  private static int[][] members(GraphCell cell) {
    int[] counts = new int[cell.restricted.length];
    for (char aggregate : cell.aggregate) {
      if (aggregate != GraphCell.NONE) {
        counts[aggregate]++;
      }
    }
    int[][] members = new int[counts.length][];
    for (int n = 0; n < counts.length; n++) {
      members[n] = new int[counts[n]];
    }
    for (int node = cell.nodes - 1; node >= 0; node--) {
      char aggregate = cell.aggregate[node];
      if (aggregate != GraphCell.NONE) {
        members[aggregate][--counts[aggregate]] = node;
      }
    }
    return members;
  }
}
