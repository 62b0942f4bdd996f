package org.hdispatch.app.steady;

import java.util.Locale;
import org.hdispatch.app.console.StatusLine;
import org.hdispatch.app.rock.Rock;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.porous.flow.FlowListener;

/** Shows how far a study of steady states is. */
final class SteadyProgress implements SteadyStudy.Listener {
  private static final long NANOS_BETWEEN = 200_000_000;

  private final StatusLine status;
  private final int rocks;
  private long shownAt = System.nanoTime() - NANOS_BETWEEN;

  SteadyProgress(StatusLine status, int rocks) {
    this.status = status;
    this.rocks = rocks;
  }

  @Override
  public void progressed(int number, Rock rock, String run, FlowListener.Progress now) {
    long nanos = System.nanoTime();
    if (nanos - shownAt >= NANOS_BETWEEN) {
      shownAt = nanos;
      status.show(
          String.format(
              Locale.ROOT,
              "rock %d of %d  porosity %s  %s  step %d  k %s voxel2  error %s  %.1f MFLUPS",
              number,
              rocks,
              Numbers.significant(rock.space().porosity(), 3),
              run,
              now.step(),
              Numbers.significant(now.permeability(), 5),
              Numbers.percent(now.errorEstimate()),
              now.mflups()));
    }
  }
}
