package org.hdispatch.app;

import org.hdispatch.gc.GcWatch;
import picocli.CommandLine.IVersionProvider;

/** Versions of H-Dispatch, Java and the collector. */
final class Version implements IVersionProvider {
  /** Version of the project, from the manifest of its jar. */
  static String ofProject() {
    String version = Version.class.getPackage().getImplementationVersion();
    return version == null ? "development" : version;
  }

  /** Version of the Java runtime. */
  static String ofJava() {
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
