/** Enduring threads that pull hash-keyed cells from a dispatcher. */
module org.hdispatch.core {
  requires org.eclipse.collections.api;
  requires org.eclipse.collections.impl;
  requires java.management;
  requires jdk.management;
  requires jdk.jfr;

  exports org.hdispatch.cell;
  exports org.hdispatch.dispatch;
  exports org.hdispatch.gc;
  exports org.hdispatch.poisson;
}
