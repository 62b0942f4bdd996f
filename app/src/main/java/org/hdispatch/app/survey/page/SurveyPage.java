package org.hdispatch.app.survey.page;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.hdispatch.app.draw.BlockMap;
import org.hdispatch.app.draw.LogPlot.Scale;
import org.hdispatch.app.draw.StudyPage;
import org.hdispatch.app.draw.StudyPage.Photo;
import org.hdispatch.app.text.Numbers;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.survey.BlockScale;
import org.hdispatch.porous.survey.KozenyCarman;
import org.hdispatch.porous.survey.PorosityScale;
import org.hdispatch.porous.survey.ReferenceBand;
import org.hdispatch.porous.survey.Spread;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveyStatus;

/** Surveys as a page: figure, block sizes, slices, maps, tables. */
public final class SurveyPage {
  private static final int DIGITS = 3;
  private static final int MOST_BLOCKS = 400; // in a table
  private static final int MOST_LAYERS = 12; // in a map

  private final SurveyStudy report;
  private final Map<String, List<Photo>> slices;

  /**
   * A page.
   *
   * @param report what it is about
   * @param slices pictures of each rock, if its image is there
   */
  public SurveyPage(SurveyStudy report, Map<String, List<Photo>> slices) {
    this.report = report;
    this.slices = new LinkedHashMap<>(slices);
  }

  /**
   * The page.
   *
   * @param command that draws it again
   * @param files that lie beside it
   * @throws ImageFileException if a table of tensors or of the upscaled sample that lies beside a
   *     survey cannot be read
   */
  public String html(String command, List<String> files) throws ImageFileException {
    StudyPage page =
        new StudyPage(
            "Survey of "
                + String.join(
                    ", ", new TreeSet<>(report.series().stream().map(Series::rock).toList())),
            report.series().stream().map(Series::name).collect(Collectors.joining("; ")) + ".");
    page.section("What was found").verdict(report.sentences());
    figure(page);
    sizes(page);
    slices.forEach(
        (rock, photos) ->
            page.section("Slices: " + rock)
                .photos("Through the middle of the image: pores blue, solid grey.", photos));
    for (Series each : report.series()) {
      maps(page, each);
    }
    for (Series each : report.series()) {
      blocks(page, each);
    }
    for (Series each : report.series()) {
      beside(page, each);
    }
    settings(page);
    page.section("Do it again");
    report.series().forEach(each -> page.command(SurveyCommandLine.of(each)));
    page.command(command).files(files);
    return page.toString();
  }

  private void figure(StudyPage page) {
    page.section("Permeability against porosity");
    if (!CrossPlot.hasPoints(report)) {
      page.paragraph("No block has a permeability above 0: there is nothing to draw.");
      return;
    }
    page.figure(
        "Each point is a block and a direction of flow; blocks that do not percolate have no place"
            + " on a logarithmic axis.",
        List.of(new CrossPlot(report).svg()));
    List<String> sources = new ArrayList<>();
    for (ReferenceBand each : report.bands()) {
      sources.add(each.title() + ": " + each.source() + ".");
    }
    if (!report.fits().isEmpty()) {
      sources.add("Kozeny-Carman: " + KozenyCarman.SOURCE + ".");
    }
    page.points(sources);
  }

  private void sizes(StudyPage page) {
    page.section("Size of the blocks")
        .paragraph(
            "Where mean and spread no longer change with the size, a block of it represents the"
                + " rock. Mean, standard deviation and coefficient of variation over the blocks of"
                + " a size; a block that does not percolate counts with k = 0.");
    List<String> pictures = new SizePlot(report).pictures();
    if (!pictures.isEmpty()) {
      page.figure("Mean and standard deviation by the edge of the blocks.", pictures);
    }
    List<List<String>> rows = new ArrayList<>();
    for (SurveyStudy.Rev rev : report.revs()) {
      rows.add(List.of(rev.first().name().replace(", " + rev.first().blockWords(), "")));
      for (BlockScale scale : rev.scales()) {
        rows.add(size(Numbers.plain(scale.edge(), 4), "porosity", scale.porosity(), ""));
        scale
            .permeability()
            .forEach(
                (axis, spread) ->
                    rows.add(
                        size(
                            "",
                            "k along " + word(axis) + ", mD",
                            spread,
                            Integer.toString(scale.dead().get(axis)))));
      }
    }
    report
        .porosities()
        .forEach(
            (rock, scales) -> {
              rows.add(List.of(rock + ", the whole image"));
              for (PorosityScale scale : scales) {
                rows.add(size(Integer.toString(scale.edge()), "porosity", scale.porosity(), ""));
              }
            });
    page.table(
        "Edge in voxels (of blocks that are no cubes, that of the cube as large).",
        List.of("edge", "of", "blocks", "mean", "deviation", "variation", "do not percolate"),
        rows);
  }

  private static List<String> size(String edge, String of, Spread spread, String dead) {
    return List.of(
        edge,
        of,
        Integer.toString(spread.count()),
        Numbers.significant(spread.arithmetic(), DIGITS),
        spread.count() > 1 ? Numbers.significant(spread.deviation(), DIGITS) : "",
        Double.isFinite(spread.variation()) ? Numbers.significant(spread.variation(), 2) : "",
        dead);
  }

  private static String word(Axis axis) {
    return axis.name().toLowerCase(Locale.ROOT);
  }

  private void maps(StudyPage page, Series of) {
    List<SurveyRow> rows = of.table().rows();
    List<BlockMap.Block> porosities = new ArrayList<>();
    Map<Axis, List<BlockMap.Block>> permeabilities = new TreeMap<>();
    TreeSet<VoxelBox> seen = new TreeSet<>((a, b) -> a.toString().compareTo(b.toString()));
    for (SurveyRow row : rows) {
      VoxelBox box = row.job().box();
      if (seen.add(box)) {
        porosities.add(new BlockMap.Block(box, row.number("porosity")));
      }
      OptionalDouble k =
          row.status() == SurveyStatus.DONE
              ? row.number("permeability_mD")
              : OptionalDouble.empty();
      permeabilities
          .computeIfAbsent(row.job().axis(), axis -> new ArrayList<>())
          .add(new BlockMap.Block(box, k));
    }
    if (porosities.size() < 2) {
      return;
    }
    List<Integer> layers = BlockMap.layers(porosities);
    int last = layers.get(Math.min(layers.size(), MOST_LAYERS) - 1);
    List<String> pictures = new ArrayList<>();
    map(pictures, "Porosity", "porosity", porosities, porosities, last);
    List<BlockMap.Block> all = permeabilities.values().stream().flatMap(List::stream).toList();
    permeabilities.forEach(
        (axis, blocks) ->
            map(
                pictures,
                "Permeability along " + word(axis),
                "permeability, mD",
                blocks,
                all,
                last));
    page.section("Map: " + of.name())
        .figure(
            "Layers of blocks along z, x to the right, y downwards."
                + (layers.size() > MOST_LAYERS
                    ? " The first " + MOST_LAYERS + " layers of " + layers.size() + "."
                    : ""),
            pictures);
  }

  /** A map of the layers up to one, on a scale for these and others. */
  private static void map(
      List<String> pictures,
      String heading,
      String title,
      List<BlockMap.Block> blocks,
      List<BlockMap.Block> scaled,
      int last) {
    double[] values =
        scaled.stream()
            .flatMapToDouble(each -> each.value().stream())
            .filter(value -> value > 0)
            .sorted()
            .toArray();
    if (values.length > 0) {
      pictures.add(
          BlockMap.of(
              heading,
              "no permeability",
              blocks.stream().filter(each -> each.box().z0() <= last).toList(),
              Scale.close(
                  title,
                  values[0],
                  values[values.length - 1],
                  value -> Numbers.plain(value, DIGITS))));
    }
  }

  private static void blocks(StudyPage page, Series of) {
    Map<String, List<SurveyRow>> blocks =
        of.table().rows().stream()
            .collect(
                Collectors.groupingBy(
                    row -> row.job().block() + " " + row.job().box(),
                    LinkedHashMap::new,
                    Collectors.toList()));
    List<Axis> axes =
        of.table().rows().stream().map(row -> row.job().axis()).distinct().sorted().toList();
    List<String> head = new ArrayList<>(List.of("block", "x0,y0,z0", "porosity", "connected"));
    axes.forEach(axis -> head.add("k along " + word(axis) + ", mD"));
    head.add("remarks");
    List<List<String>> rows = new ArrayList<>();
    for (List<SurveyRow> block : blocks.values()) {
      if (rows.size() < MOST_BLOCKS) {
        rows.add(block(block, axes));
      }
    }
    page.section("Blocks: " + of.name())
        .table(
            (blocks.size() > MOST_BLOCKS
                    ? "The first " + MOST_BLOCKS + " of " + blocks.size() + " blocks; all"
                    : "All " + blocks.size() + " blocks; more of them")
                + " in survey.csv. Connected: the porosity that spans the block along the first"
                + " direction.",
            head,
            rows);
  }

  private static List<String> block(List<SurveyRow> rows, List<Axis> axes) {
    SurveyRow first = rows.get(0);
    VoxelBox box = first.job().box();
    List<String> cells =
        new ArrayList<>(
            List.of(
                Long.toString(first.job().block()),
                box.x0() + "," + box.y0() + "," + box.z0(),
                figure(first, "porosity"),
                figure(first, "porosity_connected")));
    List<String> remarks = new ArrayList<>();
    for (Axis axis : axes) {
      String k = "";
      for (SurveyRow row : rows) {
        if (row.job().axis() == axis) {
          k = figure(row, "permeability_mD");
          if (row.status() != SurveyStatus.DONE) {
            remarks.add(
                word(axis)
                    + ": "
                    + row.status().word().replace('-', ' ')
                    + (row.cause().isEmpty() ? "" : " (" + row.cause() + ")"));
          }
        }
      }
      cells.add(k);
    }
    cells.add(String.join("; ", remarks));
    return cells;
  }

  private static String figure(SurveyRow row, String column) {
    OptionalDouble value = row.number(column);
    return value.isPresent() ? Numbers.significant(value.getAsDouble(), DIGITS) : "";
  }

  private static void beside(StudyPage page, Series of) throws ImageFileException {
    List<TableBeside> tables = TableBeside.of(of.table().folder());
    if (tables.isEmpty()) {
      return;
    }
    page.section("Tensors and the whole: " + of.name());
    for (TableBeside each : tables) {
      List<List<String>> rows = each.rows();
      page.table(
          each.title()
              + (rows.size() > MOST_BLOCKS
                  ? ". The first " + MOST_BLOCKS + " of " + rows.size() + "."
                  : "."),
          each.head(),
          rows.subList(0, Math.min(rows.size(), MOST_BLOCKS)));
    }
  }

  private void settings(StudyPage page) {
    List<Series> series = report.series();
    List<String> head = new ArrayList<>(List.of("setting"));
    series.forEach(each -> head.add(each.name()));
    TreeSet<String> names = new TreeSet<>();
    series.forEach(each -> names.addAll(each.settings().keySet()));
    List<List<String>> rows = new ArrayList<>();
    for (String name : names) {
      List<String> row = new ArrayList<>(List.of(name.replace('_', ' ')));
      series.forEach(each -> row.add(each.setting(name)));
      rows.add(row);
    }
    page.section("Settings").table("What the rows depend on.", head, rows);
  }
}
