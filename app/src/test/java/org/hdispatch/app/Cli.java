package org.hdispatch.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hdispatch.app.console.Host;

/**
 * What a command line did, run inside this JVM.
 *
 * @param code exit code
 * @param out standard output
 * @param err standard error
 */
public record Cli(int code, String out, String err) {
  private static final Host HOST = new Host(Runtime.getRuntime().maxMemory(), false);

  private static final Pattern MEMBER =
      Pattern.compile("  \"(\\w+)\": (null|true|false|-?\\d+(?:\\.\\d+)?(?:E-?\\d+)?|\".*\"),?");

  public static Cli run(Object... args) {
    return run(HOST, args);
  }

  public static Cli run(Host host, Object... args) {
    return run(host, new StringWriter(), args);
  }

  /** A run during which standard error hears what is written to it. */
  public static Cli run(Host host, StringWriter err, Object... args) {
    String[] words = new String[args.length];
    for (int i = 0; i < args.length; i++) {
      words[i] = args[i].toString();
    }
    StringWriter out = new StringWriter();
    int code = HDispatch.run(host, new PrintWriter(out), new PrintWriter(err), words);
    return new Cli(code, out.toString(), err.toString());
  }

  /** A run that went well; keys and JSON values of its result. */
  public static Map<String, String> json(Object... args) {
    Cli run = run(args);
    assertEquals(0, run.code(), run.err());
    assertEquals("", run.err());
    return run.members();
  }

  /** Keys and JSON values of the output, which must be one flat JSON object. */
  public Map<String, String> members() {
    assertTrue(out.startsWith("{\n") && out.endsWith("\n}\n"), out);
    Map<String, String> members = new LinkedHashMap<>();
    String[] lines = out.substring(2, out.length() - 3).split("\n");
    for (int i = 0; i < lines.length; i++) {
      Matcher member = MEMBER.matcher(lines[i]);
      assertTrue(member.matches(), lines[i]);
      assertEquals(i < lines.length - 1, lines[i].endsWith(","), lines[i]);
      assertEquals(null, members.put(member.group(1), member.group(2)), "key twice");
    }
    return members;
  }

  /** Asserts one line on standard error, nothing on standard output. */
  public void assertRefused(int expectedCode, String... parts) {
    assertEquals(expectedCode, code, err);
    assertEquals("", out);
    assertEquals(1, err.lines().count(), err);
    assertTrue(err.startsWith("hdispatch: "), err);
    assertTrue(!err.toLowerCase(java.util.Locale.ROOT).contains("invalid"), err);
    for (String part : parts) {
      assertTrue(err.contains(part), () -> part + " <- " + err);
    }
  }
}
