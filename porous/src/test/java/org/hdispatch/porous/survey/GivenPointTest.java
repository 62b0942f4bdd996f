package org.hdispatch.porous.survey;

import static org.hdispatch.porous.survey.SurveyRows.done;
import static org.hdispatch.porous.survey.SurveyRows.row;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.io.ImageFileException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class GivenPointTest {
  @TempDir Path folder;

  private List<GivenPoint> read(String text) throws IOException {
    return GivenPoint.read(Files.writeString(folder.resolve("points.csv"), text));
  }

  private void refused(String part, String text) {
    String message = assertThrows(ImageFileException.class, () -> read(text)).getMessage();
    assertTrue(message.contains(part), message);
  }

  @Test
  void permeabilityComesInMilliDarcyOrInSquaredVoxels() throws Exception {
    List<GivenPoint> points =
        read(
            """
            # measured
            label,porosity,permeability_mD,permeability_voxel2,voxel_edge_m,remark
            lab,0.2,150,,,"one, two"
            code,0.21,,0.05,5.345e-6,
            """);
    assertEquals(150, points.get(0).permeability());
    assertEquals(0.05 * 28_948, points.get(1).permeability(), 1); // 1 voxel² = 28 948 mD
    assertTrue(points.get(1).block().isEmpty());
  }

  @Test
  void whatCannotBeMeantIsRefusedWithItsLine() {
    refused("line=2", "label,porosity,permeability_mD\na,20,100\n");
    refused("porosity must be a fraction", "label,porosity,permeability_mD\na,20,100\n");
    refused("voxel_edge_m must be given", "label,porosity,permeability_voxel2\na,0.2,1\n");
    refused("label must be given", "label,porosity,permeability_mD\n,0.2,1\n");
    refused("values must be as many as columns", "label,porosity,permeability_mD\na,0.2\n");
    refused("table must hold points", "label,porosity,permeability_mD\n");
  }

  private static final List<SurveyRow> ROWS =
      List.of(
          done(0, 0, 8, Axis.X, 0.2, 110),
          done(0, 0, 8, Axis.Z, 0.2, 400),
          done(1, 8, 8, Axis.X, 0.2, 270),
          row(2, 16, 8, Axis.X, SurveyStatus.NOT_CONVERGED, 0.2, 1e6));

  @Test
  void ratiosAreOfTheSameBlockAndAxisAndOfConvergedFlows() throws Exception {
    List<GivenPoint> points =
        read(
            """
            label,porosity,permeability_mD,block,axis
            a,0.2,100,0,x
            a,0.2,300,1,X
            a,0.2,100,2,x
            a,0.2,100,7,x
            a,0.2,100,,x
            """);
    Spread ratios = GivenPoint.ratios(ROWS, "rock.h5", points);
    assertEquals(2, ratios.count());
    assertEquals(1.0, ratios.median(), 1e-15); // of 1.1 and 0.9
  }

  @Test
  void ratiosKeepToTheSizeAndTheImageThatAreNamed() throws Exception {
    String points = "label,porosity,permeability_mD,block,axis,size,image\na,0.2,100,0,x,";
    assertEquals(1, GivenPoint.ratios(ROWS, "rock.h5", read(points + "8,rock\n")).count());
    assertEquals(0, GivenPoint.ratios(ROWS, "rock.h5", read(points + "16,rock\n")).count());
    assertEquals(0, GivenPoint.ratios(ROWS, "rock.h5", read(points + "8,sand\n")).count());
    assertEquals(1, GivenPoint.ratios(ROWS, "rock.h5", read(points + ",\n")).count());
    assertEquals(Optional.empty(), read(points + ",\n").get(0).image());
  }

  @Test
  void methodsAreComparedBoxByBox() {
    List<SurveyRow> others =
        List.of(done(5, 0, 8, Axis.X, 0.2, 100), done(6, 9, 8, Axis.X, 0.2, 100));
    Spread ratios = MethodRatio.of(ROWS, others);
    assertEquals(1, ratios.count());
    assertEquals(1.1, ratios.median(), 1e-15);
  }
}
