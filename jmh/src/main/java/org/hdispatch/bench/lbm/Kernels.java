package org.hdispatch.bench.lbm;

import java.util.Locale;
import org.hdispatch.lbm.KernelForm;

/** Reads forms of the kernel from benchmark parameters. */
public final class Kernels {
  /** Names the fastest form that the JVM can run. */
  public static final String FASTEST = "FASTEST";

  private Kernels() {}

  /**
   * The form that a text names; says which it is.
   *
   * @param text {@link #FASTEST}, or the name of a form
   * @throws IllegalArgumentException if it is neither
   */
  public static KernelForm parse(String text) {
    KernelForm form = text.equals(FASTEST) ? KernelForm.fastest() : KernelForm.valueOf(text);
    System.out.printf(Locale.ROOT, "%n# Kernel: %s%n", form);
    return form;
  }
}
