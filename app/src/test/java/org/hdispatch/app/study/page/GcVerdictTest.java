package org.hdispatch.app.study.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hdispatch.app.study.Collector;
import org.hdispatch.app.study.GcCase;
import org.hdispatch.app.study.GcFigures;
import org.hdispatch.app.study.GcFigures.Stops;
import org.hdispatch.app.study.GcOrigin;
import org.hdispatch.app.study.GcRow;
import org.hdispatch.app.study.GcRows;
import org.hdispatch.app.study.ScratchPolicy;
import org.hdispatch.app.study.Workload;
import org.junit.jupiter.api.Test;

class GcVerdictTest {
  private static final Stops NONE = GcSamples.stops(0, 0, 0);

  private static GcRow enduring(Collector collector, double heap, double workers) {
    return GcSamples.still(
        GcSamples.of(GcSamples.NEW, collector, ScratchPolicy.ENDURING, heap), workers, 0, 0);
  }

  private static GcRow perCell(Collector collector, double heap, double workers, double others) {
    return GcSamples.collecting(
        GcSamples.of(GcSamples.NEW, collector, ScratchPolicy.PER_CELL, heap),
        workers,
        others,
        10,
        GcSamples.stops(10, 16, 3),
        GcSamples.stops(12, 32, 4),
        NONE,
        65e6);
  }

  private static GcRow zgc(Stops pauses, Stops stalls) {
    GcCase of = GcSamples.of(GcSamples.NEW, Collector.ZGC, ScratchPolicy.PER_CELL, 6);
    return GcSamples.collecting(of, 30, 5, 9, pauses, pauses, stalls, 65e6);
  }

  private static GcRow like(GcRow row, Workload workload, int scratch) {
    return GcRows.first(GcSamples.with(row.of(), workload, scratch), row.why(), row.figures());
  }

  private static String said(GcRow... rows) {
    return String.join("\n", GcVerdict.sentences(List.of(rows)));
  }

  private static void assertSays(String what, String said) {
    assertTrue(said.contains(what), said);
  }

  private static void assertSilent(String what, String said) {
    assertFalse(said.contains(what), said);
  }

  @Test
  void enduringScratchGivesNothingToCollectOrTheExceptionsByName() {
    GcRow calm = enduring(Collector.G1, 6, 20);
    assertEquals(
        "Enduring scratch: no collection, no pause and 0 bytes per step in all 2 runs, with Serial"
            + " and G1 on Java 25.",
        said(enduring(Collector.SERIAL, 6, 20), calm));
    GcRow leaky =
        GcSamples.collecting(
            GcSamples.of(GcSamples.NEW, Collector.SERIAL, ScratchPolicy.ENDURING, 2),
            20,
            0,
            1,
            GcSamples.stops(1, 2, 2),
            GcSamples.stops(1, 2, 2),
            NONE,
            4096);
    String said = said(leaky, calm);
    assertSays("0 bytes per step in 1 of 2 runs", said);
    assertSays(
        "The exceptions: Serial, sweep bound by computing, scratch of 64 KiB, in a heap of 2x: 1"
            + " collection, 1 pause, 4 KiB per step.",
        said);
  }

  @Test
  void bytesThatNobodyCountedAreNotCalledZero() {
    GcRow unknown =
        GcSamples.still(
            GcSamples.of(GcSamples.NEW, Collector.G1, ScratchPolicy.ENDURING, 6), 20, 0, -1);
    assertSays(
        "in all 2 runs (bytes not measured in 1)", said(unknown, enduring(Collector.ZGC, 6, 20)));
  }

  @Test
  void costPerCellIsARangeWithItsEnds() {
    String said =
        said(
            enduring(Collector.SERIAL, 6, 20),
            perCell(Collector.SERIAL, 6, 24, 1),
            enduring(Collector.G1, 6, 20),
            perCell(Collector.G1, 6, 28, 2),
            enduring(Collector.G1, 2, 20),
            perCell(Collector.G1, 2, 28, 12));
    assertSays("costs 1.25 to 1.50 times the CPU of enduring scratch in a heap of 6x", said);
    assertSays("least with Serial, most with G1. At least 1.2 was expected, and seen.", said);
    assertSays("It costs 2.00 times in a heap of 2x (G1). At least 1.5 was expected, and", said);
    assertSays(
        "takes 5 to 10 us of CPU more, where a cell with enduring scratch takes 20 us", said);
    assertSilent("The more there is to do", said);
  }

  @Test
  void costBelowWhatWasExpectedIsSaid() {
    String said =
        said(
            enduring(Collector.SERIAL, 6, 20),
            perCell(Collector.SERIAL, 6, 20, 1),
            enduring(Collector.G1, 6, 20),
            perCell(Collector.G1, 6, 28, 2));
    assertSays("At least 1.2 was expected, and not seen with Serial (1.05).", said);
    assertSays("The more there is to do in a cell, the less that weighs.", said);
    GcRow[] other = {
      like(enduring(Collector.G1, 6, 20), Workload.LBM, 4096),
      like(perCell(Collector.G1, 6, 20, 1), Workload.LBM, 4096)
    };
    assertSilent("expected", said(other)); // of this scratch nothing was
  }

  @Test
  void whatTheSameWorkDiffersByFromRunToRunIsNoise() {
    GcRow tight = enduring(Collector.G1, 2, 26);
    GcRow roomy = enduring(Collector.G1, 6, 20);
    String said = said(tight, roomy, perCell(Collector.G1, 6, 30, 1));
    assertSays("took up to 1.30 times as much CPU in one run as in another", said);
    String one = said(roomy, perCell(Collector.G1, 6, 30, 1));
    assertSays("What these ratios can tell: each case was run once.", one);
    assertSilent("as much CPU in one", one);
    GcRow another = enduring(Collector.SERIAL, 2, 40); // other collectors are no repetition
    assertSilent("as much CPU in one", said(roomy, another, perCell(Collector.G1, 6, 30, 1)));
    assertSilent("What these ratios can tell", said(roomy)); // there is no ratio
  }

  @Test
  void payerOfMostIsWhoeverItIs() {
    GcRow base = enduring(Collector.G1, 6, 20);
    String workers = said(base, perCell(Collector.G1, 6, 28, 2));
    assertSays(
        "the workers themselves spend 80 % in a heap of 6x, the collector's threads 15 % in a heap"
            + " of 6x; the rest is the compilers' and the recorder's.",
        workers);
    assertSays("most of the price is paid by the threads that step", workers);
    String collector = said(base, perCell(Collector.G1, 6, 22, 8));
    assertSays("the workers themselves spend 20 % in a heap of 6x, the collector's", collector);
    assertSilent("zero each new scratch", collector);
    assertSilent("of what this costs", said(base, perCell(Collector.G1, 6, 19, 0)));
  }

  @Test
  void standstillIsComparedWithWhatCollectorsReport() {
    GcRow base = enduring(Collector.G1, 6, 20);
    String said = said(base, perCell(Collector.G1, 6, 28, 2));
    assertSays("all threads stand still for 2 % of the time in a heap of 6x (G1).", said);
    assertSays("sum up to 16 ms where threads were stopped for 32 ms.", said);
    GcRow open =
        GcSamples.collecting(
            GcSamples.of(GcSamples.NEW, Collector.G1, ScratchPolicy.PER_CELL, 6),
            28,
            2,
            10,
            GcSamples.stops(10, 16, 3),
            GcSamples.stops(12, 16.5, 4),
            NONE,
            65e6);
    assertSays("The pauses that collectors report tell all of it.", said(base, open));
  }

  @Test
  void stallsStandBesideTheShortPausesOfZgc() {
    assertSays(
        "No pause of ZGC is longer than 0.06 ms, but workers waited for memory, which no pause"
            + " counts: 21 times in a heap of 6x (120 ms in all, 20 ms at most).",
        said(zgc(GcSamples.stops(62, 1.2, 0.06), GcSamples.stops(21, 120, 20))));
    assertSays(
        "No pause of ZGC is longer than 0.06 ms, and no worker waited for memory.",
        said(zgc(GcSamples.stops(62, 1.2, 0.06), NONE)));
    assertSays("ZGC did not pause, and no worker waited", said(zgc(NONE, NONE)));
    assertSilent("waited", said(zgc(NONE, new Stops(-1, 0, 0, 0)))); // nobody looked
  }

  @Test
  void alternativesAreNearlyAsCheapOnlyIfTheyAre() {
    GcRow base = enduring(Collector.G1, 6, 20);
    GcCase step = GcSamples.of(GcSamples.NEW, Collector.G1, ScratchPolicy.PER_STEP, 6);
    String cheap = said(base, GcSamples.still(step, 21, 0, 131_072));
    assertSays("made anew for every step, 1.05 times (128 KiB per step).", cheap);
    assertSays("nearly as cheap; what enduring scratch adds is exactly 0 bytes.", cheap);
    String dear = said(base, GcSamples.still(step, 25, 0, 131_072));
    assertSays(
        "Dearer by more than runs differ by themselves: per step with G1 in a heap of 6x (1.25).",
        dear);
    assertSilent("That is nearly", dear);
  }

  @Test
  void threadLocalOfVirtualThreadsIsJudgedBesideScratchPerCell() {
    GcRow base = enduring(Collector.G1, 6, 20);
    GcRow cell = perCell(Collector.G1, 6, 28, 2);
    GcCase virtual =
        GcSamples.of(GcSamples.NEW, Collector.G1, ScratchPolicy.THREAD_LOCAL_VIRTUAL, 6);
    String name = "it is scratch per cell by another name.";
    String dear = said(base, cell, GcSamples.still(virtual, 31, 0, 65e6));
    assertSays("costs 1.55 times the CPU of enduring scratch (62 MiB per step)", dear);
    assertSays("where scratch per cell costs 1.50 times: " + name, dear);
    assertSilent(name, said(base, cell, GcSamples.still(virtual, 21, 0, 1000)));
    assertSilent(name, said(base, GcSamples.still(virtual, 31, 0, 65e6)));
  }

  @Test
  void largeScratchOfG1IsHumongous() {
    GcRow base = like(enduring(Collector.G1, 6, 20), Workload.COMPUTE, 1 << 20);
    GcRow cell = like(perCell(Collector.G1, 6, 28, 2), Workload.COMPUTE, 1 << 20);
    assertSays(
        "1.50 times the CPU, 10 collections, stopped for 2 % of the time (sweep bound by computing"
            + " in a heap of 6x)",
        said(base, cell));
    GcRow serial = like(perCell(Collector.SERIAL, 6, 28, 2), Workload.COMPUTE, 1 << 20);
    assertSilent("humongous", said(serial));
    assertSilent("humongous", said(perCell(Collector.G1, 6, 28, 2)));
  }

  @Test
  void otherWorkIsToldApart() {
    String said =
        said(
            enduring(Collector.G1, 6, 20),
            perCell(Collector.G1, 6, 28, 2),
            enduring(Collector.SERIAL, 6, 20),
            perCell(Collector.SERIAL, 6, 28, 2),
            like(enduring(Collector.ZGC, 6, 10), Workload.BANDWIDTH, GcSamples.SCRATCH),
            like(perCell(Collector.ZGC, 6, 22, 2), Workload.BANDWIDTH, GcSamples.SCRATCH));
    assertSays("costs 1.50 times the CPU", said);
    assertSays("sweep bound by memory, scratch of 64 KiB in a heap of 6x: 2.40 times (ZGC).", said);
  }

  @Test
  void runsWithoutFiguresAreNamedWithTheirReason() {
    List<GcRow> rows = new ArrayList<>(List.of(enduring(Collector.EPSILON, 6, 20)));
    for (double heap : new double[] {6, 2}) {
      rows.add(
          GcSamples.dead(
              GcSamples.of(GcSamples.NEW, Collector.EPSILON, ScratchPolicy.PER_CELL, heap),
              "out of memory"));
    }
    List<String> said = GcVerdict.sentences(rows);
    assertEquals(
        "No figures from 2 of 3 runs: 2x Epsilon, per cell (out of memory).",
        said.get(said.size() - 1));
    assertEquals(1, GcVerdict.sentences(rows.subList(1, 3)).size()); // all dead: no more to say
  }

  @Test
  void collectorThatNobodyMeasuredIsNotToldFromOthers() {
    List<GcRow> rows = new ArrayList<>();
    for (GcRow row : List.of(enduring(Collector.G1, 6, 20), perCell(Collector.G1, 6, 28, 2))) {
      GcFigures f = row.figures().orElseThrow();
      GcFigures unknown =
          new GcFigures(
              f.heapBytes(),
              f.peakHeapBytes(),
              f.workers(),
              f.cells(),
              f.steps(),
              f.seconds(),
              f.workerCpuSeconds(),
              f.otherCpuSeconds(),
              -1,
              f.collections(),
              f.pauses(),
              f.stopped(),
              f.reachingMillis(),
              f.stalls(),
              f.stepTimes(),
              f.bytesPerStep(),
              f.bytesPerStepInAll(),
              f.timeline());
      rows.add(GcRows.first(row.of(), "", Optional.of(unknown)));
    }
    assertSays(
        "spend 80 % in a heap of 6x; the rest is other threads', the collector's above all.",
        String.join("\n", GcVerdict.sentences(rows)));
  }

  @Test
  void severalRunsOfACaseAreToldByTheMedianOfRoundsAndTheirSpread() {
    String said =
        said(
            enduring(Collector.G1, 6, 20),
            perCell(Collector.G1, 6, 98, 2),
            GcRows.again(enduring(Collector.G1, 6, 40), 2),
            GcRows.again(perCell(Collector.G1, 6, 58, 2), 2),
            GcRows.again(enduring(Collector.G1, 6, 20), 3),
            GcRows.again(perCell(Collector.G1, 6, 20, 2), 3));
    assertSays("costs 1.50 times (single runs 1.10 to 5.00) the CPU", said);
    assertSays(
        "they are medians of 3 runs of each case, in rounds over all cases; from round to round a"
            + " ratio per cell differs most with G1 in a heap of 6x, 1.10 to 5.00.",
        said);
    assertSays("0 bytes per step in all 3 runs", said);
  }

  @Test
  void ofTwoRoundsTheMeanIsSaidAndARoundWithoutAPartnerIsLeftOut() {
    String said =
        said(
            enduring(Collector.G1, 6, 20),
            perCell(Collector.G1, 6, 24, 0),
            GcRows.again(enduring(Collector.G1, 6, 20), 2),
            GcRows.again(perCell(Collector.G1, 6, 28, 0), 2),
            GcRows.again(perCell(Collector.G1, 6, 98, 0), 3));
    assertSays("costs 1.30 times (single runs 1.20 to 1.40) the CPU", said);
    assertSays("medians of 2 to 3 runs of each case", said);
  }

  @Test
  void runsOfSeveralBuildsOrMachinesAreSaidToBe() {
    GcRow row = enduring(Collector.G1, 6, 20);
    GcOrigin o = row.origin();
    GcOrigin other =
        new GcOrigin(o.vendor(), o.runtime(), o.processor(), 64, o.memoryGib(), o.system(), "ba5e");
    assertSays(
        "These runs are of 2 builds on 2 machines: what differs may differ by that.",
        said(row, GcRows.by(perCell(Collector.G1, 6, 28, 2), other)));
    assertSilent("builds", said(row, perCell(Collector.G1, 6, 28, 2)));
  }

  @Test
  void wholeStudySaysEverything() {
    List<String> said = GcVerdict.sentences(GcSamples.study());
    assertEquals(14, said.size());
    String all = String.join("\n", said);
    assertSays("on Java 17 and Java 25.", all);
    assertSays("costs 1.29 to 1.70 times the CPU", all);
    assertSays("It costs 1.54 to 2.63 times in a heap of 2x", all);
    assertSays("Over the distilled baseline", all);
    for (String bad : List.of("NaN", "null", "Infinity", "unknown", "  ", "..")) {
      assertSilent(bad, all);
    }
  }
}
