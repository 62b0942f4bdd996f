package org.hdispatch.lbm;

import java.util.Arrays;
import org.hdispatch.cell.CellMap;

/** Finds the slots that the nodes of a bundle stream from and to, and writes them as a plan. */
final class Linker {
  /** Nodes from which on a segment is collided where it stands. */
  private static final int LEAST_SEGMENT = 8;

  private final VelocitySet set;
  private final BundleSize size;
  private final Surroundings surroundings;
  private final int[] places; // per node: where it lies in the surroundings
  private final int[][] address; // per velocity and node
  private final long[] others = new long[ChunkRows.NODES]; // links of a batch that lead elsewhere
  private final boolean[] breaks; // per node: whether its slots do not follow those before
  private int[] code = new int[1024];
  private int codeLength;
  private char[] links = new char[1024];
  private int linkCount;

  Linker(Lattice lattice, VelocitySet set, BundleSize size, CellMap<NodalBundle> bundles) {
    this.set = set;
    this.size = size;
    surroundings = new Surroundings(lattice, size, bundles);
    places = new int[size.nodes()];
    address = new int[set.size()][size.nodes()];
    Arrays.setAll(address[0], node -> node);
    breaks = new boolean[size.nodes()];
  }

  StreamPlan plan(NodalBundle bundle) {
    codeLength = 0;
    linkCount = 0;
    surroundings.look(bundle);
    findPlaces(bundle);
    Arrays.fill(breaks, 0, bundle.nodes(), false);
    for (int i = 1; i < address.length; i++) {
      surroundings.findAddresses(set, i, places, bundle.nodes(), address[i]);
      findBreaks(address[i], bundle.nodes());
    }
    int segments = writeSegments(bundle.nodes());
    int firstBatch = codeLength;
    int batches = writeBatches(bundle.nodes());
    return new StreamPlan(
        set.size(),
        segments,
        batches,
        firstBatch,
        surroundings.sources(),
        Arrays.copyOf(code, codeLength),
        Arrays.copyOf(links, linkCount));
  }

  private void findPlaces(NodalBundle bundle) {
    bundle.runs().positions(places);
    for (int node = 0; node < bundle.nodes(); node++) {
      int position = places[node];
      int row = position / size.nx();
      places[node] = surroundings.place(position % size.nx(), row % size.ny(), row / size.ny());
    }
  }

  private void findBreaks(int[] row, int nodes) {
    for (int node = 1; node < nodes; node++) {
      breaks[node] |= row[node] != row[node - 1] + 1;
    }
  }

  /** End of the segment that begins at a node. */
  private int segmentEnd(int first, int nodes) {
    int end = first + 1;
    while (end < nodes && !breaks[end]) {
      end++;
    }
    return end;
  }

  private int writeSegments(int nodes) {
    int segments = 0;
    int last = -1; // segment before, in code
    int end;
    for (int first = 0; first < nodes; first = end) {
      end = segmentEnd(first, nodes);
      if (end - first < LEAST_SEGMENT) {
        continue;
      }
      if (last >= 0 && isNextRow(last, first, end - first)) {
        code[last + 3] = first - lastRow(last);
        code[last + 2]++;
        continue;
      }
      last = codeLength;
      append(first);
      append(end - first);
      append(1);
      append(0);
      for (int[] row : address) {
        append(row[first]);
      }
      segments++;
    }
    return segments;
  }

  /** First node of the last row of a segment. */
  private int lastRow(int segment) {
    return code[segment] + (code[segment + 2] - 1) * code[segment + 3];
  }

  /** Whether nodes can be one more row of a segment. */
  private boolean isNextRow(int segment, int first, int n) {
    int before = lastRow(segment);
    int pitch = first - before;
    boolean fits = n == code[segment + 1] && (code[segment + 2] == 1 || pitch == code[segment + 3]);
    for (int i = 0; i < address.length && fits; i++) {
      fits = address[i][first] == address[i][before] + pitch;
    }
    return fits;
  }

  private int writeBatches(int nodes) {
    int[] batch = new int[ChunkRows.NODES];
    int batches = 0;
    int count = 0;
    int end;
    for (int first = 0; first < nodes; first = end) {
      end = segmentEnd(first, nodes);
      for (int node = first; node < end && end - first < LEAST_SEGMENT; node++) {
        if (count == batch.length || count > 0 && node - batch[0] > Character.MAX_VALUE) {
          writeBatch(batch, count);
          batches++;
          count = 0;
        }
        batch[count++] = node;
      }
    }
    if (count > 0) {
      writeBatch(batch, count);
      batches++;
    }
    return batches;
  }

  private void writeBatch(int[] batch, int count) {
    int start = codeLength;
    int firstLink = linkCount;
    append(count);
    append(0);
    append(0);
    for (int[] row : address) {
      writeLinks(row, batch, count);
    }
    code[start + 1] = codeLength - start;
    code[start + 2] = linkCount - firstLink;
  }

  /**
   * Writes the links of one velocity. The place of a link that leads elsewhere is taken by the next
   * that does not: scattering writes there too early, and again when its turn comes.
   */
  private void writeLinks(int[] row, int[] batch, int count) {
    int base = Integer.MAX_VALUE;
    for (int k = 0; k < count; k++) {
      if (row[batch[k]] >>> StreamPlan.INDEX_BITS == 0) {
        base = Math.min(base, row[batch[k]]);
      }
    }
    int within = 0;
    int elsewhere = 0;
    for (int k = 0; k < count; k++) {
      if (isWithin(row[batch[k]], base)) {
        within = k + 1;
      } else {
        others[elsewhere++] = Integer.toUnsignedLong(row[batch[k]]) * ChunkRows.NODES + k;
      }
    }
    append(within == 0 ? 0 : base);
    append(within);
    reserveLinks(within);
    int next = 0;
    for (int k = within - 1; k >= 0; k--) {
      next = isWithin(row[batch[k]], base) ? row[batch[k]] - base : next;
      links[linkCount + k] = (char) next;
    }
    linkCount += within;
    writeGroups(elsewhere);
  }

  /** Writes the links that lead elsewhere: by bundle, and such that 16 bits reach them. */
  private void writeGroups(int elsewhere) {
    Arrays.sort(others, 0, elsewhere);
    int groupsAt = codeLength;
    append(0);
    int end;
    for (int first = 0; first < elsewhere; first = end) {
      int address = (int) (others[first] / ChunkRows.NODES);
      end = first + 1;
      while (end < elsewhere && isReachable(address, (int) (others[end] / ChunkRows.NODES))) {
        end++;
      }
      int members = end - first;
      append(address);
      append(members);
      reserveLinks(2 * members);
      for (int m = 0; m < members; m++) {
        links[linkCount + m] = (char) (others[first + m] % ChunkRows.NODES);
        links[linkCount + members + m] =
            (char) ((int) (others[first + m] / ChunkRows.NODES) - address);
      }
      linkCount += 2 * members;
      code[groupsAt]++;
    }
  }

  private static boolean isReachable(int from, int address) {
    return from >>> StreamPlan.INDEX_BITS == address >>> StreamPlan.INDEX_BITS
        && address - from <= Character.MAX_VALUE;
  }

  private static boolean isWithin(int address, int base) {
    return address >>> StreamPlan.INDEX_BITS == 0 && address - base <= Character.MAX_VALUE;
  }

  private void append(int number) {
    if (codeLength == code.length) {
      code = Arrays.copyOf(code, 2 * codeLength);
    }
    code[codeLength++] = number;
  }

  private void reserveLinks(int more) {
    if (linkCount + more > links.length) {
      links = Arrays.copyOf(links, Math.max(2 * links.length, linkCount + more));
    }
  }
}
