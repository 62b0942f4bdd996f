package org.hdispatch.porous.pore;

/**
 * The runs of a pore space: the longest lines of pore voxels along x, numbered in file order.
 *
 * <p>A row is the nx voxels of one (y, z), numbered {@code y + ny*z}.
 */
final class Runs {
  private final int nx;
  private final int[] firstOfRow;
  private final int[] starts;
  private final int[] ends;

  private Runs(int nx, int[] firstOfRow, int[] starts, int[] ends) {
    this.nx = nx;
    this.firstOfRow = firstOfRow;
    this.starts = starts;
    this.ends = ends;
  }

  static Runs of(PoreSpace space) {
    byte[] pore = space.flags();
    int nx = space.nx();
    int rows = space.ny() * space.nz();
    int[] firstOfRow = new int[rows + 1];
    int count = 0;
    for (int row = 0; row < rows; row++) {
      firstOfRow[row] = count;
      byte previous = PoreSpace.SOLID;
      for (int i = row * nx, end = i + nx; i < end; i++) {
        count += pore[i] & ~previous; // 1 exactly where a run starts
        previous = pore[i];
      }
    }
    firstOfRow[rows] = count;
    int[] starts = new int[count];
    int[] ends = new int[count];
    int run = 0;
    for (int row = 0; row < rows; row++) {
      int i = row * nx;
      int end = i + nx;
      while (i < end) {
        while (i < end && pore[i] == PoreSpace.SOLID) {
          i++;
        }
        if (i < end) {
          starts[run] = i;
          while (i < end && pore[i] != PoreSpace.SOLID) {
            i++;
          }
          ends[run++] = i;
        }
      }
    }
    return new Runs(nx, firstOfRow, starts, ends);
  }

  int count() {
    return starts.length;
  }

  int rows() {
    return firstOfRow.length - 1;
  }

  /** First run of a row; the row after the last gives the number of runs. */
  int firstOf(int row) {
    return firstOfRow[row];
  }

  /** Flat place of the first voxel of a run. */
  int start(int run) {
    return starts[run];
  }

  /** Flat place after the last voxel of a run. */
  int end(int run) {
    return ends[run];
  }

  int length(int run) {
    return ends[run] - starts[run];
  }

  /** Joins the runs of two rows that overlap in x; {@code step} is the period between the rows. */
  void joinRows(RunForest forest, int from, int to, int step) {
    int a = firstOfRow[from];
    int b = firstOfRow[to];
    int aLast = firstOfRow[from + 1];
    int bLast = firstOfRow[to + 1];
    int shift = (to - from) * nx;
    while (a < aLast && b < bLast) {
      int aStart = starts[a] + shift;
      int aEnd = ends[a] + shift;
      if (aStart < ends[b] && starts[b] < aEnd) {
        forest.join(a, b, step);
      }
      if (aEnd < ends[b]) {
        a++;
      } else {
        b++;
      }
    }
  }

  /** Joins the run at the end of a row to the one at its start, around the period. */
  void joinEndToStart(RunForest forest, int row, int step) {
    int first = firstOfRow[row];
    int last = firstOfRow[row + 1] - 1;
    if (first <= last && starts[first] == row * nx && ends[last] == row * nx + nx) {
      forest.join(last, first, step);
    }
  }
}
