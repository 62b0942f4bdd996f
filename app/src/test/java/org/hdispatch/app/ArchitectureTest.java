package org.hdispatch.app;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.conditions.ArchPredicates.are;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.methods;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.library.GeneralCodingRules;
import java.lang.invoke.VarHandle;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import org.hdispatch.app.console.Faults;
import org.hdispatch.porous.block.BlockStudy;
import org.junit.jupiter.api.Test;
import picocli.CommandLine.Command;

/** Who may use whom, and who may do what. */
class ArchitectureTest {
  private static final String CELL = "org.hdispatch.cell..";
  private static final String DISPATCH = "org.hdispatch.dispatch..";
  private static final String GC = "org.hdispatch.gc..";
  private static final String POISSON = "org.hdispatch.poisson..";
  private static final String LBM = "org.hdispatch.lbm..";
  private static final String SPH = "org.hdispatch.sph..";
  private static final String POROUS = "org.hdispatch.porous..";
  private static final String IO = "org.hdispatch.porous.io..";
  private static final String APP = "org.hdispatch.app..";
  private static final String STUDY = "org.hdispatch.app.study..";

  private static final String DRAW = "org.hdispatch.app.draw..";
  private static final String TEXT = "org.hdispatch.app.text..";

  private static final JavaClasses CODE =
      new ClassFileImporter()
          .withImportOption(new ImportOption.DoNotIncludeTests())
          .importPackages("org.hdispatch");

  @Test
  void everyModuleIsLookedAt() {
    for (String part : new String[] {CELL, DISPATCH, GC, POISSON, LBM, SPH, POROUS, IO, APP}) {
      assertTrue(CODE.stream().anyMatch(resideInAPackage(part)), part);
    }
    assertTrue(CODE.stream().noneMatch(c -> c.getSimpleName().endsWith("Test")));
  }

  @Test
  void coreUsesTheJdkAloneAndEclipseCollectionsInCellOnly() {
    classes()
        .that()
        .resideInAnyPackage(DISPATCH, GC)
        .should()
        .onlyDependOnClassesThat()
        .resideInAnyPackage("java..", "jdk..", "com.sun.management..", CELL, DISPATCH, GC)
        .check(CODE);
    noClasses()
        .that()
        .resideOutsideOfPackage(CELL)
        .should()
        .dependOnClassesThat()
        .resideInAPackage("org.eclipse.collections..")
        .check(CODE);
    classes()
        .that()
        .resideInAPackage(CELL)
        .should()
        .onlyDependOnClassesThat()
        .resideInAnyPackage("java..", "org.eclipse.collections..", CELL)
        .check(CODE);
    classes()
        .that()
        .resideInAPackage(GC)
        .should()
        .onlyDependOnClassesThat()
        .resideInAnyPackage("java..", "jdk.jfr..", "com.sun.management..", GC)
        .check(CODE);
    classes()
        .that()
        .resideInAPackage(POISSON)
        .should()
        .onlyDependOnClassesThat()
        .resideInAnyPackage("java..", CELL, DISPATCH, POISSON)
        .check(CODE);
  }

  @Test
  void methodsUseTheCoreAndNeverMeet() {
    for (String method : new String[] {LBM, SPH}) {
      classes()
          .that()
          .resideInAPackage(method)
          .should()
          .onlyDependOnClassesThat()
          .resideInAnyPackage("java..", "jdk.incubator.vector..", CELL, DISPATCH, method)
          .check(CODE);
    }
  }

  @Test
  void imagesPoresAndDarcyKnowNoMethod() {
    noClasses()
        .that()
        .resideInAnyPackage(
            "org.hdispatch.porous.image..",
            IO,
            "org.hdispatch.porous.pore..",
            "org.hdispatch.porous.survey..",
            "org.hdispatch.porous.darcy..")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(LBM, SPH, DISPATCH, "org.hdispatch.porous.flow..")
        .check(CODE);
  }

  @Test
  void nobodyUsesTheApp() {
    noClasses()
        .that()
        .resideOutsideOfPackage(APP)
        .should()
        .dependOnClassesThat()
        .resideInAPackage(APP)
        .check(CODE);
  }

  @Test
  void drawingAndTextKnowNothingOfCommands() {
    classes()
        .that()
        .resideInAnyPackage(DRAW, TEXT)
        .should()
        .onlyDependOnClassesThat()
        .resideInAnyPackage(
            "java..", "javax.imageio..", "org.hdispatch.porous.image..", IO, DRAW, TEXT)
        .check(CODE);
  }

  /** Commands do not know each other, and what they share knows none of them. */
  @Test
  void onlyTheProgramKnowsItsCommands() {
    Set<String> rooms = new TreeSet<>();
    CODE.stream()
        .filter(c -> c.isAnnotatedWith(Command.class) && !c.isEquivalentTo(HDispatch.class))
        .forEach(c -> rooms.add(c.getPackageName()));
    assertEquals(6, rooms.size(), rooms::toString);
    for (String room : rooms) {
      classes()
          .that()
          .resideInAPackage(room)
          .should()
          .onlyHaveDependentClassesThat()
          .resideInAnyPackage(room, "org.hdispatch.app")
          .check(CODE);
    }
  }

  @Test
  void librariesStayWhereTheyBelong() {
    onlyIn(IO, "io.jhdf..");
    onlyIn(APP, "picocli..");
    onlyIn(APP, "java.awt..");
    onlyIn(APP, "javax.imageio..");
    onlyIn(APP, "com.fasterxml..");
    onlyIn(STUDY, "org.HdrHistogram..");
    noClasses().should().dependOnClassesThat().resideInAPackage("org.slf4j..").check(CODE);
  }

  private static void onlyIn(String place, String library) {
    noClasses()
        .that()
        .resideOutsideOfPackage(place)
        .should()
        .dependOnClassesThat()
        .resideInAPackage(library)
        .check(CODE);
  }

  /**
   * All concurrency lives in dispatch (and gc, which reads other threads' counters). {@link
   * CancellationException} is how a run that ended early shows itself, {@link Callable} how picocli
   * calls a command; {@link Interruption} is the hook of Ctrl-C. What enduring threads are compared
   * with, the executors of the JDK, is in the study of garbage collection.
   */
  @Test
  void concurrencyLivesInTheDispatcher() {
    DescribedPredicate<JavaClass> harmless =
        DescribedPredicate.describe(
            "harmless",
            c -> c.isEquivalentTo(CancellationException.class) || c.isEquivalentTo(Callable.class));
    DescribedPredicate<JavaClass> elsewhere =
        DescribedPredicate.not(resideInAnyPackage(DISPATCH, GC));
    DescribedPredicate<JavaClass> noStudy =
        elsewhere.and(DescribedPredicate.not(resideInAPackage(STUDY)));
    noClasses()
        .that(are(noStudy))
        .should()
        .dependOnClassesThat(
            resideInAPackage("java.util.concurrent..").and(DescribedPredicate.not(harmless)))
        .check(CODE);
    noClasses()
        .that(are(noStudy))
        .and()
        .doNotBelongToAnyOf( // the last two ask: interrupted?
            Interruption.class, Faults.class, BlockStudy.class)
        .should()
        .dependOnClassesThat()
        .belongToAnyOf(Thread.class, ThreadLocal.class, ThreadGroup.class)
        .check(CODE);
    nothingVolatileOrSynchronizedIn(elsewhere);
  }

  /** Within dispatch, three classes hold it all; gc reads counters and needs none. */
  @Test
  void threadsMeetInThreeClasses() {
    DescribedPredicate<JavaClass> elsewhere =
        DescribedPredicate.describe(
            "are not one of the three",
            c ->
                resideInAnyPackage(DISPATCH, GC).test(c)
                    && !c.getName().matches(".*\\.(PullTickets|Signals|Crew(\\$.*)?)"));
    noClasses()
        .that(elsewhere)
        .should()
        .dependOnClassesThat(
            resideInAPackage("java.util.concurrent..")
                .and(
                    DescribedPredicate.not(
                        DescribedPredicate.describe(
                            "how a run ends", c -> c.isEquivalentTo(CancellationException.class))))
                .or(
                    DescribedPredicate.describe(
                        "VarHandle", c -> c.isEquivalentTo(VarHandle.class))))
        .check(CODE);
    nothingVolatileOrSynchronizedIn(elsewhere);
  }

  private static void nothingVolatileOrSynchronizedIn(DescribedPredicate<JavaClass> place) {
    fields()
        .that()
        .areDeclaredInClassesThat(place)
        .should()
        .notHaveModifier(JavaModifier.VOLATILE)
        .check(CODE);
    methods()
        .that()
        .areDeclaredInClassesThat(place)
        .should()
        .notHaveModifier(JavaModifier.SYNCHRONIZED)
        .check(CODE);
  }

  @Test
  void onlyTheAppPrints() {
    noClasses()
        .that()
        .resideOutsideOfPackage(APP)
        .should(GeneralCodingRules.ACCESS_STANDARD_STREAMS)
        .check(CODE);
  }

  @Test
  void nothingStaticChanges() {
    fields()
        .that()
        .areStatic()
        .and()
        .doNotHaveModifier(JavaModifier.SYNTHETIC)
        .should()
        .beFinal()
        .check(CODE);
  }

  @Test
  void packagesHaveNoCycles() {
    slices().matching("org.hdispatch.(**)").should().beFreeOfCycles().check(CODE);
  }
}
