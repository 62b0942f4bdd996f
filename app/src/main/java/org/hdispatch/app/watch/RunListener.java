package org.hdispatch.app.watch;

import java.util.Locale;
import org.hdispatch.app.console.StatusLine;
import org.hdispatch.lbm.duct.DuctRun;
import org.hdispatch.sph.cases.SphRun;

/** Watches the collector while a measured run is stepped, and shows how far it is. */
public final class RunListener implements DuctRun.Listener, SphRun.Listener {
  private final CollectorWatch collector;
  private final StatusLine status; // null: nobody watches
  private final String what;

  /**
   * Makes a listener.
   *
   * @param status where to show how far it is; null: nobody watches
   * @param what is run
   */
  public RunListener(CollectorWatch collector, StatusLine status, String what) {
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
