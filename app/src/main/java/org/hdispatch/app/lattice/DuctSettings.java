package org.hdispatch.app.lattice;

import org.hdispatch.app.console.Choices;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.Streaming;
import org.hdispatch.lbm.VelocitySet;
import org.hdispatch.lbm.duct.Duct;

/**
 * What is stepped, but for sizes.
 *
 * @param lattice velocity set
 * @param streaming how populations move
 * @param storage precision of the populations
 * @param kernel form of the kernel
 */
record DuctSettings(VelocitySet lattice, Streaming streaming, Storage storage, KernelForm kernel) {

  /**
   * A duct.
   *
   * @throws IllegalArgumentException if the side or the bundle is out of its bounds
   */
  Duct duct(int side, BundleShape shape) {
    return new Duct(side, lattice, shape.in(side), streaming, storage, kernel);
  }

  /** In words. */
  @Override
  public String toString() {
    return String.join(
        ", ", lattice.name(), Choices.word(storage), Choices.word(streaming), Choices.word(kernel));
  }
}
