package org.hdispatch.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Element;
import org.w3c.dom.Node;

/**
 * The Gradle build says the same as the Maven build: modules, dependencies, scopes, versions.
 *
 * <p>A dependency is written {@code project:NAME} (a module, by its folder) or {@code ARTIFACT} (a
 * library that the parent manages), its scope as Maven calls it.
 */
class BuildParityTest {

  private static final Map<String, String> MAVEN_SCOPE =
      Map.of(
          "api", "compile",
          "implementation", "compile",
          "runtimeOnly", "runtime",
          "testImplementation", "test",
          "testRuntimeOnly", "test",
          "compileOnly", "provided",
          "annotationProcessor", "provided");

  private static final Pattern MODULE_BLOCK =
      Pattern.compile(
          "(?ms)^project\\(\":([^\"]+)\"\\) \\{\\n    dependencies \\{\\n(.*?)^    }\\n}");

  private static final Pattern DEPENDENCY =
      Pattern.compile(
          " {8}\"(\\w+)\"\\((?:project\\(\":([^\"]+)\"\\)|lib\\(\"([^\"]+)\"\\)|(launcher))\\)");

  private final Path root = root();
  private final Element parent = xml(root.resolve("pom.xml"));
  private final List<String> modules = texts(child(parent, "modules"), "module");
  private final String gradle = withoutComments(root.resolve("build.gradle.kts"));

  @Test
  void modulesAreTheSame() {
    assertEquals(new TreeSet<>(modules), gradleDependencies().keySet());
    assertTrue(
        withoutComments(root.resolve("settings.gradle")).contains("pom.modules.module.each"),
        "settings.gradle must include the modules of pom.xml");
  }

  @Test
  void dependenciesAndTheirScopesAreTheSame() {
    assertEquals(mavenDependencies(), gradleDependencies());
  }

  @Test
  void everyLibraryTakesItsVersionFromAPropertyOfThePom() {
    Map<String, String> managed = new TreeMap<>();
    for (Element dependency :
        children(child(child(parent, "dependencyManagement"), "dependencies"), "dependency")) {
      managed.put(text(dependency, "artifactId"), text(dependency, "version"));
    }
    Set<String> libraries = new TreeSet<>();
    gradleDependencies().values().forEach(each -> libraries.addAll(each.keySet()));
    libraries.removeIf(name -> name.startsWith("project:"));
    assertFalse(libraries.isEmpty());
    for (String library : libraries) {
      String version = managed.get(library);
      assertTrue(
          version != null && version.matches("\\$\\{[a-z0-9-]+\\.version}"),
          "version must be a *.version property: library=" + library + ", version=" + version);
      String property = version.substring(2, version.length() - 1);
      assertFalse(text(child(parent, "properties"), property).isBlank(), property);
    }
  }

  @Test
  void gradleFilesHoldNoVersion() {
    Pattern number = Pattern.compile("\\d+\\.\\d+|[\"':]\\d+[\"']|\\(\\d+\\)|= *\\d");
    for (String name : List.of("settings.gradle", "build.gradle.kts")) {
      Matcher matcher = number.matcher(withoutComments(root.resolve(name)));
      assertFalse(matcher.find(), () -> name + ": " + matcher.group());
    }
  }

  @Test
  void archivesAreNamedAsTheArtifacts() {
    for (String module : modules) {
      String archive = module.equals("hdispatch-core") ? module : "hdispatch-" + module;
      assertEquals(archive, text(xml(root.resolve(module).resolve("pom.xml")), "artifactId"));
    }
    assertTrue(gradle.contains("if (name == \"hdispatch-core\") name else \"hdispatch-$name\""));
  }

  @Test
  void compilerFlagsAreTheSame() {
    List<String> flags = new ArrayList<>();
    Element managed = child(child(child(parent, "build"), "pluginManagement"), "plugins");
    for (Element plugin : children(managed, "plugin")) {
      if (text(plugin, "artifactId").equals("maven-compiler-plugin")) {
        Element configuration = child(plugin, "configuration");
        assertEquals("true", text(configuration, "parameters"));
        flags.add("-parameters");
        flags.addAll(texts(child(configuration, "compilerArgs"), "arg"));
      }
    }
    Matcher list =
        Pattern.compile("(?s)compilerArgs\\.addAll\\(\\s*listOf\\((.*?)\\)").matcher(gradle);
    assertTrue(list.find());
    List<String> quoted =
        Pattern.compile("\"([^\"]*)\"")
            .matcher(list.group(1))
            .results()
            .map(m -> m.group(1))
            .toList();
    assertEquals(flags, quoted);
  }

  @Test
  void onlyTheVectorModulesUseAnIncubatorModule() {
    for (String module : modules) {
      Element pom = xml(root.resolve(module).resolve("pom.xml"));
      boolean uses = pom.getTextContent().contains("--add-modules");
      assertEquals(module.endsWith("-vector"), uses, module);
      assertFalse(uses && pom.getTextContent().contains("-Werror"), module);
    }
    assertTrue(
        gradle.contains("val usesIncubator = name in listOf(\"lbm-vector\", \"sph-vector\")"));
    assertTrue(gradle.contains("listOf(\"--add-modules\", \"jdk.incubator.vector\")"));
  }

  @Test
  void testsThatNeedMinutesAreLeftOutByBoth() {
    assertEquals("validation", text(child(parent, "properties"), "excluded.groups"));
    assertTrue(gradle.contains("excludeTags(\"validation\")"));
    assertTrue(gradle.contains("systemProperty(\"hdispatch.data\""));
  }

  private Map<String, Map<String, String>> mavenDependencies() {
    Map<String, String> moduleOf = new TreeMap<>();
    for (String module : modules) {
      moduleOf.put(text(xml(root.resolve(module).resolve("pom.xml")), "artifactId"), module);
    }
    Map<String, Map<String, String>> scopes = new TreeMap<>();
    for (String module : modules) {
      Map<String, String> ofModule = new TreeMap<>();
      Element pom = xml(root.resolve(module).resolve("pom.xml"));
      for (Element dependency : children(child(pom, "dependencies"), "dependency")) {
        String artifact = text(dependency, "artifactId");
        String sibling = moduleOf.get(artifact);
        String scope =
            children(dependency, "scope").isEmpty() ? "compile" : text(dependency, "scope");
        assertTrue(
            children(dependency, "version").isEmpty(), "version must be managed: " + artifact);
        ofModule.put(sibling == null ? artifact : "project:" + sibling, scope);
      }
      scopes.put(module, ofModule);
    }
    return scopes;
  }

  private Map<String, Map<String, String>> gradleDependencies() {
    Map<String, Map<String, String>> scopes = new TreeMap<>();
    Matcher block = MODULE_BLOCK.matcher(gradle);
    while (block.find()) {
      Map<String, String> ofModule = new TreeMap<>();
      boolean launched = false;
      for (String line : block.group(2).lines().toList()) {
        Matcher dependency = DEPENDENCY.matcher(line);
        if (!dependency.matches() || !MAVEN_SCOPE.containsKey(dependency.group(1))) {
          fail("line must be one dependency: module=" + block.group(1) + ", line=" + line.strip());
        }
        String scope = MAVEN_SCOPE.get(dependency.group(1));
        if (dependency.group(4) != null) {
          launched = true; // Surefire adds it by itself
        } else if (dependency.group(2) != null) {
          ofModule.put("project:" + dependency.group(2), scope);
        } else {
          ofModule.put(dependency.group(3), scope);
        }
      }
      assertEquals(
          ofModule.containsKey("junit-jupiter"), launched, "launcher of " + block.group(1));
      scopes.put(block.group(1), ofModule);
    }
    assertEquals(
        scopes.size(), gradle.split("dependencies \\{", -1).length - 1, "dependencies elsewhere");
    return scopes;
  }

  /** The folder with settings.gradle, from the one the tests run in upwards. */
  static Path root() {
    Path folder = Path.of(System.getProperty("user.dir")).toAbsolutePath();
    while (!Files.exists(folder.resolve("settings.gradle"))) {
      folder = folder.getParent();
      if (folder == null) {
        return fail("settings.gradle must be above " + System.getProperty("user.dir"));
      }
    }
    return folder;
  }

  private static String withoutComments(Path file) {
    try {
      return Files.readString(file)
          .replace("\r\n", "\n")
          .replaceAll("(?sm)^\\s*/\\*.*?\\*/", "")
          .replaceAll("(?m)[ \\t]*(?<!:)//.*$", "");
    } catch (IOException e) {
      return fail("file must be readable: " + file, e);
    }
  }

  private static Element xml(Path file) {
    try {
      return DocumentBuilderFactory.newInstance()
          .newDocumentBuilder()
          .parse(file.toFile())
          .getDocumentElement();
    } catch (Exception e) {
      return fail("pom must be readable: " + file, e);
    }
  }

  private static List<Element> children(Element element, String name) {
    List<Element> found = new ArrayList<>();
    for (Node node = element.getFirstChild(); node != null; node = node.getNextSibling()) {
      if (node instanceof Element each && each.getTagName().equals(name)) {
        found.add(each);
      }
    }
    return found;
  }

  private static Element child(Element element, String name) {
    List<Element> found = children(element, name);
    assertEquals(1, found.size(), "one <" + name + "> in <" + element.getTagName() + ">");
    return found.get(0);
  }

  private static String text(Element element, String name) {
    return child(element, name).getTextContent().strip();
  }

  private static List<String> texts(Element element, String name) {
    return children(element, name).stream().map(each -> each.getTextContent().strip()).toList();
  }
}
