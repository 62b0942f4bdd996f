package org.hdispatch.app.study.page;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import org.hdispatch.app.draw.StudyPage;
import org.hdispatch.app.study.Collector;
import org.hdispatch.app.study.GcFigures;
import org.hdispatch.app.study.GcOrigin;
import org.hdispatch.app.study.GcRow;
import org.hdispatch.app.study.ScratchPolicy;
import org.hdispatch.app.study.page.GcRuns.Setting;
import org.hdispatch.app.text.Numbers;

/** A study of garbage collection as a page. */
public final class GcPage {
  private static final List<String> SOURCES =
      List.of(
          "Z. Cai, S. M. Blackburn, M. D. Bond, M. Maas: Distilling the Real Cost of Production"
              + " Garbage Collectors. ISPASS 2022, arXiv:2112.07880. LBO, and why CPU and not only"
              + " pauses must be counted.",
          "C. R. Leonardi, D. W. Holmes, J. R. Williams, P. G. Tilke: A Multi-Core Numerical"
              + " Framework for Characterizing Flow in Oil Reservoirs. HPC 2011. Enduring"
              + " threads, whose memory is never reclaimed.");

  private final GcRuns runs;
  private final Setting main;

  private GcPage(List<GcRow> rows) {
    runs = new GcRuns(rows);
    main = runs.settings().get(0);
  }

  /**
   * The page.
   *
   * @param rows of a study, at least one
   * @param command that repeats the study
   * @param files beside the page that hold the same figures
   */
  public static String html(List<GcRow> rows, String command, List<String> files) {
    return new GcPage(rows).page(command, files);
  }

  private String page(String command, List<String> files) {
    StudyPage page = new StudyPage("What enduring scratch is worth", lead());
    page.section("Verdict")
        .verdict(GcVerdict.sentences(runs.rows()).stream().map(GcPage::micro).toList());
    GcPictures pictures = new GcPictures(runs, main);
    page.section("Processor time")
        .paragraph(
            "CPU per cell of each way to keep scratch ("
                + main.name()
                + "). In colour: the workers; at the end: all other threads, the collector's above"
                + " all. In brackets: over enduring scratch. All panels have the same axis.");
    figure(page, "A panel for each JVM and size of the heap.", pictures.bars(runs.heaps(main)));
    if (has(ScratchPolicy.PER_CELL)) {
      page.section("Pauses")
          .paragraph(
              "Each upright line is a stop-the-world pause with scratch per cell (orange), its"
                  + " height the length in ms, on a logarithmic axis. Below it, on the same axes, enduring"
                  + " scratch (blue): where its line is bare, there was no pause.");
      figure(page, "The largest and the smallest heap.", pictures.pauses());
    }
    List<String> steps = pictures.steps();
    if (!steps.isEmpty()) {
      page.section("Step times")
          .paragraph(
              "How many steps took how long, enduring (blue) and per cell (orange); both axes are"
                  + " logarithmic and the same in all panels. Beside the collector: the 90th"
                  + " percentile of each.");
      figure(page, "A panel for each JVM and size of the heap.", steps);
    }
    others(page);
    tables(page);
    page.section("How it was measured").points(method());
    page.section("Do it again").command(command).files(files);
    page.section("Sources").points(SOURCES);
    return page.toString();
  }

  private static void figure(StudyPage page, String caption, List<String> pictures) {
    if (!pictures.isEmpty()) {
      page.figure(caption, pictures);
    }
  }

  private boolean has(ScratchPolicy policy) {
    return runs.runs().stream().anyMatch(run -> run.of().policy() == policy);
  }

  /** Microseconds as people write them. */
  private static String micro(String text) {
    return text.replaceAll("\\bus\\b", "\u00b5s");
  }

  private String lead() {
    String repeats =
        runs.repeats().getMax() == 1 ? "" : ", " + runs.repeatsInWords() + " of each case";
    return "Scratch kept by enduring threads against scratch made anew, with "
        + collectors()
        + " of Java "
        + String.join(" and ", runs.javas())
        + ": "
        + (runs.rows().size() == 1 ? "one run" : runs.rows().size() + " runs")
        + repeats
        + ".";
  }

  private String collectors() {
    return runs.collectors().stream().map(Collector::title).collect(Collectors.joining(", "));
  }

  /** Bars of the other settings, in their largest heap. */
  private void others(StudyPage page) {
    List<Setting> others = runs.settings().subList(1, runs.settings().size());
    if (others.isEmpty()) {
      return;
    }
    page.section("Other work, other sizes of scratch")
        .paragraph("CPU per cell as above, each in the largest heap that it was run in.");
    for (Setting setting : others) {
      figure(
          page,
          sentence(setting.name()),
          new GcPictures(runs, setting).bars(runs.heaps(setting).subList(0, 1)));
    }
  }

  private static String sentence(String words) {
    return Character.toUpperCase(words.charAt(0)) + words.substring(1) + ".";
  }

  private void tables(StudyPage page) {
    GcTable table = new GcTable(runs);
    List<String> head = GcTable.HEAD.stream().map(GcPage::micro).toList();
    page.section("All runs");
    for (Setting setting : runs.settings()) {
      page.table(sentence(setting.name()), head, table.rows(setting));
    }
  }

  private List<String> method() {
    List<GcFigures> all = runs.runs().stream().map(GcRuns.Run::figures).toList();
    List<String> points = new ArrayList<>();
    points.add("Machine: " + all(GcOrigin::machine) + ".");
    points.add(
        "JVM: "
            + all(GcOrigin::jvm)
            + ". Hash of the code that ran: "
            + all(GcOrigin::build)
            + ".");
    points.add(
        "Every row is a JVM of its own, with a heap of fixed size that is touched before anything"
            + " is measured. "
            + (runs.repeats().getMax() == 1
                ? "One JVM a case: what the same work takes more from run to run stands in the"
                    + " verdict, and smaller differences mean nothing."
                : "JVMs a case: "
                    + runs.repeatsInWords()
                    + ", in rounds over all cases, so that what is compared lies close together in"
                    + " time. A ratio is that of two runs of one round; of several the median is"
                    + " said. Whatever else is said or drawn of a case is of its run with the median"
                    + " CPU, of an even number the lower of the two in the middle."));
    points.add(
        "Scratch: what the method needs, and an array beside it that brings it up to the size and is"
            + " written through once for each cell and pass. Thread-local scratch goes with a task"
            + " of a JDK executor for each cell; all other ways with the dispatcher.");
    points.add(
        "Size of the heap: a multiple of the smallest in which the work runs with Serial and scratch"
            + " per cell, found by bisection on the first JVM.");
    if (!all.isEmpty()) {
      points.add(
          "Window: what is measured begins after a warm-up with full collections in it, and takes "
              + span(all, GcFigures::seconds)
              + " s, "
              + span(all, f -> f.steps())
              + " steps of "
              + span(all, f -> f.cells())
              + " cells by "
              + span(all, f -> f.workers())
              + " workers.");
    }
    points.add(
        "CPU: processor time of the threads, from the operating system; workers' is that of the"
            + " threads that step, others' that of the process without them: the collector's, the"
            + " compilers' and the flight recorder's, in ticks of 10 ms. Linux tells what the"
            + " collector's threads take of it, the VM thread among them; elsewhere that is not known,"
            + " and enduring runs show how much of it is there without any collection. Work that a collector leaves to the workers (barriers,"
            + " slow allocation, moving an object on first use) counts as theirs. Over enduring: CPU"
            + " per cell over that with enduring scratch on the same JVM, collector and heap.");
    points.add(
        "LBO, lower-bound overhead: CPU per step over the least that the workers of any run on the"
            + " same JVM took for the same work. The true cost of managing memory is about"
            + " that at least.");
    points.add(
        "Collections: those begun, a concurrent cycle counts once. Pauses: stop-the-world work as"
            + " the collector reports it to the flight recorder (JFR), selected by their start. They"
            + " do not show the time until all threads had stopped, nor stalls.");
    points.add(
        "Stopped: all threads at a safepoint, for whatever reason, from the request until they run"
            + " again; to safepoint is the part until the last one had stopped. JDK 17 does not"
            + " record how long threads take to leave. Stalls: single workers waiting for memory,"
            + " which only ZGC reports; the sum is over workers.");
    points.add(
        "Step times: one clock reading per step, by the thread that calls it; a step that waits"
            + " for a pause, a stall or another process is a long one, and its cause is not seen. The"
            + " 99th percentile is shown from 100 steps on, the 99.9th from 1000.");
    points.add(
        "Bytes: allocated by the worst worker, as the JVM counts them for each thread. Peak heap:"
            + " as seen at collections and at the end, so not what was in use between them.");
    return points;
  }

  /** What rows were made with, each once. */
  private String all(Function<GcOrigin, String> what) {
    return runs.rows().stream()
        .map(row -> what.apply(row.origin()))
        .distinct()
        .collect(Collectors.joining("; "));
  }

  private static String span(List<GcFigures> all, ToDoubleFunction<GcFigures> what) {
    double[] sorted = all.stream().mapToDouble(what).sorted().toArray();
    return Numbers.span(sorted[0], sorted[sorted.length - 1], 3);
  }
}
