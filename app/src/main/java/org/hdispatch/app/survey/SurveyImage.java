package org.hdispatch.app.survey;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.draw.ColourMap;
import org.hdispatch.app.draw.Picture;
import org.hdispatch.app.draw.StudyPage.Photo;
import org.hdispatch.app.rock.ImageSource;
import org.hdispatch.app.rock.Rock;
import org.hdispatch.app.rock.SampleRock;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.LabelRule;
import org.hdispatch.porous.image.Phase;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.porous.survey.PorosityScale;
import org.hdispatch.porous.survey.SurveyTable;

/**
 * The image of a survey, as far as a report wants to see it.
 *
 * @param source the image
 * @param rule which labels are pore; empty if it is not segmented
 * @param host what this runs in
 */
record SurveyImage(ImageSource source, Optional<LabelRule> rule, Host host) {
  private static final int LONG_SIDE = 256; // pixels of a slice, at most
  private static final int GREYS = 255;

  /** What a survey calls its image: the name of the file, and of the dataset behind a colon. */
  private record Name(String file, Optional<String> dataset) {
    static Name of(String image) {
      int colon = image.lastIndexOf(":/");
      return colon < 0
          ? new Name(image, Optional.empty())
          : new Name(image.substring(0, colon), Optional.of(image.substring(colon + 1)));
    }

    boolean isOf(Path path) {
      return path.getFileName() != null && path.getFileName().toString().equals(file);
    }
  }

  /**
   * Whether a file bears the name of the image of a survey.
   *
   * @param path the file
   * @param table the survey
   */
  static boolean isNamed(Path path, SurveyTable table) {
    return Name.of(table.settings().values().getOrDefault("image", "")).isOf(path);
  }

  /**
   * The image of a survey: the bundled one, one of those given, or else a file of its name in the
   * folder of the survey, beside that, or in the working folder.
   *
   * @return empty if there is none of the right size
   * @throws ImageFileException if it cannot be read
   */
  static Optional<SurveyImage> find(SurveyTable table, List<Path> given, Host host)
      throws ImageFileException {
    Map<String, String> settings = table.settings().values();
    Optional<LabelRule> rule =
        Optional.ofNullable(settings.get("pore_values")).map(SurveyImage::rule);
    SampleRock sample = new SampleRock();
    Name name = Name.of(settings.getOrDefault("image", ""));
    if (name.file().equals(sample.name())) {
      return Optional.of(new SurveyImage(sample, rule, host));
    }
    if (name.file().isEmpty()) {
      return Optional.empty();
    }
    List<Path> places = new ArrayList<>(given.stream().filter(name::isOf).toList());
    Path folder = table.folder().toAbsolutePath().normalize();
    places.add(folder.resolve(name.file()));
    places.add(folder.resolveSibling(name.file()));
    places.add(Path.of(name.file()));
    for (Path place : places) {
      if (Files.exists(place)) {
        ImageSource source = ImageSource.stored(place, name.dataset(), size(settings));
        if (size(settings).equals(Optional.of(source.whole()))) {
          return Optional.of(new SurveyImage(source, rule, host));
        }
      }
    }
    return Optional.empty();
  }

  private static LabelRule rule(String labels) {
    return LabelRule.poreIs(Arrays.stream(labels.split(",")).mapToInt(Integer::parseInt).toArray());
  }

  private static Optional<VoxelBox> size(Map<String, String> settings) {
    String[] n = settings.getOrDefault("image_size", "").split(",");
    return n.length == 3
        ? Optional.of(
            VoxelBox.whole(Integer.parseInt(n[0]), Integer.parseInt(n[1]), Integer.parseInt(n[2])))
        : Optional.empty();
  }

  /** Porosity by the size of cubes; none if it is not segmented. */
  List<PorosityScale> porosities() throws ImageFileException {
    return rule.isEmpty()
        ? List.of()
        : PorosityScale.of(source.whole(), box -> Rock.read(source, box, host), rule.get());
  }

  /** Planes through the middle, across x, y and z. */
  List<Photo> slices() throws ImageFileException {
    VoxelBox whole = source.whole();
    List<Photo> slices = new ArrayList<>();
    for (Axis axis : Axis.values()) {
      int at = axis.length(whole.nx(), whole.ny(), whole.nz()) / 2;
      VoxelBox plane =
          switch (axis) {
            case X -> new VoxelBox(at, 0, 0, 1, whole.ny(), whole.nz());
            case Y -> new VoxelBox(0, at, 0, whole.nx(), 1, whole.nz());
            case Z -> new VoxelBox(0, 0, at, whole.nx(), whole.ny(), 1);
          };
      VoxelImage image = Rock.read(source, plane, host);
      int width = axis == Axis.X ? whole.ny() : whole.nx();
      String axes =
          switch (axis) {
            case X -> "y to the right, z down";
            case Y -> "x to the right, z down";
            case Z -> "x to the right, y down";
          };
      slices.add(
          new Photo(
              Picture.png(draw(image, width)), Choices.word(axis) + " = " + at + ": " + axes));
    }
    return slices;
  }

  /**
   * A plane of voxels as a picture of {@link #LONG_SIDE} at most: the mean of what falls together.
   */
  private BufferedImage draw(VoxelImage plane, int width) {
    int height = plane.voxels() / width;
    int together = Math.max(1, (Math.max(width, height) + LONG_SIDE - 1) / LONG_SIDE);
    BufferedImage picture =
        new BufferedImage(
            (width + together - 1) / together,
            (height + together - 1) / together,
            BufferedImage.TYPE_INT_RGB);
    for (int row = 0; row < picture.getHeight(); row++) {
      for (int column = 0; column < picture.getWidth(); column++) {
        double sum = 0;
        int count = 0;
        for (int y = row * together; y < Math.min(height, (row + 1) * together); y++) {
          for (int x = column * together; x < Math.min(width, (column + 1) * together); x++) {
            sum += shade(plane.label(x + width * y));
            count++;
          }
        }
        picture.setRGB(column, row, colour(sum / count));
      }
    }
    return picture;
  }

  /** How much of a pore a voxel is; of one that is not segmented, how bright. */
  private double shade(int label) {
    return rule.isPresent()
        ? (rule.get().phase(label) == Phase.PORE ? 1 : 0)
        : label / (double) GREYS;
  }

  private int colour(double shade) {
    int from = rule.isPresent() ? ColourMap.SOLID : 0;
    int to = rule.isPresent() ? ColourMap.PORE : 0xffffff;
    int colour = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
      int low = from >> shift & 0xff;
      int high = to >> shift & 0xff;
      colour |= (int) Math.round(low + shade * (high - low)) << shift;
    }
    return colour;
  }
}
