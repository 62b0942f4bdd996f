package org.hdispatch.porous.block;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.hdispatch.dispatch.Dispatcher;
import org.hdispatch.porous.darcy.PhysicalFlow;
import org.hdispatch.porous.flow.FlowListener;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.flow.Inlet;
import org.hdispatch.porous.flow.Sides;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.LabelRule;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.io.RawImages;
import org.hdispatch.porous.survey.BlockGrid;
import org.hdispatch.porous.survey.Extent;
import org.hdispatch.porous.survey.SurveyJob;
import org.hdispatch.porous.survey.SurveyPlan;
import org.hdispatch.porous.survey.SurveyRow;
import org.hdispatch.porous.survey.SurveySettings;
import org.hdispatch.porous.survey.SurveyStatus;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BlockStudyTest {
  private static final VoxelBox WHOLE = VoxelBox.whole(16, 8, 8);

  @TempDir Path folder;

  /** A duct of 4 x 4 voxels along z, and beside it solid. */
  private BlockStudy study(BlockSettings settings) throws IOException {
    byte[] labels = new byte[16 * 8 * 8];
    for (int n = 0; n < labels.length; n++) {
      int x = n % 16;
      int y = n / 16 % 8;
      labels[n] = (byte) (x >= 2 && x < 6 && y >= 2 && y < 6 ? 1 : 0);
    }
    Path file = Files.write(folder.resolve("duct.raw"), labels);
    return new BlockStudy(
        RawImages.open(file, WHOLE), "duct.raw", settings, HeapLimit.ofThisProcess());
  }

  private static SurveyPlan plan() {
    Extent block = new Extent(8, 8, 8);
    return SurveyPlan.all(new BlockGrid(WHOLE, block, block), List.of(Axis.Z, Axis.X));
  }

  private static <T> T sent(T object, Class<T> type) throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(object);
    }
    try (ObjectInputStream in =
        new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
      return type.cast(in.readObject());
    }
  }

  @Test
  void jobDoneElsewhereGivesTheSameRow() throws Exception {
    BlockSettings settings = BlockSettings.of(1e-6);
    BlockSettings there = sent(settings, BlockSettings.class);
    assertEquals(settings, there);
    try (Dispatcher one = Dispatcher.withWorkers(1);
        Dispatcher two = Dispatcher.withWorkers(2)) {
      for (int number = 0; number < plan().jobs(); number++) {
        SurveyJob job = plan().job(number);
        SurveyRow here = study(settings).run(one, job, FlowListener.NONE).row();
        SurveyRow row = study(there).run(two, sent(job, SurveyJob.class), FlowListener.NONE).row();
        assertEquals(here, sent(row, SurveyRow.class));
        SurveyStatus expected = number == 0 ? SurveyStatus.DONE : SurveyStatus.DOES_NOT_PERCOLATE;
        assertEquals(expected, row.status());
        assertEquals(number < 2 ? "0.25" : "0.0", row.figures().get("porosity"));
        assertEquals("duct.raw", row.figures().get("image"));
      }
    }
  }

  @Test
  void settingsArriveAsTheyWereSent() throws Exception {
    for (FlowOptions options :
        List.of(
            FlowOptions.DEFAULT,
            FlowOptions.DEFAULT
                .withRelaxationTime(0.9)
                .withInletLayers(5)
                .withBoundaries(Sides.MIRROR, Inlet.SLAB)
                .withTolerance(0.02)
                .withMaxSteps(77)
                .withAxis(Axis.X),
            FlowOptions.IMMERSED)) {
      assertEquals(options, sent(options, FlowOptions.class));
    }
  }

  @Test
  void surveySettingsTellImagesPlansAndFlowsApart() throws Exception {
    Map<String, String> which = Map.of("block", "8,8,8");
    BlockSettings settings = BlockSettings.of(1e-6);
    SurveySettings all = study(settings).settings(plan(), which);
    assertEquals(4, all.jobs());
    assertEquals("z,x", all.values().get("axes"));
    assertEquals("16,8,8", all.values().get("image_size"));
    assertEquals("8,8,8", all.values().get("block"));
    assertEquals("1", all.values().get("pore_values"));
    assertEquals("chosen", all.values().get("tau"));
    assertTrue(all.values().containsKey(SurveySettings.BLOCKS_CRC));
    assertEquals(all, study(settings).settings(plan(), which));
    FlowChoice finer =
        FlowChoice.DEFAULT.with(FlowOptions.DEFAULT.withTolerance(1e-4).withRelaxationTime(1));
    Map<String, String> other = study(settings.withChoice(finer)).settings(plan(), which).values();
    assertEquals("1.0E-4", other.get("tolerance"));
    assertEquals("1.0", other.get("tau"));
  }

  @Test
  void whatDoesNotFitIsARowThatSaysSo() throws Exception {
    study(BlockSettings.of(1e-6));
    BlockStudy small =
        new BlockStudy(
            RawImages.open(folder.resolve("duct.raw"), WHOLE),
            "duct.raw",
            BlockSettings.of(1e-6),
            new HeapLimit(HeapLimit.BASE + 4000));
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      SurveyRow row = small.run(dispatcher, plan().job(0), FlowListener.NONE).row();
      assertEquals(SurveyStatus.FAILED, row.status());
      assertTrue(row.cause().startsWith("heap must hold the flow of 128 pore voxels"), row.cause());
    }
  }

  @Test
  void settingsThatDoNotGoTogetherAreRefused() {
    BlockSettings good = BlockSettings.of(1e-6);
    assertThrows(IllegalArgumentException.class, () -> BlockSettings.of(0));
    assertThrows(IllegalArgumentException.class, () -> good.withOutside(List.of(256), Outside.CUT));
    assertThrows(IllegalArgumentException.class, () -> good.withOutside(List.of(1), Outside.CUT));
    assertThrows(IllegalArgumentException.class, () -> settings(0, Walls.BOUNCE_BACK, List.of()));
    assertThrows(IllegalArgumentException.class, () -> settings(2, Walls.IMB, List.of()));
    assertThrows(
        IllegalArgumentException.class, () -> settings(1, Walls.BOUNCE_BACK, List.of(0, 255)));
    assertThrows(IllegalArgumentException.class, () -> settings(1, Walls.IMB, List.of(3, 3)));
    assertEquals(good, settings(1, Walls.BOUNCE_BACK, List.of()));
  }

  private static BlockSettings settings(int refine, Walls walls, List<Integer> grey) {
    return new BlockSettings(
        LabelRule.poreIs(1),
        1e-6,
        refine,
        walls,
        grey,
        List.of(),
        Outside.FLAG,
        FlowChoice.DEFAULT,
        PhysicalFlow.WATER);
  }

  @Test
  void figuresWithoutAnEdgeAreUnknownInMetres() throws Exception {
    try (Dispatcher dispatcher = Dispatcher.withWorkers(1)) {
      BlockStudy study = study(BlockSettings.of(1e-6));
      BlockStudy.Done done = study.run(dispatcher, plan().job(0), FlowListener.NONE);
      Pores pores = study.block(plan().job(0).box()).pores().orElseThrow();
      Map<String, Object> figures =
          new FlowFigures(done.flow().orElseThrow(), OptionalDouble.empty(), PhysicalFlow.WATER)
              .values(pores.space());
      assertEquals(null, figures.get("permeability_mD"));
      assertEquals(
          done.row().figures().get("permeability_voxel2"),
          figures.get("permeability_voxel2").toString());
    }
  }

  @Test
  void causeIsNeverNullAndKnowsNoMachine() {
    assertEquals(
        "java.lang.IllegalArgumentException", BlockStudy.cause(new IllegalArgumentException()));
    assertEquals(
        "heap must hold a flow: needed=100 MiB (give java -Xmx128m)",
        BlockStudy.cause(new HeapException("a flow", 100 << 20, 50 << 20)));
  }
}
