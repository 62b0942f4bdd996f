package org.hdispatch.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class GcOriginTest {
  @TempDir private Path folder;

  @Test
  void originOfThisJvmSaysWhatItIs() {
    GcOrigin here = GcOrigin.of(Jdk.running(), "c0de");
    assertTrue(here.runtime().startsWith(Jdk.running().version()), here::toString);
    assertEquals(Runtime.getRuntime().availableProcessors(), here.cores());
    assertTrue(here.system().startsWith(System.getProperty("os.name")), here::toString);
    assertTrue(here.memoryGib() >= 1, here::toString);
    assertFalse(here.vendor().isBlank() || here.processor().isBlank(), here::toString);
    assertEquals(List.of(), here.differences(GcOrigin.of(Jdk.running(), "c0de")));
    assertEquals(List.of("build"), here.differences(GcOrigin.of(Jdk.running(), "ba5e")));
  }

  @Test
  void processorIsNamedAsLinuxNamesIt() throws IOException {
    Path info = folder.resolve("cpuinfo");
    Files.writeString(info, "processor\t: 0\nmodel name\t: AMD EPYC\nmodel name\t: other\n");
    assertEquals("AMD EPYC", GcOrigin.processor(info));
    Files.writeString(info, "Processor\t: 0\n");
    assertEquals("unknown", GcOrigin.processor(info));
  }

  @Test
  void hashIsOfTheCodeAndNotOfItsPlace() throws IOException {
    Path a = Files.createDirectories(folder.resolve("a/sub"));
    Path b = Files.createDirectories(folder.resolve("b/sub"));
    Files.writeString(a.resolve("One.class"), "one");
    Files.writeString(b.resolve("One.class"), "one");
    String hash = CodeHash.of(a.getParent().toString());
    assertTrue(hash.matches("[0-9a-f]{12}"), hash);
    assertEquals(hash, CodeHash.of(b.getParent() + File.pathSeparator + folder.resolve("none")));
    Files.writeString(b.resolve("One.class"), "two");
    assertNotEquals(hash, CodeHash.of(b.getParent().toString()));
  }

  @Test
  void jarsThatAManifestNamesCount() throws IOException {
    Path lib = Files.createDirectory(folder.resolve("lib"));
    Path jar = folder.resolve("app.jar");
    Manifest manifest = new Manifest();
    manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
    manifest.getMainAttributes().put(Attributes.Name.CLASS_PATH, "lib/more.jar lib/none.jar");
    write(jar, manifest);
    String alone = CodeHash.of(jar.toString());
    write(lib.resolve("more.jar"), new Manifest());
    assertNotEquals(alone, CodeHash.of(jar.toString()));
  }

  private static void write(Path jar, Manifest manifest) throws IOException {
    try (OutputStream file = Files.newOutputStream(jar);
        JarOutputStream out = new JarOutputStream(file, manifest)) {
      out.finish();
    }
  }
}
