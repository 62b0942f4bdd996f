package org.hdispatch.poisson;

/**
 * Links from the nodes of a cell to those of others, cell by cell and row by row.
 *
 * @param cells the other cells
 * @param end of the links to each of them
 * @param row own node of each link
 * @param to node of the other cell
 * @param mobility of each link, positive
 */
record HaloLinks(GraphCell[] cells, int[] end, char[] row, char[] to, double[] mobility) {
  long bytes() {
    return 12L * cells.length + 12L * row.length;
  }

  /** The cell at the other end of each link. */
  GraphCell[] cellOfEach() {
    GraphCell[] each = new GraphCell[row.length];
    for (int c = 0, link = 0; c < cells.length; c++) {
      for (; link < end[c]; link++) {
        each[link] = cells[c];
      }
    }
    return each;
  }
}
