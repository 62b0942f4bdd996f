package org.hdispatch.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hdispatch.app.console.Host;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;

/** The README, the pages under docs, and whatever else is written in Markdown. */
class DocumentationTest {
  private static final Pattern CODE_BLOCK = Pattern.compile("(?ms)^```.*?^```$");
  private static final Pattern INLINE_CODE = Pattern.compile("`[^`\n]*`");
  private static final Pattern LINK = Pattern.compile("\\]\\(([^)\\s]+)\\)");
  private static final Pattern HEADING = Pattern.compile("(?m)^#+ (.*)$");

  /** What follows ./hdispatch on its line, and on the next where a backslash ends it. */
  private static final Pattern COMMAND =
      Pattern.compile("(?<=\\./hdispatch )((?:\\\\\n|[^\n`'])+)");

  private static final Pattern OPTION = Pattern.compile("`(--[a-z][a-z-]*)");

  @Test
  void linksLeadToFilesAndHeadings() {
    Map<Path, String> pages = pages();
    assertTrue(pages.size() > 5, pages.keySet().toString());
    int links = 0;
    for (Path page : pages.keySet()) {
      String text = CODE_BLOCK.matcher(pages.get(page)).replaceAll("");
      for (String link : found(LINK, INLINE_CODE.matcher(text).replaceAll(""))) {
        if (!link.startsWith("http")) {
          String[] parts = link.split("#", 2);
          Path target = page.resolveSibling(parts[0]).normalize();
          target = parts[0].isEmpty() ? page : target;
          assertTrue(Files.exists(target), page + " -> " + link);
          if (parts.length == 2) {
            assertTrue(anchors(pages.get(target)).contains(parts[1]), page + " -> " + link);
          }
          links++;
        }
      }
    }
    assertTrue(links > 50, "links: " + links);
  }

  @Test
  void commandsAreUnderstood() {
    int commands = 0;
    for (Map.Entry<Path, String> page : pagesForUsers().entrySet()) {
      for (String command : found(COMMAND, page.getValue())) {
        String[] words =
            command
                .replaceAll("\\s#.*", "")
                .replace("\\\n", " ")
                .replaceAll("\"?\\$(\\w+)([^\"\\s]*)\"?", "1$2") // of the shell, all numbers
                .strip()
                .split("\\s+");
        if (!words[0].equals("...")) {
          understand(page.getKey(), words);
          commands++;
        }
      }
    }
    assertTrue(commands > 40, "commands: " + commands);
  }

  private static void understand(Path page, String... words) {
    try {
      HDispatch.commandLine(new Host(1, false)).parseArgs(words);
    } catch (ParameterException e) {
      fail(page + ": ./hdispatch " + String.join(" ", words), e);
    }
  }

  @Test
  void optionsExist() {
    Set<String> known = new TreeSet<>();
    collectOptions(HDispatch.commandLine(new Host(1, false)), known);
    Set<String> unknown = new TreeSet<>();
    for (Map.Entry<Path, String> page : pagesForUsers().entrySet()) {
      for (String option : found(OPTION, page.getValue())) {
        if (!known.contains(option)) {
          unknown.add(page.getKey() + ": " + option);
        }
      }
    }
    assertEquals(Set.of(), unknown);
  }

  private static void collectOptions(CommandLine command, Set<String> names) {
    names.addAll(command.getCommandSpec().optionsMap().keySet());
    command.getSubcommands().values().forEach(each -> collectOptions(each, names));
  }

  private static List<String> found(Pattern pattern, String text) {
    return pattern.matcher(text).results().map(found -> found.group(1)).toList();
  }

  /** The names of the headings, as GitHub makes them: the second of the same name ends in -1. */
  private static Set<String> anchors(String text) {
    Set<String> anchors = new TreeSet<>();
    for (String heading : found(HEADING, CODE_BLOCK.matcher(text).replaceAll(""))) {
      String name =
          heading.toLowerCase(Locale.ROOT).replaceAll("[^\\p{L}\\p{Nd}_ -]", "").replace(' ', '-');
      String anchor = name;
      for (int i = 1; !anchors.add(anchor); i++) {
        anchor = name + "-" + i;
      }
    }
    return anchors;
  }

  private static Map<Path, String> pagesForUsers() {
    return pages().entrySet().stream()
        .filter(
            page -> {
              Path path = BuildParityTest.root().relativize(page.getKey());
              return path.startsWith("docs") || path.equals(Path.of("README.md"));
            })
        .collect(Collectors.toMap(Map.Entry::getKey, Map.Entry::getValue));
  }

  /** What is written in Markdown, without what was built. */
  private static Map<Path, String> pages() {
    Path root = BuildParityTest.root();
    Map<Path, String> pages = new TreeMap<>();
    try (Stream<Path> files = Files.walk(root)) {
      for (Path file : (Iterable<Path>) files::iterator) {
        if (file.toString().endsWith(".md")
            && !root.relativize(file).toString().contains("target")) {
          pages.put(file, Files.readString(file));
        }
      }
    } catch (IOException e) {
      fail("pages must be readable: folder=" + root, e);
    }
    return pages;
  }
}
