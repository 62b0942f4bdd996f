package org.hdispatch.app.survey.page;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.porous.survey.BlockScale;
import org.hdispatch.porous.survey.GivenPoint;
import org.hdispatch.porous.survey.KozenyCarman;
import org.hdispatch.porous.survey.MethodRatio;
import org.hdispatch.porous.survey.PorosityScale;
import org.hdispatch.porous.survey.ReferenceBand;
import org.hdispatch.porous.survey.Spread;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveyStatus;

/**
 * What surveys come to, laid side by side.
 *
 * @param series the surveys, in the order in which they were given
 * @param points points from elsewhere
 * @param bands reference bands to draw
 * @param porosities porosity by the size of cubes of whole images, by rock
 */
public record SurveyStudy(
    List<Series> series,
    List<GivenPoint> points,
    List<ReferenceBand> bands,
    Map<String, List<PorosityScale>> porosities) {
  private static final int FEW = 3; // points for a fit that is worth drawing

  /** Keeps copies. */
  public SurveyStudy {
    series = List.copyOf(series);
    points = List.copyOf(points);
    bands = List.copyOf(bands);
    porosities = new LinkedHashMap<>(porosities);
  }

  /**
   * A fit.
   *
   * @param of whose points it was laid through
   * @param curve the fit
   * @param drawn whether it is drawn: one for each rock is
   */
  record Fit(Series of, KozenyCarman curve, boolean drawn) {
    /** Constant with its error. */
    String words() {
      String constant = "C = " + Numbers.significant(1e-3 * curve.constant(), 3) + " D";
      return Double.isNaN(curve.error())
          ? constant
          : constant + " \u00b1 " + Numbers.significant(100 * curve.error(), 2) + " %";
    }
  }

  /**
   * How permeabilities compare.
   *
   * @param what whose they are
   * @param over whose they are divided by
   * @param ratios the one over the other
   */
  record Comparison(String what, String over, Spread ratios) {
    String sentence() {
      return what
          + " over "
          + over
          + ": median "
          + Numbers.ratio(ratios.median())
          + ", "
          + Numbers.ratio(ratios.least())
          + " to "
          + Numbers.ratio(ratios.greatest())
          + " in "
          + ratios.count()
          + (ratios.count() == 1 ? " block and direction." : " blocks and directions.");
    }
  }

  /** Surveys of one rock, computed in one way, by the size of their blocks. */
  record Rev(Series first, List<BlockScale> scales) {}

  /** Kozeny-Carman through the points of each survey that has some. */
  List<Fit> fits() {
    List<Fit> fits = new ArrayList<>();
    for (Series each : series) {
      fit(each).ifPresent(curve -> fits.add(new Fit(each, curve, isDrawnFor(each))));
    }
    return fits;
  }

  private static Optional<KozenyCarman> fit(Series of) {
    List<SurveyRow> rows = of.converged();
    return KozenyCarman.fit(
        rows.stream().mapToDouble(Series::porosity).toArray(),
        rows.stream().mapToDouble(Series::permeability).toArray());
  }

  /** Of the surveys of a rock, the one whose blocks are largest and points are not too few. */
  private boolean isDrawnFor(Series one) {
    return series.stream()
        .filter(one::isOfRockOf)
        .filter(each -> !each.converged().isEmpty())
        .max(
            Comparator.comparing((Series each) -> each.converged().size() >= FEW)
                .thenComparing(Series::blockVoxels)
                .thenComparing(each -> each.converged().size()))
        .filter(best -> best == one)
        .isPresent();
  }

  /** Given points by whose they are. */
  Map<String, List<GivenPoint>> pointsByLabel() {
    Map<String, List<GivenPoint>> labels = new LinkedHashMap<>();
    points.forEach(
        each -> labels.computeIfAbsent(each.label(), key -> new ArrayList<>()).add(each));
    return labels;
  }

  /** Ratios to given points of the same blocks, and of particles to the lattice. */
  List<Comparison> comparisons() {
    List<Comparison> all = new ArrayList<>();
    for (Series each : series) {
      pointsByLabel()
          .forEach(
              (label, given) ->
                  add(
                      all,
                      each.name(),
                      label,
                      GivenPoint.ratios(each.table().rows(), each.image(), given)));
      for (Series other : series) {
        if (each.isOfParticles() && !other.isOfParticles() && each.isOfRockOf(other)) {
          add(
              all,
              each.name(),
              other.name(),
              MethodRatio.of(each.table().rows(), other.table().rows()));
        }
      }
    }
    return all;
  }

  private static void add(List<Comparison> all, String what, String over, Spread ratios) {
    if (ratios.count() > 0) {
      all.add(new Comparison(what, over, ratios));
    }
  }

  /** Block sizes of each rock and way to compute. */
  List<Rev> revs() {
    List<Rev> revs = new ArrayList<>();
    Set<Series> taken = new LinkedHashSet<>();
    for (Series first : series) {
      if (!taken.contains(first)) {
        List<Series> like = series.stream().filter(first::isLike).toList();
        taken.addAll(like);
        List<SurveyRow> rows = like.stream().flatMap(each -> each.table().rows().stream()).toList();
        revs.add(new Rev(first, BlockScale.of(rows)));
      }
    }
    return revs;
  }

  /** What was found, sentence by sentence. */
  public List<String> sentences() {
    List<String> sentences = new ArrayList<>();
    for (Series each : series) {
      sentences.add(found(each));
    }
    comparisons().forEach(each -> sentences.add(each.sentence()));
    for (Fit each : fits()) {
      sentences.add(
          each.of().name()
              + ": Kozeny-Carman, k = C \u03c6\u00b3/(1 \u2013 \u03c6)\u00b2, with "
              + each.words()
              + (Double.isNaN(each.curve().scatter())
                  ? ""
                  : " (standard error), scatter of ln k "
                      + Numbers.significant(each.curve().scatter(), 2))
              + "; spheres of "
              + Numbers.significant(1e6 * each.curve().sphereDiameter(), 2)
              + " \u00b5m would have it.");
    }
    return sentences;
  }

  private static String found(Series of) {
    List<SurveyRow> rows = of.table().rows();
    Map<SurveyStatus, Long> counts =
        rows.stream()
            .collect(Collectors.groupingBy(SurveyRow::status, TreeMap::new, Collectors.counting()));
    StringBuilder text = new StringBuilder(of.name()).append(": ");
    text.append(rows.size()).append(" of ").append(of.table().settings().jobs());
    text.append(" jobs have a row");
    counts.forEach(
        (status, count) -> text.append(", ").append(count).append(' ').append(words(status)));
    List<SurveyRow> done = of.converged();
    if (!done.isEmpty()) {
      Spread k = Spread.of(done.stream().mapToDouble(Series::permeability).toArray());
      text.append("; k ")
          .append(Numbers.significant(k.least(), 3))
          .append(" to ")
          .append(Numbers.significant(k.greatest(), 3))
          .append(" mD, median ")
          .append(Numbers.significant(k.median(), 3))
          .append(" mD");
    }
    return text.append('.').toString();
  }

  private static String words(SurveyStatus status) {
    return status == SurveyStatus.DOES_NOT_PERCOLATE
        ? "do not percolate"
        : status.word().replace('-', ' ');
  }

  private static String word(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT);
  }

  /**
   * All that is drawn, row by row with the same keys: points of surveys ({@code point}), points
   * from elsewhere ({@code given}), fits, curves of bands at the porosities of the figure, sizes of
   * blocks ({@code size}), and ratios.
   */
  public List<Map<String, Object>> rows() {
    List<Map<String, Object>> rows = new ArrayList<>();
    for (Series each : series) {
      for (SurveyRow row : each.drawn()) {
        Map<String, Object> point = row("point", each.name());
        point.put("block", row.job().block());
        point.put("axis", word(row.job().axis()));
        point.put("status", row.status().word());
        point.put("porosity", Series.porosity(row));
        point.put("permeability_mD", Series.permeability(row));
        point.put("source", each.image());
        rows.add(point);
      }
    }
    for (GivenPoint each : points) {
      Map<String, Object> given = row("given", each.label());
      each.block().ifPresent(block -> given.put("block", block));
      each.axis().ifPresent(axis -> given.put("axis", word(axis)));
      given.put("porosity", each.porosity());
      given.put("permeability_mD", each.permeability());
      given.put("source", each.image().orElse(null));
      rows.add(given);
    }
    for (Fit each : fits()) {
      Map<String, Object> fit = row("fit", each.of().name());
      fit.put("count", each.curve().points());
      fit.put("constant_mD", each.curve().constant());
      fit.put("constant_error", each.curve().error());
      fit.put("scatter_ln_k", each.curve().scatter());
      fit.put("sphere_diameter_m", each.curve().sphereDiameter());
      fit.put("source", KozenyCarman.SOURCE);
      rows.add(fit);
    }
    new CrossPlot(this).bandPoints().forEach(each -> rows.add(band(each)));
    for (Rev rev : revs()) {
      rev.scales().forEach(scale -> rows.addAll(sizes(rev.first().name(), scale)));
    }
    porosities.forEach(
        (rock, scales) ->
            scales.forEach(
                each ->
                    rows.add(
                        size(rock + ", whole image", each.edge(), "porosity", each.porosity()))));
    for (Comparison each : comparisons()) {
      Map<String, Object> ratio = row("ratio", each.what());
      spread(ratio, "ratio", each.ratios());
      ratio.put("source", "over " + each.over());
      rows.add(ratio);
    }
    return rows;
  }

  private static Map<String, Object> band(CrossPlot.BandPoint each) {
    Map<String, Object> point = row("band", each.curve().name());
    point.put("porosity", each.porosity());
    point.put("permeability_mD", each.curve().permeability(each.porosity()));
    point.put("source", each.band().source());
    return point;
  }

  private static List<Map<String, Object>> sizes(String name, BlockScale scale) {
    List<Map<String, Object>> sizes = new ArrayList<>();
    sizes.add(size(name, scale.edge(), "porosity", scale.porosity()));
    scale
        .permeability()
        .forEach(
            (axis, spread) -> {
              Map<String, Object> row = size(name, scale.edge(), "permeability_mD", spread);
              row.put("axis", word(axis));
              row.put("do_not_percolate", scale.dead().get(axis));
              sizes.add(row);
            });
    return sizes;
  }

  private static Map<String, Object> size(
      String name, double edge, String quantity, Spread spread) {
    Map<String, Object> row = row("size", name);
    row.put("block_edge_voxel", edge);
    spread(row, quantity, spread);
    return row;
  }

  private static void spread(Map<String, Object> row, String quantity, Spread spread) {
    row.put("quantity", quantity);
    row.put("count", spread.count());
    row.put("mean", spread.arithmetic());
    row.put("median", spread.median());
    row.put("deviation", spread.deviation());
    row.put("variation", spread.variation());
    row.put("least", spread.least());
    row.put("greatest", spread.greatest());
  }

  /** A row with all its keys, most of them unknown. */
  private static Map<String, Object> row(String kind, String name) {
    Map<String, Object> row = new LinkedHashMap<>();
    row.put("kind", kind);
    row.put("name", name);
    for (String key :
        List.of(
            "block",
            "axis",
            "status",
            "porosity",
            "permeability_mD",
            "block_edge_voxel",
            "quantity",
            "count",
            "mean",
            "median",
            "deviation",
            "variation",
            "least",
            "greatest",
            "do_not_percolate",
            "constant_mD",
            "constant_error",
            "scatter_ln_k",
            "sphere_diameter_m",
            "source")) {
      row.put(key, null);
    }
    return row;
  }
}
