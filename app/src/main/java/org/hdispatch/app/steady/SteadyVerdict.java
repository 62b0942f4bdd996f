package org.hdispatch.app.steady;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.Stream;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.lbm.duct.Spread;
import org.hdispatch.porous.flow.Approach;

/** What follows from a study of steady states, in numbers and in sentences. */
final class SteadyVerdict {
  /** The relative error of k at which the two ways are compared. */
  static final double SHARE = 1e-3;

  private final SteadyResult result;
  private final List<SteadyComparison> rocks;

  SteadyVerdict(SteadyResult result) {
    this.result = result;
    rocks = result.rocks();
  }

  /** Points from which k stays within {@link #SHARE}, of all rocks where there is one. */
  List<SteadyCourse.Point> arrivals(Approach approach) {
    return courses(approach).map(course -> course.within(SHARE)).flatMap(o -> o.stream()).toList();
  }

  /** Points where the stop rule found the flow steady, of all rocks where it did. */
  List<SteadyCourse.Point> stops(Approach approach) {
    return courses(approach).map(SteadyCourse::stop).flatMap(o -> o.stream()).toList();
  }

  /** True errors where the stop rule found the flow steady. */
  double[] errorsAtStop(Approach approach) {
    return courses(approach)
        .filter(course -> course.stop().isPresent())
        .mapToDouble(course -> course.error(course.stop().get()))
        .toArray();
  }

  /** How many stops of the stop rule were further off than its tolerance. */
  long stopsTooSoon() {
    return Stream.of(Approach.values())
        .mapToLong(
            approach ->
                Arrays.stream(errorsAtStop(approach))
                    .filter(error -> error > result.options().tolerance())
                    .count())
        .sum();
  }

  /** Steps of the plain approach over those of the corrected one, where both arrive. */
  double[] stepsRatios() {
    return ratios(each -> each.stepsRatio(each.plain(), SHARE));
  }

  /** Seconds of the plain approach over those of the corrected one, where both arrive. */
  double[] secondsRatios() {
    return ratios(each -> each.secondsRatio(each.plain(), SHARE));
  }

  private double[] ratios(Function<SteadyComparison, OptionalDouble> ratio) {
    return rocks.stream().map(ratio).flatMapToDouble(OptionalDouble::stream).toArray();
  }

  private Stream<SteadyCourse> courses(Approach approach) {
    return rocks.stream()
        .flatMap(each -> each.courses().stream())
        .filter(course -> course.approach() == approach);
  }

  /** The sentences, most important first. */
  List<String> sentences() {
    List<String> sentences = new ArrayList<>();
    sentences.add(
        "Until k stays within "
            + Numbers.plainPercent(SHARE)
            + " of its steady value, the corrected approach takes "
            + arrival(Approach.CORRECTED)
            + "; plain stepping takes "
            + arrival(Approach.PLAIN)
            + ".");
    if (stepsRatios().length > 0) {
      sentences.add(ratioSentence());
    }
    if (rocks.size() > 1) {
      sentences.add(extremes());
    }
    pressureShare(sentences);
    stopSentences(sentences);
    sentences.add(agreement());
    return sentences;
  }

  private String arrival(Approach approach) {
    List<SteadyCourse.Point> points = arrivals(approach);
    int missing = rocks.size() - points.size();
    String never =
        ofRocks(missing) + " it is not there after " + result.options().maxSteps() + " steps";
    if (points.isEmpty()) {
      return "more than it was given: " + never;
    }
    return stepsAndSeconds(points) + (missing == 0 ? "" : " (" + never + ")");
  }

  private String ofRocks(long count) {
    if (count < rocks.size()) {
      return "in " + count + " of " + rocks.size() + " rocks";
    }
    return count == 1 ? "in the rock" : count == 2 ? "in both rocks" : "in all " + count + " rocks";
  }

  private static String stepsAndSeconds(Collection<SteadyCourse.Point> points) {
    Spread steps = Spread.of(points.stream().mapToDouble(SteadyCourse.Point::step).toArray());
    Spread seconds = Spread.of(points.stream().mapToDouble(SteadyCourse.Point::seconds).toArray());
    return Numbers.span(steps.least(), steps.most(), 9)
        + " steps and "
        + Numbers.span(seconds.least(), seconds.most(), 2)
        + " s";
  }

  private String ratioSentence() {
    Spread steps = Spread.of(stepsRatios());
    double[] all = secondsRatios();
    Spread seconds = Spread.of(all);
    long slower = Arrays.stream(all).filter(ratio -> ratio < 1).count();
    return "Rock by rock, plain stepping takes "
        + times(steps)
        + " the steps of the corrected approach, and "
        + times(seconds)
        + " the seconds, pressure included"
        + (slower == 0 ? "." : "; " + ofRocks(slower) + " it is there sooner.");
  }

  private static String times(Spread ratios) {
    String span = Numbers.span(ratios.least(), ratios.most(), 2) + " times";
    return ratios.least() == ratios.most()
        ? span
        : span + " (median " + Numbers.plain(ratios.median(), 2) + ")";
  }

  /** Whether it is harder in tight rock. */
  private String extremes() {
    Comparator<SteadyComparison> byPorosity =
        Comparator.comparingDouble(SteadyComparison::porosity);
    SteadyComparison tight = rocks.stream().min(byPorosity).orElseThrow();
    SteadyComparison open = rocks.stream().max(byPorosity).orElseThrow();
    return "The tightest rock, of porosity "
        + porosity(tight)
        + ", takes "
        + bothSteps(tight)
        + "; the most open one, of "
        + porosity(open)
        + ", "
        + bothSteps(open)
        + ".";
  }

  private static String porosity(SteadyComparison each) {
    return Numbers.plain(each.porosity(), 3);
  }

  private static String bothSteps(SteadyComparison each) {
    return steps(each.corrected()) + " steps corrected and " + steps(each.plain()) + " plain";
  }

  private static String steps(SteadyCourse course) {
    return course
        .within(SHARE)
        .map(point -> Long.toString(point.step()))
        .orElse("more than " + course.last().step());
  }

  /** What a corrected approach spends its seconds on. */
  private void pressureShare(List<String> sentences) {
    List<SteadyCourse.Point> points = arrivals(Approach.CORRECTED);
    if (!points.isEmpty()) {
      Spread share =
          Spread.of(
              points.stream()
                  .mapToDouble(point -> 100 * point.secondsPressure() / point.seconds())
                  .toArray());
      sentences.add(
          "Of the seconds of the corrected approach, pressure takes "
              + Numbers.span(share.least(), share.most(), 2)
              + " %, its set-up included.");
    }
  }

  private void stopSentences(List<String> sentences) {
    String tolerance = Numbers.plainPercent(result.options().tolerance());
    StringBuilder said = new StringBuilder("The stop rule, at an estimated error of ");
    said.append(tolerance).append(", ends ");
    String comma = "";
    long stopped = 0;
    for (Approach approach : Approach.values()) {
      List<SteadyCourse.Point> points = stops(approach);
      stopped += points.size();
      said.append(comma)
          .append(approach == Approach.CORRECTED ? "the corrected approach" : "plain stepping");
      comma = ", and ";
      if (points.isEmpty()) {
        said.append(" in no rock");
      } else {
        Spread errors = Spread.of(errorsAtStop(approach));
        said.append(" after ")
            .append(stepsAndSeconds(points))
            .append(", when k is really ")
            .append(Numbers.span(100 * errors.least(), 100 * errors.most(), 2))
            .append(" % off");
      }
    }
    sentences.add(said.append('.').toString());
    if (stopped > 0) {
      long tooSoon = stopsTooSoon();
      sentences.add(
          tooSoon == 0
              ? "It never stopped too soon: in all "
                  + stopped
                  + " runs that it ended, k was as close as it had to be."
              : "It stopped too soon in "
                  + tooSoon
                  + " of the "
                  + stopped
                  + " runs that it ended: k was further off than "
                  + tolerance
                  + ".");
    }
  }

  /** Whether both lead to the same k, which the one of them is measured by. */
  private String agreement() {
    double close = result.close();
    long agree =
        courses(Approach.PLAIN).filter(course -> course.error(course.last()) <= close).count();
    return "The steady k is the corrected approach's, at an estimated error of "
        + Numbers.plainPercent(result.referenceTolerance())
        + "; plain stepping comes within "
        + Numbers.plainPercent(close)
        + " of the same value "
        + ofRocks(agree)
        + ".";
  }
}
