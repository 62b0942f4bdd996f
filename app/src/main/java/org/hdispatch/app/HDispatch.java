package org.hdispatch.app;

import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Faults;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.StandardOptions;
import org.hdispatch.app.console.Version;
import org.hdispatch.app.gc.GcStudyCommand;
import org.hdispatch.app.gc.SoakCommand;
import org.hdispatch.app.lattice.DuctCommand;
import org.hdispatch.app.lattice.SettleCommand;
import org.hdispatch.app.particles.SearchStudyCommand;
import org.hdispatch.app.particles.SphCommand;
import org.hdispatch.app.permeability.InspectCommand;
import org.hdispatch.app.permeability.PermeabilityCommand;
import org.hdispatch.app.steady.SteadyStudyCommand;
import org.hdispatch.app.survey.SurveyCommand;
import org.hdispatch.app.survey.SurveyReportCommand;
import org.hdispatch.app.survey.UpscaleCommand;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** The program: {@code hdispatch COMMAND}. */
@Command(
    name = "hdispatch",
    description = "Flow through rock, computed by enduring threads that pull hash-keyed cells.",
    synopsisSubcommandLabel = "COMMAND",
    footer = {
      "",
      "Start with the bundled rock: hdispatch permeability",
      "Completion: source <(hdispatch generate-completion)"
    })
public final class HDispatch {
  @Mixin private final StandardOptions standard = new StandardOptions();

  private HDispatch() {}

  /**
   * Runs the program and ends the JVM with its exit code.
   *
   * @param args the command line
   */
  public static void main(String[] args) {
    System.setProperty("java.awt.headless", "true"); // pictures, but no window
    PrintWriter out = new PrintWriter(System.out, true);
    PrintWriter err = new PrintWriter(System.err, true);
    System.exit(Interruption.during(() -> run(Host.ofThisProcess(), out, err, args)));
  }

  /**
   * Runs a command line.
   *
   * @param host what it runs in
   * @param out receives the result
   * @param err receives everything else
   * @return the exit code
   */
  static int run(Host host, PrintWriter out, PrintWriter err, String... args) {
    Faults faults = new Faults(err, List.of(args).contains("--stacktrace"));
    CommandLine commandLine = commandLine(host).setOut(out).setErr(err);
    faults.handle(commandLine);
    try {
      return commandLine.execute(args);
    } catch (OutOfMemoryError e) { // in spite of the estimate before; what it needed is free again
      return faults.report(e);
    } finally {
      out.flush();
    }
  }

  /** The program with all its commands. */
  static CommandLine commandLine(Host host) {
    CommandLine commandLine = new CommandLine(new HDispatch());
    commandLine.addSubcommand(new InspectCommand(host));
    commandLine.addSubcommand(new PermeabilityCommand(host));
    commandLine.addSubcommand(new SurveyCommand(host));
    commandLine.addSubcommand(new SurveyReportCommand(host));
    commandLine.addSubcommand(new UpscaleCommand(host));
    commandLine.addSubcommand(new DuctCommand(host));
    commandLine.addSubcommand(new SettleCommand(host));
    commandLine.addSubcommand(SphCommand.commandLine(host));
    commandLine.addSubcommand(new SearchStudyCommand(host));
    commandLine.addSubcommand(new SteadyStudyCommand(host));
    commandLine.addSubcommand(new GcStudyCommand(host));
    commandLine.addSubcommand(new SoakCommand(host));
    commandLine.addSubcommand(new AutoComplete.GenerateCompletion());
    commandLine.setCaseInsensitiveEnumValuesAllowed(true);
    Map<String, String> exitCodes = new LinkedHashMap<>();
    for (ExitCode each : ExitCode.values()) {
      exitCodes.put(Integer.toString(each.code()), each.meaning());
    }
    describe(commandLine, exitCodes);
    return commandLine;
  }

  /** What picocli does not hand down to subcommands. */
  private static void describe(CommandLine commandLine, Map<String, String> exitCodes) {
    commandLine
        .getCommandSpec()
        .versionProvider(new Version())
        .usageMessage()
        .showDefaultValues(true)
        .sortOptions(false)
        .exitCodeListHeading("%nExit codes:%n")
        .exitCodeList(exitCodes);
    commandLine.getSubcommands().values().forEach(command -> describe(command, exitCodes));
  }
}
