package org.hdispatch.porous.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.io.ImageFileException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SurveyTableTest {
  private static final List<String> FIGURES = List.of("porosity", "permeability_mD");
  private static final SurveyRow ROW =
      new SurveyRow(
          new SurveyJob(0, 4, new VoxelBox(0, 8, 0, 8, 8, 8), Axis.Y),
          SurveyStatus.DONE,
          "",
          Map.of("porosity", "0.25", "permeability_mD", "12.5"));

  @TempDir Path folder;

  private void survey() throws Exception {
    SurveySettings settings = new SurveySettings(Map.of("jobs", "2", "image", "rock.h5"));
    try (SurveyFiles files =
        SurveyFiles.open(folder, Shard.WHOLE, settings, FIGURES, List.of("job"))) {
      files.append(ROW, List.of("0"));
    }
  }

  private void refused(String part) {
    String message =
        assertThrows(ImageFileException.class, () -> SurveyTable.read(folder)).getMessage();
    assertTrue(message.contains(part), message);
  }

  @Test
  void readsWhatASurveyWroteAndLeavesATornLine() throws Exception {
    survey();
    Path csv = folder.resolve("survey.csv");
    String torn = Files.readString(csv) + "1,5,y,0";
    Files.writeString(csv, torn);
    SurveyTable table = SurveyTable.read(folder);
    assertEquals("rock.h5", table.settings().values().get("image"));
    assertEquals(List.of(ROW), table.rows());
    assertEquals(torn, Files.readString(csv));
  }

  @Test
  void whatIsNoSurveyIsRefused() throws Exception {
    refused("folder must hold a survey");
    survey();
    Files.writeString(folder.resolve("survey.csv"), "a,b\n1,2\n");
    refused("columns must be those of a survey");
    Files.writeString(folder.resolve("survey.properties"), "jobs=2\n");
    refused("settings must be whole");
  }
}
