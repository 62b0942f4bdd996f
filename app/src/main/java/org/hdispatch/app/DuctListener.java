package org.hdispatch.app;

import java.util.Locale;
import org.hdispatch.lbm.duct.DuctRun;

/** Watches the collector while a duct is stepped, and shows how far it is. */
final class DuctListener implements DuctRun.Listener {
  private final CollectorWatch collector;
  private final StatusLine status; // null: nobody watches
  private final String what;

  DuctListener(CollectorWatch collector, StatusLine status, String what) {
    this.collector = collector;
    this.status = status;
    this.what = what;
  }

  @Override
  public void started() {
    collector.begin();
  }

  @Override
  public void warmedUp() {
    collector.warmedUp();
  }

  @Override
  public void progressed(long step, long lastStep) {
    if (status != null) {
      status.show(String.format(Locale.ROOT, "%s  step %d of %d", what, step, lastStep));
    }
  }

  @Override
  public void measured() {
    collector.stepped();
  }
}
