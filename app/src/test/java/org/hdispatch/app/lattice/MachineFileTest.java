package org.hdispatch.app.lattice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.Streaming;
import org.hdispatch.lbm.VelocitySet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MachineFileTest {
  private static final DuctSettings DOUBLE =
      new DuctSettings(VelocitySet.D3Q15, Streaming.IN_PLACE, Storage.DOUBLE, KernelForm.SCALAR);
  private static final DuctSettings SINGLE =
      new DuctSettings(VelocitySet.D3Q15, Streaming.IN_PLACE, Storage.SINGLE, KernelForm.SCALAR);

  @TempDir Path folder;

  private final List<String> warnings = new ArrayList<>();

  private MachineFile file(String name) {
    return new MachineFile(Optional.of(folder.resolve(name)), warnings::add);
  }

  @Test
  void keepsAShapeForEachSetting() {
    MachineFile file = file("made/as/needed.properties");
    assertEquals(Optional.empty(), file.bundle(DOUBLE, 200));
    assertTrue(file.keepBundle(DOUBLE, BundleShape.parse("all,20,20")));
    assertTrue(file.keepBundle(SINGLE, BundleShape.parse("40")));
    MachineFile again = file("made/as/needed.properties");
    assertEquals(Optional.of(BundleShape.parse("all,20,20")), again.bundle(DOUBLE, 200));
    assertEquals(Optional.of(BundleShape.parse("40")), again.bundle(SINGLE, 200));
    assertEquals(List.of(), warnings);
  }

  @Test
  void keepsWhatASweepOfLargeDuctsRecommends() {
    MachineFile file = file("machine");
    SweepResult small =
        new SweepResult(DOUBLE, 1, List.of(SweepResultTest.point(99, "16", 2, 90, 50)));
    assertTrue(file.keepRecommended(small).startsWith("no (a duct below 100^3"));
    assertFalse(Files.exists(folder.resolve("machine")));
    SweepResult large =
        new SweepResult(
            DOUBLE,
            1,
            List.of(
                SweepResultTest.point(100, "16", 2, 90, 50),
                SweepResultTest.point(100, "all,8,8", 2, 91, 50),
                SweepResultTest.point(100, SweepResult.CONTROL, 2, 99, 50)));
    String stored = "in " + folder.resolve("machine") + ", the default of duct --bundle";
    assertEquals(stored, file.keepRecommended(large));
    assertEquals(Optional.of(BundleShape.parse("all,8,8")), file.bundle(DOUBLE, 200));
    MachineFile none = new MachineFile(Optional.empty(), warnings::add);
    assertEquals("no", none.keepRecommended(large));
    assertEquals(List.of(), warnings);
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "20x20", "", "all"})
  void wrongShapeIsSaidAndIgnored(String value) throws IOException {
    file("machine").keepBundle(DOUBLE, BundleShape.parse("7,7,8"));
    Path path = folder.resolve("machine");
    Files.writeString(path, Files.readString(path).replace("7,7,8", value));
    assertEquals(Optional.empty(), file("machine").bundle(DOUBLE, 400)); // too large for all
    assertEquals(1, warnings.size());
    assertTrue(warnings.get(0).contains("(ignored): file=" + path), warnings.get(0));
    assertTrue(warnings.get(0).endsWith("bundle=" + value), warnings.get(0));
  }

  @Test
  void fileThatCannotBeReadIsSaidAndLeftAsItIs() throws IOException {
    Path path = folder.resolve("machine");
    Files.writeString(path, "a=\\u12");
    assertEquals(Optional.empty(), file("machine").bundle(DOUBLE, 20));
    assertFalse(file("machine").keepBundle(DOUBLE, BundleShape.parse("20")));
    assertEquals(2, warnings.size());
    assertEquals("a=\\u12", Files.readString(path));
  }

  @Test
  void placeThatCannotBeWrittenIsSaid() throws IOException {
    Files.writeString(folder.resolve("plain"), "a file, not a folder");
    assertFalse(file("plain/machine").keepBundle(DOUBLE, BundleShape.parse("20")));
    assertEquals(1, warnings.size());
    assertTrue(warnings.get(0).contains("nothing is stored"), warnings.get(0));
  }

  @Test
  void noPlaceKeepsNothing() {
    MachineFile none = new MachineFile(Optional.empty(), warnings::add);
    assertFalse(none.keepBundle(DOUBLE, BundleShape.parse("20")));
    assertEquals(Optional.empty(), none.bundle(DOUBLE, 20));
    assertEquals(List.of(), warnings);
  }
}
