/** The command line: inspect a rock image, compute its permeability, measure this machine. */
module org.hdispatch.app {
  requires info.picocli;
  requires java.desktop;
  requires org.hdispatch.porous;
  requires org.hdispatch.sph;

  exports org.hdispatch.app;

  opens org.hdispatch.app to
      info.picocli;
}
