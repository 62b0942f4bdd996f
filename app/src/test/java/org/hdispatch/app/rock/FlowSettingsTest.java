package org.hdispatch.app.rock;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.hdispatch.porous.flow.FlowOptions;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;

class FlowSettingsTest {
  @Test
  void defaultsAreThoseOfTheFlow() {
    FlowSettings settings = new FlowSettings();
    new CommandLine(CommandSpec.create().addMixin("flow", CommandSpec.forAnnotatedObject(settings)))
        .setCaseInsensitiveEnumValuesAllowed(true)
        .parseArgs();
    assertEquals(FlowOptions.DEFAULT, settings.options());
  }
}
