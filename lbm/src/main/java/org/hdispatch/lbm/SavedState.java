package org.hdispatch.lbm;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import org.hdispatch.cell.CellMap;

/**
 * The state of a scheme on its way to a stream and back: a number that tells schemes of other nodes
 * apart, then what left each node, chunk by chunk, velocity by velocity.
 */
final class SavedState {
  // The texts of errors stand here and not in the scheme: HotSpot makes those of a class when C2 is
  // first asked to compile one of its methods, and the scheme's run in steps.

  private final long box; // tells lattices of other extents, ends or velocities apart
  private final CellMap<NodalBundle> bundles;
  private final Phase phase;

  SavedState(Lattice lattice, VelocitySet set, CellMap<NodalBundle> bundles, Phase phase) {
    long extents = mix(mix(mix(set.size(), lattice.nx()), lattice.ny()), lattice.nz());
    int ends = lattice.x().ordinal() + 2 * lattice.y().ordinal() + 4 * lattice.z().ordinal();
    box = mix(extents, ends);
    this.bundles = bundles;
    this.phase = phase;
  }

  void write(Immersion immersion, LbmScheme.Scratch scratch, DataOutput out) throws IOException {
    if (immersion != null) {
      throw new IllegalStateException(
          "state must be of fluid alone to be saved: immersion=" + immersion);
    }
    out.writeLong(fingerprint());
    for (int n = 0; n < bundles.size(); n++) {
      scratch.cursor.begin(bundles.cellAt(n).plan());
      while (scratch.cursor.next()) {
        scratch.cursor.read(phase.previous(), phase.streamed(), scratch.chunk);
        scratch.chunk.widen(scratch.cursor.nodes());
        for (double[] row : scratch.chunk.wide) {
          for (int k = 0; k < scratch.cursor.nodes(); k++) {
            out.writeDouble(row[k]);
          }
        }
      }
    }
  }

  void read(LbmScheme.Scratch scratch, DataInput in) throws IOException {
    long saved = in.readLong();
    if (saved != fingerprint()) {
      throw new IllegalArgumentException(
          "state must be of the same nodes, lattice and bundles: saved="
              + Long.toHexString(saved)
              + ", here="
              + Long.toHexString(fingerprint()));
    }
    for (int n = 0; n < bundles.size(); n++) {
      scratch.cursor.begin(bundles.cellAt(n).plan());
      while (scratch.cursor.next()) {
        for (double[] row : scratch.chunk.wide) {
          for (int k = 0; k < scratch.cursor.nodes(); k++) {
            row[k] = in.readDouble();
          }
        }
        scratch.chunk.narrow(scratch.cursor.nodes());
        scratch.cursor.write(phase.previous(), phase.streamed(), scratch.chunk);
      }
    }
  }

  /** Differs between schemes of other nodes, lattices or bundles. */
  private long fingerprint() {
    long print = box;
    for (int n = 0; n < bundles.size(); n++) {
      NodalBundle bundle = bundles.cellAt(n);
      print = mix(print, bundle.key());
      for (int node = 0; node < bundle.nodes(); node++) {
        int place = bundle.position(node); // looked up once
        print = mix(mix(mix(print, bundle.xAt(place)), bundle.yAt(place)), bundle.zAt(place));
      }
    }
    return print;
  }

  private static long mix(long print, long number) {
    return (print ^ number) * 0x9E3779B97F4A7C15L; // 2^64 over the golden ratio
  }
}
