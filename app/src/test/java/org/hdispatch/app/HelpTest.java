package org.hdispatch.app;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.hdispatch.app.console.Host;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;

class HelpTest {
  private static List<CommandLine> commands() {
    CommandLine root = HDispatch.commandLine(new Host(1, false));
    List<CommandLine> all = new ArrayList<>();
    collect(root, all);
    return all;
  }

  private static void collect(CommandLine command, List<CommandLine> all) {
    all.add(command);
    command.getSubcommands().values().forEach(each -> collect(each, all));
  }

  /** Of a description that picocli cannot format it complains on the screen. */
  @Test
  void descriptionsAreFormats() {
    for (CommandLine command : commands()) {
      for (String text : command.getCommandSpec().usageMessage().description()) {
        assertDoesNotThrow(() -> String.format(text), text);
      }
    }
  }

  @Test
  void everyCommandHelpsAndTellsItsVersion() {
    assertEquals(26, commands().size());
    for (CommandLine command : commands()) {
      List<String> words =
          new ArrayList<>(List.of(command.getCommandSpec().qualifiedName().split(" ")));
      words.remove(0);
      words.add("--help");
      Cli help = Cli.run(words.toArray());
      assertEquals(0, help.code(), help.err());
      assertTrue(help.out().startsWith("Usage: hdispatch"), help.out());
      assertTrue(help.out().contains("Exit codes:"), help.out());
      assertTrue(help.out().contains("  130   interrupted"), help.out());
      words.set(words.size() - 1, "--version");
      Cli version = Cli.run(words.toArray());
      assertEquals(0, version.code(), version.err());
      assertTrue(version.out().startsWith("H-Dispatch "), version.out());
      assertTrue(version.out().contains("Java " + System.getProperty("java.version")));
      assertTrue(version.out().contains("Collector "), version.out());
    }
  }

  @Test
  void everyOptionWithAValueTellsItsDefault() {
    for (CommandLine command : commands()) {
      assertTrue(command.getCommandSpec().usageMessage().showDefaultValues());
      for (ArgSpec each : command.getCommandSpec().args()) {
        boolean flag = each.arity().max() == 0;
        boolean told =
            each.initialValue() != null
                || each.defaultValue() != null
                || String.join(" ", each.description()).contains("Default: ");
        assertTrue(flag || told, each.toString());
      }
    }
    String help = Cli.run("permeability", "--help").out();
    for (String value : List.of("z", "0.001", "200000", "D3Q19", "trt", "wall", "slab", "1.0E-6")) {
      assertTrue(help.contains("Default: " + value + "\n"), value);
    }
  }

  @Test
  void completionScriptKnowsTheOptions() {
    Cli script = Cli.run("generate-completion");
    assertEquals(0, script.code(), script.err());
    assertTrue(script.out().contains("--voxel-edge"), script.out());
    assertTrue(script.out().startsWith("#!/usr/bin/env bash"), script.out());
  }

  @Test
  void commandMustBeNamed() {
    Cli.run().assertRefused(2, "missing required subcommand");
    Cli.run("permeabilty").assertRefused(2, "did you mean permeability?");
  }
}
