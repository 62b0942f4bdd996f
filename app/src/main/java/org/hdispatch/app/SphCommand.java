package org.hdispatch.app;

import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code hdispatch sph CASE}: flows of particles, ready to run. */
@Command(
    name = "sph",
    description = "Step particles by smoothed particle hydrodynamics: cases that are ready to run.",
    synopsisSubcommandLabel = "CASE",
    commandListHeading = "Cases:%n")
final class SphCommand {
  @Mixin private final StandardOptions standard = new StandardOptions();

  private SphCommand() {}

  /** The command with all its cases. */
  static CommandLine commandLine(Host host) {
    return new CommandLine(new SphCommand()).addSubcommand(new SphPeriodicCommand(host));
  }
}
