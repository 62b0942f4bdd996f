package org.hdispatch.app.particles;

import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.StandardOptions;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code hdispatch sph CASE}: flows of particles, ready to run. */
@Command(
    name = "sph",
    description = "Step particles by smoothed particle hydrodynamics: cases that are ready to run.",
    synopsisSubcommandLabel = "CASE",
    commandListHeading = "Cases:%n")
public final class SphCommand {
  @Mixin private final StandardOptions standard = new StandardOptions();

  private SphCommand() {}

  /** The command with all its cases. */
  public static CommandLine commandLine(Host host) {
    CommandLine sph = new CommandLine(new SphCommand());
    sph.addSubcommand(new SphPeriodicCommand(host));
    for (ReadyCase each : ReadyCase.values()) {
      CommandLine line = new CommandLine(new SphCaseCommand(host, each));
      line.getCommandSpec().usageMessage().description(each.what());
      sph.addSubcommand(Choices.word(each), line);
    }
    return sph;
  }
}
