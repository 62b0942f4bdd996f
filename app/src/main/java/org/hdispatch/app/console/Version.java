package org.hdispatch.app.console;

import org.hdispatch.gc.GcWatch;
import org.hdispatch.porous.block.BlockSettings;
import picocli.CommandLine.IVersionProvider;

/** Versions of H-Dispatch, Java and the collector. */
public final class Version implements IVersionProvider {
  /** Version of the project, as in the rows of surveys. */
  public static String ofProject() {
    return BlockSettings.version();
  }

  /** Version of the Java runtime. */
  public static String ofJava() {
    return System.getProperty("java.version");
  }

  @Override
  public String[] getVersion() {
    return new String[] {
      "H-Dispatch " + ofProject(),
      "Java " + ofJava() + " (" + System.getProperty("java.vm.name") + ")",
      "Collector " + GcWatch.collector()
    };
  }
}
