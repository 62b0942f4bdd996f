package org.hdispatch.app.survey;

import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Faults;
import org.hdispatch.app.console.StatusLine;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.porous.block.BlockStudy;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.survey.SurveyFiles;
import org.hdispatch.porous.survey.SurveyJob;

/**
 * Does the jobs of a survey that are not done yet, one after the other.
 *
 * @param task what is to be done
 * @param files where rows go
 * @param threads workers
 * @param console where progress is shown
 * @param note says a line that stays
 */
record SurveyRun(
    SurveyTask task,
    SurveyFiles files,
    int threads,
    CommandConsole console,
    Consumer<String> note) {

  /**
   * Does them all.
   *
   * @param heapOfFirst what the first block needs, in words
   * @throws CancellationException if the caller is interrupted; what is done is kept
   */
  void run(String heapOfFirst) throws ImageFileException {
    int earlier = done();
    note.accept(
        "survey: "
            + task.jobs()
            + " jobs in "
            + task.plan().blocks().size()
            + " blocks of "
            + task.which().get("block")
            + (task.left() > 0 ? ", " + task.left() + " partial ones left out" : "")
            + (earlier > 0 ? ", " + earlier + " done before" : "")
            + "; heap for the first block "
            + heapOfFirst
            + ", given "
            + task.heapGiven());
    if (earlier == task.jobs()) {
      return;
    }
    try (StatusLine status = new StatusLine(console.err());
        Dispatcher dispatcher = Dispatcher.withWorkers(threads)) {
      SurveyProgress progress =
          new SurveyProgress(
              console.isWatched() ? status::show : line -> {}, note, task.jobs(), earlier);
      for (int number = 0; number < task.plan().jobs(); number++) {
        if (task.plan().has(task.shard(), number) && !files.isDone(number)) {
          SurveyJob job = task.plan().job(number);
          long begun = System.nanoTime();
          progress.begun(job);
          BlockStudy.Done done = task.study().run(dispatcher, job, progress);
          double seconds = (System.nanoTime() - begun) * 1e-9;
          files.append(done.row(), BlockStudy.times(done, seconds, threads));
          progress.done(seconds);
        }
      }
    } catch (CancellationException | ImageFileException e) {
      if (Faults.code(e) == ExitCode.INTERRUPTED) {
        console.warn(
            done()
                + " of "
                + task.jobs()
                + " jobs are done and kept, the same command goes on: file="
                + files.file());
      }
      throw e;
    }
  }

  private int done() {
    int done = 0;
    for (int number = 0; number < task.plan().jobs(); number++) {
      done += task.plan().has(task.shard(), number) && files.isDone(number) ? 1 : 0;
    }
    return done;
  }
}
