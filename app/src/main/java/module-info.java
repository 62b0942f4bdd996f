/** The command line: inspect a rock image, compute its permeability, measure this machine. */
module org.hdispatch.app {
  requires HdrHistogram;
  requires com.fasterxml.jackson.jr.ob;
  requires info.picocli;
  requires java.desktop;
  requires java.management;
  requires jdk.management;
  requires transitive org.hdispatch.core;
  requires org.hdispatch.porous;
  requires org.hdispatch.sph;

  exports org.hdispatch.app;
  exports org.hdispatch.app.study;

  opens org.hdispatch.app to
      info.picocli;
  opens org.hdispatch.app.console to
      info.picocli;
  opens org.hdispatch.app.gc to
      info.picocli;
  opens org.hdispatch.app.lattice to
      info.picocli;
  opens org.hdispatch.app.particles to
      info.picocli;
  opens org.hdispatch.app.permeability to
      info.picocli;
  opens org.hdispatch.app.rock to
      info.picocli;
  opens org.hdispatch.app.steady to
      info.picocli;
  opens org.hdispatch.app.survey to
      info.picocli;
  opens org.hdispatch.app.watch to
      info.picocli;
}
