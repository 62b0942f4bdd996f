package org.hdispatch.app.particles;

import org.hdispatch.app.console.Choices;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.sph.SmoothingKernel;
import org.hdispatch.sph.SumForm;
import picocli.CommandLine.Option;

/** In which form sums over neighbours are computed. */
final class SumFormOption {
  @Option(
      names = "--form",
      paramLabel = "FORM",
      completionCandidates = Choices.OfSums.class,
      description =
          "Form of the sums: ${COMPLETION-CANDIDATES}. Default: the fastest that this Java runs.")
  private SumForm form;

  /**
   * The form of the sums.
   *
   * @throws UsageException if this Java does not run the one that was given
   */
  SumForm form(SmoothingKernel kernel) {
    SumForm fastest = SumForm.fastest(kernel);
    if (form == SumForm.VECTOR && fastest != form) {
      throw new UsageException(
          "--form vector must have sums for this kernel in this Java: kernel=" + kernel);
    }
    return form == null ? fastest : form;
  }
}
