package org.hdispatch.porous.image;

import java.io.Serializable;
import java.util.Set;
import java.util.TreeSet;

/**
 * The rule that says which labels of an image are pore; every other label is solid.
 *
 * <p>Files differ: most raw files have 0 = pore (LBPM, Imperial College), most NumPy files 1 = pore
 * (porespy, kabs). A look at the porosity tells.
 *
 * @param poreLabels the labels that are pore, each 0..255
 */
public record LabelRule(Set<Integer> poreLabels) implements Serializable {

  /**
   * A rule.
   *
   * @throws IllegalArgumentException if there is no label, or one lies outside 0..255
   */
  public LabelRule {
    if (poreLabels.isEmpty()) {
      throw new IllegalArgumentException("at least one label must be pore: labels=" + poreLabels);
    }
    for (int label : poreLabels) {
      if (label < 0 || label >= VoxelImage.LABELS) {
        throw new IllegalArgumentException("pore label must be within 0..255: label=" + label);
      }
    }
    poreLabels = Set.copyOf(poreLabels);
  }

  /**
   * The rule in which these labels are pore.
   *
   * @param labels labels, each 0..255; several are allowed
   * @return the rule
   * @throws IllegalArgumentException if there is no label, or one lies outside 0..255
   */
  public static LabelRule poreIs(int... labels) {
    Set<Integer> set = new TreeSet<>();
    for (int label : labels) {
      set.add(label);
    }
    return new LabelRule(set);
  }

  /**
   * The phase of a label.
   *
   * @param label a label, 0..255
   * @return {@link Phase#PORE} if the label is one of the pore labels
   */
  public Phase phase(int label) {
    return poreLabels.contains(label) ? Phase.PORE : Phase.SOLID;
  }

  /** The pore labels in rising order, such as {@code pore=0,2}. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder("pore=");
    String comma = "";
    for (int label : new TreeSet<>(poreLabels)) {
      text.append(comma).append(label);
      comma = ",";
    }
    return text.toString();
  }
}
