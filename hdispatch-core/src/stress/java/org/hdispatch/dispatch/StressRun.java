package org.hdispatch.dispatch;

import java.util.TreeMap;
import org.openjdk.jcstress.JCStress;
import org.openjdk.jcstress.Options;
import org.openjdk.jcstress.infra.Status;
import org.openjdk.jcstress.infra.collectors.DiskReadCollector;
import org.openjdk.jcstress.infra.collectors.TestResult;

/**
 * Runs jcstress, and fails where jcstress alone would say nothing: when a test was not run at all,
 * for want of processors, of a matching name, or of a class that it needs.
 */
final class StressRun {
  private StressRun() {}

  /**
   * Runs the tests.
   *
   * @param args options of jcstress
   * @throws AssertionError if a test failed or was not run
   */
  public static void main(String[] args) throws Exception {
    Options options = new Options(args);
    if (!options.parse()) {
      throw new AssertionError("jcstress must know the options: " + String.join(" ", args));
    }
    JCStress jcstress = new JCStress(options);
    TreeMap<String, Long> samples = new TreeMap<>();
    jcstress.getTests().forEach(test -> samples.put(test, 0L));
    if (samples.isEmpty()) {
      throw new AssertionError("a test must match: " + options.getTestFilter());
    }
    jcstress.run(); // throws if an outcome was forbidden, a test threw, hung or broke its JVM
    DiskReadCollector results =
        new DiskReadCollector(options.getResultFile(), result -> add(samples, result));
    results.dump();
    results.close();
    samples.forEach((test, count) -> System.out.printf("%,15d samples  %s%n", count, test));
    if (samples.containsValue(0L)) {
      throw new AssertionError("every test must have run: samples=" + samples);
    }
  }

  private static void add(TreeMap<String, Long> samples, TestResult result) {
    if (result.status() != Status.NORMAL) {
      throw new AssertionError(result.getName() + ": " + result.status());
    }
    samples.merge(result.getName(), result.getTotalCount(), Long::sum);
  }
}
