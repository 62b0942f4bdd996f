package org.hdispatch.app.survey;

import java.util.Locale;
import java.util.function.Consumer;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.porous.flow.FlowListener;
import org.hdispatch.porous.survey.SurveyJob;

/** Tells how far a survey is and when it will be done. */
final class SurveyProgress implements FlowListener {
  private static final long NANOS_BETWEEN = 200_000_000;

  /** So many jobs tell how long the others will take. */
  private static final int TELLING = 3;

  private final Consumer<String> status;
  private final Consumer<String> note;
  private final int jobs;
  private final int earlier;
  private int done; // by this process
  private double seconds; // of all but the first, in which the JVM warms up
  private SurveyJob now;
  private long shownAt = System.nanoTime() - NANOS_BETWEEN;

  /**
   * Progress of a survey.
   *
   * @param status shows a line that the next one replaces
   * @param note says a line that stays
   * @param jobs all jobs
   * @param earlier those that were done before
   */
  SurveyProgress(Consumer<String> status, Consumer<String> note, int jobs, int earlier) {
    this.status = status;
    this.note = note;
    this.jobs = jobs;
    this.earlier = earlier;
  }

  /** A job is begun. */
  void begun(SurveyJob job) {
    now = job;
    show("");
  }

  /** The job is done and has its row. */
  void done(double secondsTaken) {
    seconds += done == 0 ? 0 : secondsTaken;
    done++;
    int left = jobs - earlier - done;
    if (done == TELLING && left > 0) {
      note.accept(
          "survey: "
              + left
              + " jobs are left and take about "
              + time(secondsLeft())
              + ", by the first "
              + TELLING);
    }
  }

  private double secondsLeft() {
    return (jobs - earlier - done) * seconds / (done - 1);
  }

  @Override
  public void progressed(Progress progress) {
    show(
        String.format(
            Locale.ROOT,
            "  step %d  error %s  %.1f MFLUPS",
            progress.step(),
            Numbers.percent(progress.errorEstimate()),
            progress.mflups()));
  }

  private void show(String flow) {
    long nanos = System.nanoTime();
    if (nanos - shownAt >= NANOS_BETWEEN) {
      shownAt = nanos;
      String left = done < 2 ? "unknown" : time(secondsLeft());
      status.accept(
          String.format(
              Locale.ROOT,
              "job %d of %d  block at %d,%d,%d along %s  ETA %s%s",
              earlier + done + 1,
              jobs,
              now.box().x0(),
              now.box().y0(),
              now.box().z0(),
              Choices.word(now.axis()),
              left,
              flow));
    }
  }

  /** A time as people say it: {@code 12 s}, {@code 3 min 20 s}, {@code 5 h 7 min}. */
  static String time(double seconds) {
    long whole = (long) Math.ceil(seconds);
    if (whole < 60) {
      return whole + " s";
    }
    return whole < 3600
        ? whole / 60 + " min " + whole % 60 + " s"
        : whole / 3600 + " h " + whole % 3600 / 60 + " min";
  }
}
