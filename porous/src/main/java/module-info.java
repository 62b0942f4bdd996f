/** From a voxel image of rock to its permeability. */
module org.hdispatch.porous {
  requires transitive org.hdispatch.core;
  requires transitive org.hdispatch.lbm;
  requires org.hdispatch.sph;
  requires io.jhdf;

  exports org.hdispatch.porous.block;
  exports org.hdispatch.porous.darcy;
  exports org.hdispatch.porous.flow;
  exports org.hdispatch.porous.image;
  exports org.hdispatch.porous.io;
  exports org.hdispatch.porous.pore;
  exports org.hdispatch.porous.survey;
  exports org.hdispatch.porous.upscale;
}
