package org.hdispatch.app.lattice;

import java.util.Locale;
import org.hdispatch.app.console.StatusLine;

/** Shows how far a sweep is, and when it will be done. */
final class SweepProgress {
  private final StatusLine status;
  private final long begin = System.nanoTime();

  SweepProgress(StatusLine status) {
    this.status = status;
  }

  void show(DuctSweep.Case one, int number, int count, double shareDone) {
    double seconds = (System.nanoTime() - begin) * 1e-9;
    status.show(
        String.format(
            Locale.ROOT,
            "run %d of %d  size %d  bundle %s  threads %d  ETA %.0f s",
            number,
            count,
            one.duct().side(),
            one.label(),
            one.threads(),
            Math.ceil(seconds / shareDone * (1 - shareDone))));
  }
}
