package org.hdispatch.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.platform.commons.support.AnnotationSupport;

/** What the javadoc promises has a test, and the concurrency stays small enough to be read. */
class GuaranteesTest {
  private static final Path SOURCES = Path.of("src/main/java/org/hdispatch/dispatch");
  private static final Pattern PROMISE = Pattern.compile("<li>(.*?)(?=<li>|</ol>)");
  private static final Pattern TEST = Pattern.compile("\\{@code (\\w+Test)\\.(\\w+)}");

  private static String javadoc(String type) throws IOException {
    String source = Files.readString(SOURCES.resolve(type + ".java"));
    return source.substring(0, source.indexOf("public ")).replaceAll("\\s*\\n \\*\\s*", " ");
  }

  @ParameterizedTest
  @CsvSource({"CellKernel, 4", "Dispatcher, 7"})
  void everyGuaranteeNamesATestThatExists(String type, int guarantees) throws Exception {
    String javadoc = javadoc(type);
    String promises = javadoc.substring(javadoc.indexOf("<ol>"), javadoc.indexOf("</ol>") + 5);
    List<MatchResult> items = PROMISE.matcher(promises).results().toList();
    assertEquals(guarantees, items.size());
    for (MatchResult item : items) {
      List<MatchResult> tests = TEST.matcher(item.group(1)).results().toList();
      assertFalse(tests.isEmpty(), "without a test: " + item.group(1));
      for (MatchResult test : tests) {
        Class<?> tester = Class.forName("org.hdispatch.dispatch." + test.group(1));
        assertTrue(
            Arrays.stream(tester.getDeclaredMethods())
                .filter(method -> method.getName().equals(test.group(2)))
                .anyMatch(GuaranteesTest::isTest),
            "no such test: " + test.group());
      }
    }
  }

  private static boolean isTest(Method method) {
    return AnnotationSupport.isAnnotated(method, Test.class)
        || AnnotationSupport.isAnnotated(method, ParameterizedTest.class);
  }

  /** That all concurrency is in these is checked by the architecture test of the app. */
  @ParameterizedTest
  @CsvSource({"PullTickets", "Signals", "Crew"})
  void theConcurrencyCanBeReadInOneSitting(String type) throws IOException {
    try (var lines = Files.lines(SOURCES.resolve(type + ".java"))) {
      assertTrue(lines.count() < 200);
    }
  }
}
