package org.hdispatch.lbm;

import java.util.Arrays;
import org.hdispatch.cell.CellMap;

/** Finds the links of a bundle's nodes that pass through {@link Faces}. */
final class FaceLinker {
  private final Faces faces;
  private final VelocitySet set;
  private final int[] extent;
  private final Surroundings surroundings;
  private final int[] at = new int[3]; // coordinates of a node
  private final int[] step = new int[3]; // along the faces, to where a link comes from
  private int[] code = new int[1024];
  private int codeLength;

  FaceLinker(
      Faces faces,
      Lattice lattice,
      VelocitySet set,
      BundleSize size,
      CellMap<NodalBundle> bundles) {
    this.faces = faces;
    this.set = set;
    extent = new int[] {lattice.nx(), lattice.ny(), lattice.nz()};
    surroundings = new Surroundings(lattice, size, bundles);
  }

  FaceLinks links(NodalBundle bundle) {
    codeLength = 0;
    boolean looked = false;
    for (int node = 0; node < bundle.nodes(); node++) {
      at[0] = bundle.x(node);
      at[1] = bundle.y(node);
      at[2] = bundle.z(node);
      if (isAtFace(0) || isAtFace(1) || isAtFace(2)) {
        if (!looked) {
          surroundings.look(bundle);
          looked = true;
        }
        for (int i = 1; i < set.size(); i++) {
          addLink(bundle, node, i);
        }
      }
    }
    return codeLength == 0
        ? FaceLinks.NONE
        : new FaceLinks(faces, surroundings.sources(), Arrays.copyOf(code, codeLength));
  }

  private boolean isAtFace(int axis) {
    return faces.isBounded(axis) && (at[axis] == 0 || at[axis] == extent[axis] - 1);
  }

  /** Whether what arrives along velocity i comes through a face of the axis. */
  private boolean crosses(int axis, int i) {
    int from = at[axis] - set.component(i, axis);
    return faces.isBounded(axis) && (from < 0 || from == extent[axis]);
  }

  private void addLink(NodalBundle bundle, int node, int i) {
    boolean crossed = false;
    int kind = Faces.SYMMETRY;
    for (int axis = 0; axis < 3; axis++) {
      boolean crosses = crosses(axis, i);
      crossed |= crosses;
      step[axis] = crosses ? 0 : -set.component(i, axis);
      if (crosses && axis == faces.pressureAxis()) {
        kind = set.component(i, axis) > 0 ? Faces.FIRST : Faces.LAST;
      }
    }
    int here = surroundings.placeIn(bundle, at[0], at[1], at[2]);
    if (!crossed || !surroundings.open(here, step[0], step[1], step[2])) {
      return; // through no face, or a wall stands in the way along it: bounced back
    }
    int j = mirrored(i);
    int there = surroundings.slot(here + surroundings.distance(step[0], step[1], step[2]), j);
    NodalBundle other = surroundings.source(there);
    int order =
        other == bundle
            ? compare(i, bundle.populations(0).index(i, node), j, StreamPlan.index(there))
            : Long.compare(bundle.key(), other.key());
    if (order == 0 && kind == Faces.SYMMETRY) {
      return; // a link straight through a symmetry face: bounced back, as it should be
    }
    if (codeLength + FaceLinks.LENGTH > code.length) {
      code = Arrays.copyOf(code, 2 * codeLength);
    }
    code[codeLength] = node;
    code[codeLength + 1] = FaceLinks.pack(i, j, kind, order <= 0);
    code[codeLength + 2] = there;
    codeLength += FaceLinks.LENGTH;
  }

  private static int compare(int i, int index, int j, int otherIndex) {
    return i == j ? Integer.compare(index, otherIndex) : Integer.compare(i, j);
  }

  /** Velocity i with the components turned round that lead along the faces it crosses. */
  private int mirrored(int i) {
    for (int j = 1; j < set.size(); j++) {
      boolean found = true;
      for (int axis = 0; axis < 3; axis++) {
        int component = set.component(i, axis);
        found &= set.component(j, axis) == (step[axis] == 0 ? component : -component);
      }
      if (found) {
        return j;
      }
    }
    throw new AssertionError("velocity set must be symmetric: i=" + i);
  }
}
