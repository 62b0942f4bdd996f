package org.hdispatch.app.watch;

import java.util.List;
import org.hdispatch.porous.flow.FlowListener;

/** Several listeners as one; all hear everything, in their order, and one that has enough does. */
public record Listeners(List<FlowListener> all) implements FlowListener {
  @Override
  public void started(Start start) {
    all.forEach(each -> each.started(start));
  }

  @Override
  public void warmedUp() {
    all.forEach(FlowListener::warmedUp);
  }

  @Override
  public void progressed(Progress progress) {
    all.forEach(each -> each.progressed(progress));
  }

  @Override
  public boolean enough() {
    return all.stream().anyMatch(FlowListener::enough);
  }

  @Override
  public void stepped() {
    all.forEach(FlowListener::stepped);
  }
}
