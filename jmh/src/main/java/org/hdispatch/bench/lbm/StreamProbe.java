package org.hdispatch.bench.lbm;

import java.util.Arrays;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.TimeLoop;
import org.hdispatch.lbm.Streaming;

/**
 * What a dispatcher's workers can move to and from memory: {@code b[n] = s a[n]} over long arrays,
 * with b the same array as a for streaming in place (16 bytes an element), else another one (24,
 * for a line is read before it is written: McCalpin's STREAM with the write-allocate counted).
 */
final class StreamProbe {
  /** Numbers of a block, the unit of hand-out: 4 MiB. */
  private static final int BLOCK = 1 << 19;

  /** Blocks of an array: 256 MiB, eight times a last-level cache of 32 MiB. */
  private static final int BLOCKS = 64;

  private static final int SWEEPS = 3;

  private final TimeLoop loop;
  private final long bytes; // of a sweep

  /** Makes the arrays; the threads are the dispatcher's. */
  StreamProbe(Dispatcher dispatcher, Streaming streaming) {
    boolean inPlace = streaming == Streaming.IN_PLACE;
    CellMap<Block> blocks =
        CellMap.fixed(
            CellGrid.of(BLOCKS, 1, 1, Ends.OPEN).keys(),
            KeyOrder.ROW,
            key -> new Block(inPlace, CellKey.i(key)));
    bytes = (inPlace ? 2L : 3L) * BLOCKS * BLOCK * Double.BYTES;
    loop =
        dispatcher.loop(
            Scheme.of(blocks).pass("stream", (block, none, tick) -> block.scale()).build());
    measure(); // until compiled
  }

  /** Bytes moved in a nanosecond, which is GB/s: the median of a few sweeps. */
  double measure() {
    double[] readings = new double[SWEEPS];
    for (int n = 0; n < SWEEPS; n++) {
      long begin = System.nanoTime();
      loop.run(1);
      readings[n] = (double) bytes / (System.nanoTime() - begin);
    }
    Arrays.sort(readings);
    return readings[SWEEPS / 2];
  }

  private static final class Block {
    private final double[] from = new double[BLOCK];
    private final double[] to;

    Block(boolean inPlace, int number) {
      Arrays.fill(from, 1 + number);
      to = inPlace ? from : new double[BLOCK];
    }

    void scale() {
      scale(from, to, 1.0000001);
    }

    private static void scale(double[] from, double[] to, double factor) {
      for (int n = 0; n < BLOCK; n++) {
        to[n] = factor * from[n];
      }
    }
  }
}
