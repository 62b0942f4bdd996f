package org.hdispatch.app.permeability;

import java.io.PrintWriter;
import java.util.Arrays;
import java.util.Locale;
import java.util.OptionalDouble;
import org.hdispatch.app.console.StatusLine;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.porous.darcy.Permeability;
import org.hdispatch.porous.flow.FlowListener;

/**
 * One line on a terminal, written over and over: step, k, its estimated error, speed, time left.
 */
final class ProgressLine implements FlowListener, AutoCloseable {
  private static final double SECONDS_BETWEEN = 0.2;

  private final StatusLine status;
  private final OptionalDouble voxelEdge;
  private final TimeLeft timeLeft = new TimeLeft();
  private double nextAt;

  ProgressLine(PrintWriter err, OptionalDouble voxelEdge) {
    status = new StatusLine(err);
    this.voxelEdge = voxelEdge;
  }

  @Override
  public void progressed(Progress now) {
    timeLeft.add(now);
    if (now.secondsStepping() >= nextAt) {
      nextAt = now.secondsStepping() + SECONDS_BETWEEN;
      status.show(line(now));
    }
  }

  private String line(Progress now) {
    OptionalDouble milliDarcy = new Permeability(now.permeability(), voxelEdge).milliDarcy();
    double left = timeLeft.seconds();
    return String.format(
        Locale.ROOT,
        "step %d  k %s  error %s  %.1f MFLUPS  ETA %s",
        now.step(),
        milliDarcy.isPresent()
            ? Numbers.significant(milliDarcy.getAsDouble(), 5) + " mD"
            : Numbers.significant(now.permeability(), 5) + " voxel2",
        Numbers.percent(now.errorEstimate()),
        now.mflups(),
        Double.isFinite(left) ? String.format(Locale.ROOT, "%.0f s", Math.ceil(left)) : "unknown");
  }

  /** Wipes the line. */
  @Override
  public void close() {
    status.close();
  }

  /**
   * Time until the error estimate meets the tolerance, extrapolated from its decay over the second
   * half of the measurements, or until the steps run out.
   */
  static final class TimeLeft {
    private double[] logErrors = new double[64];
    private int count;
    private Progress last;

    void add(Progress now) {
      if (count == logErrors.length) {
        logErrors = Arrays.copyOf(logErrors, 2 * count);
      }
      logErrors[count++] = Math.log(now.errorEstimate());
      last = now;
    }

    /** Seconds left; infinite if unknown. */
    double seconds() {
      if (count < 2) {
        return Double.POSITIVE_INFINITY;
      }
      int half = count / 2;
      double decay = (logErrors[half] - logErrors[count - 1]) / (count - 1 - half);
      double toGo = logErrors[count - 1] - Math.log(last.tolerance());
      double perMeasurement = last.secondsStepping() / count;
      double atLimit =
          (last.maxSteps() - last.step()) * last.secondsStepping() / Math.max(1, last.step());
      if (!(decay > 0) || decay == Double.POSITIVE_INFINITY) {
        return Double.POSITIVE_INFINITY;
      }
      return Math.min(Math.max(0, toGo) / decay * perMeasurement, atLimit);
    }
  }
}
