package org.hdispatch.poisson;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.KeyOrder;
import org.hdispatch.dispatch.Dispatcher;

/**
 * Makes the cells of the next coarser level: their nodes are the aggregates of this one, the
 * mobility of a link the sum of those of all links between two aggregates.
 *
 * <p>A coarse cell has a box of twice the edge, or of the same where its nodes would be too many.
 */
final class CoarseCells {
  /** Most nodes of a cell: many cells make work for many workers, and 16 bits reach them. */
  private static final int MOST_NODES = 8_192;

  private final Dispatcher dispatcher;
  private final CellMap<GraphCell> fine;
  private final int fineEdge;
  private boolean doubled = true;

  private CoarseCells(Dispatcher dispatcher, CellMap<GraphCell> fine, int fineEdge) {
    this.dispatcher = dispatcher;
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
  static Coarser of(Dispatcher dispatcher, CellMap<GraphCell> cells, int edge, long nodes) {
    return new CoarseCells(dispatcher, cells, edge).build(nodes);
  }

  /** Cells of a level and the edge of their boxes, in blocks. */
  record Coarser(CellMap<GraphCell> cells, int edge) {}

  private Coarser build(long nodes) {
    Passes.once(
        dispatcher, fine, () -> new Aggregation(fineEdge), (cell, found) -> found.find(cell));
    long aggregates = 0;
    Map<Long, Integer> counts = new HashMap<>();
    for (int n = 0; n < fine.size(); n++) {
      GraphCell cell = fine.cellAt(n);
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
    Passes.once(dispatcher, coarse, CellLinker::new, CoarseCells::link);
    return new Coarser(coarse, edge);
  }

  private void forget() {
    for (int n = 0; n < fine.size(); n++) {
      fine.cellAt(n).aggregate = null;
      fine.cellAt(n).restricted = null;
      fine.cellAt(n).places = null;
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
    CellMap<GraphCell[]> siblings = CellMap.fixed(keys, KeyOrder.MORTON, children::get);
    Passes.once(dispatcher, siblings, () -> null, (some, none) -> makeParent(some, edge));
    return CellMap.fixed(keys, KeyOrder.MORTON, key -> children.get(key)[0].parent);
  }

  private static GraphCell[] together(GraphCell[] some, GraphCell[] more) {
    GraphCell[] all = Arrays.copyOf(some, some.length + more.length);
    System.arraycopy(more, 0, all, some.length, more.length);
    return all;
  }

  private void makeParent(GraphCell[] children, int edge) {
    int nodes = Arrays.stream(children).mapToInt(child -> child.restricted.length).sum();
    char[] positions = new char[nodes];
    int node = 0;
    int half = fineEdge / 2;
    for (GraphCell child : children) {
      child.parentOffset = node;
      int x0 = doubled ? CellKey.i(child.key) % 2 * half : 0;
      int y0 = doubled ? CellKey.j(child.key) % 2 * half : 0;
      int z0 = doubled ? CellKey.k(child.key) % 2 * half : 0;
      for (char place : child.places) {
        int x = x0 + place % half;
        int y = y0 + place / half % half;
        int z = z0 + place / (half * half);
        positions[node++] = (char) (x + edge * (y + edge * z));
      }
    }
    GraphCell cell = new GraphCell(coarseKey(children[0].key), positions);
    cell.children = children;
    for (GraphCell child : children) {
      child.parent = cell;
      child.places = null;
    }
  }

  private static void link(GraphCell coarse, CellLinker linker) {
    linker.begin(coarse);
    for (GraphCell child : coarse.children) {
      int[] memberStart = starts(child.aggregate, child.restricted.length);
      int[] members = inOrder(child.aggregate, memberStart);
      int[] haloStart = starts(child.halo.row(), child.nodes);
      int[] haloOrder = inOrder(child.halo.row(), haloStart);
      GraphCell[] haloCell = child.halo.cellOfEach();
      for (int aggregate = 0; aggregate < child.restricted.length; aggregate++) {
        for (int m = memberStart[aggregate]; m < memberStart[aggregate + 1]; m++) {
          int node = members[m];
          link(child, node, child.lower, linker);
          link(child, node, child.upper, linker);
          for (int n = haloStart[node]; n < haloStart[node + 1]; n++) {
            int halo = haloOrder[n];
            link(haloCell[halo], child.halo.to()[halo], child.halo.mobility()[halo], linker);
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

  /** Where each number begins among all places that have one, in the order of the numbers. */
  private static int[] starts(char[] numbers, int count) {
    int[] start = new int[count + 1];
    for (char number : numbers) {
      if (number != GraphCell.NONE) {
        start[number + 1]++;
      }
    }
    for (int n = 0; n < count; n++) {
      start[n + 1] += start[n];
    }
    return start;
  }

  /** The places that have a number, in the order of the numbers, those of one in their own. */
  private static int[] inOrder(char[] numbers, int[] starts) {
    int[] next = starts.clone();
    int[] order = new int[starts[starts.length - 1]];
    for (int place = 0; place < numbers.length; place++) {
      if (numbers[place] != GraphCell.NONE) {
        order[next[numbers[place]]++] = place;
      }
    }
    return order;
  }
}
