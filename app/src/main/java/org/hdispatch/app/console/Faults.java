package org.hdispatch.app.console;

import java.io.PrintWriter;
import java.nio.channels.ClosedByInterruptException;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import org.hdispatch.lbm.immersed.LostBodyException;
import org.hdispatch.porous.block.HeapException;
import org.hdispatch.porous.flow.DivergedException;
import org.hdispatch.porous.io.ImageFileException;
import org.hdispatch.sph.BlownUpException;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;

/** Turns what was thrown into one line on standard error and an exit code. */
public final class Faults {
  private final PrintWriter err;
  private final boolean stacktrace;

  /**
   * Makes a reporter.
   *
   * @param err receives the lines
   * @param stacktrace whether stack traces are wanted
   */
  public Faults(PrintWriter err, boolean stacktrace) {
    this.err = err;
    this.stacktrace = stacktrace;
  }

  /** Says what happened and returns the exit code. */
  public int report(Throwable thrown) {
    ExitCode code = code(thrown);
    err.println("hdispatch: " + line(code, thrown).replaceAll("\\s*\\R\\s*", " "));
    if (stacktrace) {
      thrown.printStackTrace(err);
    }
    err.flush();
    return code.code();
  }

  /** The exit code of what was thrown. */
  public static ExitCode code(Throwable thrown) {
    if (Thread.currentThread().isInterrupted()) {
      return ExitCode.INTERRUPTED; // whatever could not go on because of that
    }
    // A kernel's exception is the cause of the one that says where it happened.
    for (Throwable each = thrown; each != null; each = each.getCause()) {
      if (each instanceof CancellationException || each instanceof ClosedByInterruptException) {
        return ExitCode.INTERRUPTED;
      }
      if (each instanceof OutOfMemoryError || each instanceof HeapException) {
        return ExitCode.TOO_LARGE;
      }
      if (each instanceof BlownUpException) {
        return ExitCode.NOT_CONVERGED;
      }
    }
    if (thrown instanceof ParameterException || thrown instanceof UsageException) {
      return ExitCode.USAGE;
    }
    if (thrown instanceof ImageFileException) {
      return ExitCode.FILE;
    }
    return thrown instanceof DivergedException || thrown instanceof LostBodyException
        ? ExitCode.NOT_CONVERGED
        : ExitCode.FAULT;
  }

  private static String line(ExitCode code, Throwable thrown) {
    if (thrown instanceof ParameterException parameter) {
      return usageLine(parameter);
    }
    return switch (code) {
      case INTERRUPTED -> "interrupted";
      case TOO_LARGE -> thrown instanceof HeapException ? thrown.getMessage() : heapRanOut(thrown);
      case FAULT -> "fault of H-Dispatch (please report it, with --stacktrace): " + thrown;
      default -> thrown.getMessage();
    };
  }

  private static String heapRanOut(Throwable thrown) {
    long mebibytes = Runtime.getRuntime().maxMemory() >> 20;
    return "heap must hold the computation: heap="
        + mebibytes
        + " MiB (give java -Xmx"
        + 2 * mebibytes
        + "m, or HDISPATCH_JAVA_OPTS=-Xmx"
        + 2 * mebibytes
        + "m), cause="
        + thrown;
  }

  private static String usageLine(ParameterException e) {
    String help = " (see " + e.getCommandLine().getCommandSpec().qualifiedName() + " --help)";
    if (e.getCause() instanceof TypeConversionException && e.getArgSpec() != null) {
      ArgSpec argument = e.getArgSpec();
      String name =
          argument instanceof OptionSpec option ? option.longestName() : argument.paramLabel();
      String form =
          e.getCause() instanceof GrammarException text ? text.grammar() : expected(argument);
      return name + " must be " + form + ": " + name + "=" + e.getValue() + help;
    }
    if (e instanceof UnmatchedArgumentException unmatched) {
      List<String> suggestions = unmatched.getSuggestions();
      String meant = suggestions.isEmpty() ? "" : ", did you mean " + suggestions.get(0) + "?";
      return "argument must be known: " + String.join(" ", unmatched.getUnmatched()) + meant + help;
    }
    String message = e.getMessage();
    return message.substring(0, 1).toLowerCase(Locale.ROOT) + message.substring(1) + help;
  }

  private static String expected(ArgSpec argument) {
    Class<?> type = argument.auxiliaryTypes()[0];
    if (type.isEnum()) {
      StringBuilder choices = new StringBuilder("one of");
      String comma = " ";
      for (String choice : argument.completionCandidates()) {
        choices.append(comma).append(choice);
        comma = ", ";
      }
      return choices.toString();
    }
    return type == Double.class || type == double.class ? "a number" : "an integer";
  }

  /** Makes a command line report through this. */
  public void handle(CommandLine commandLine) {
    commandLine.setParameterExceptionHandler((e, args) -> report(e));
    commandLine.setExecutionExceptionHandler((e, command, parsed) -> report(e));
  }
}
