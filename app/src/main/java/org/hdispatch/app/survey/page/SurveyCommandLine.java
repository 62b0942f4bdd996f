package org.hdispatch.app.survey.page;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The command that computes a survey again, from its settings. */
final class SurveyCommandLine {
  private static final Pattern RANDOM = Pattern.compile("(\\d+) at random, seed (-?\\d+)");
  private static final String PLACES = "at ";
  private static final String CHOSEN = "chosen";

  private SurveyCommandLine() {}

  static String of(Series series) {
    StringBuilder line = new StringBuilder("./hdispatch survey");
    String image = series.image();
    int dataset = image.lastIndexOf(":/");
    String file = dataset < 0 ? image : image.substring(0, dataset);
    if (!file.contains("(")) { // not the bundled sample
      line.append(' ').append(quoted(file));
    }
    option(line, "--dataset", dataset < 0 ? "" : image.substring(dataset + 1));
    if (file.endsWith(".raw") || file.endsWith(".raw.gz")) {
      option(line, "--dims", series.setting("image_size"));
    }
    option(line, "--box", series.setting("box"));
    option(line, "--voxel-edge", series.setting("voxel_edge_m"));
    option(line, "--block", series.setting("block"));
    option(line, "--stride", series.setting("stride"));
    blocks(line, series.setting("blocks"));
    String[] outside = series.setting("outside").split(" "); // flag 3,4
    if (outside.length == 2) {
      option(line, "--outside", outside[0]);
      option(line, "--outside-value", outside[1]);
    }
    for (String name :
        new String[] {
          "pore_values",
          "axes",
          "method",
          "sides",
          "inlet",
          "inlet_layers",
          "approach",
          "tolerance",
          "max_steps",
          "refine",
          "lattice",
          "storage",
          "collision",
          "tau",
          "walls",
          "solid_fraction_range",
          "smoothing_length",
          "wall_factor",
          "viscosity",
          "density",
          "pressure_gradient"
        }) {
      String option =
          switch (name) {
            case "pore_values" -> "--pore-value";
            case "axes" -> "--axis";
            default -> "--" + name.replace('_', '-');
          };
      option(line, option, series.setting(name));
    }
    return line.append(" --output ").append(quoted(series.table().folder().toString())).toString();
  }

  /** Blocks are kept as numbers, {@code at x,y,z; x,y,z}, or {@code 9 at random, seed 1}. */
  private static void blocks(StringBuilder line, String words) {
    Matcher random = RANDOM.matcher(words);
    if (random.matches()) {
      option(line, "--random", random.group(1));
      option(line, "--seed", random.group(2));
    } else if (words.startsWith(PLACES)) {
      for (String place : words.substring(PLACES.length()).split("; ")) {
        option(line, "--origin", place);
      }
    } else {
      option(line, "--blocks", words);
    }
  }

  private static void option(StringBuilder line, String name, String value) {
    if (!value.isEmpty() && !value.equals(CHOSEN)) {
      line.append(' ').append(name).append(' ').append(quoted(value));
    }
  }

  private static String quoted(String value) {
    return value.matches("[\\w./,:=+-]+") ? value : "'" + value.replace("'", "'\\''") + "'";
  }
}
