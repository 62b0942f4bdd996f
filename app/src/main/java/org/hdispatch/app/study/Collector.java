package org.hdispatch.app.study;

import java.util.List;

/** A garbage collector, and how a JVM is told to use it. */
public enum Collector {
  SERIAL("Serial", "-XX:+UseSerialGC"),
  PARALLEL("Parallel", "-XX:+UseParallelGC"),
  G1("G1", "-XX:+UseG1GC"),
  ZGC("ZGC", "-XX:+UseZGC"),
  SHENANDOAH("Shenandoah", "-XX:+UseShenandoahGC"),
  /** Exists from JDK 24 on, without an unlocking option from 25 on. */
  SHENANDOAH_GENERATIONAL(
      "Shenandoah gen.", "-XX:+UseShenandoahGC", "-XX:ShenandoahGCMode=generational"),
  /** Never reclaims anything. */
  EPSILON("Epsilon", "-XX:+UnlockExperimentalVMOptions", "-XX:+UseEpsilonGC");

  private final String title;
  private final List<String> options;

  Collector(String title, String... options) {
    this.title = title;
    this.options = List.of(options);
  }

  /** Its name in tables. */
  public String title() {
    return title;
  }

  /** Options of the JVM. */
  public List<String> options() {
    return options;
  }
}
