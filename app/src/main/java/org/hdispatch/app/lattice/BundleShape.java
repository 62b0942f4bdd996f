package org.hdispatch.app.lattice;

import org.hdispatch.app.console.GrammarException;
import org.hdispatch.lbm.BundleSize;
import picocli.CommandLine.ITypeConverter;

/**
 * The shape of a bundle as users write it: {@code 20} for a cube, or {@code nx,ny,nz}, each a
 * number of nodes or {@code all} of the lattice's.
 *
 * @param nx nodes along x, or {@link #ALL}
 * @param ny nodes along y, or {@link #ALL}
 * @param nz nodes along z, or {@link #ALL}
 */
record BundleShape(int nx, int ny, int nz) {
  /** Stands for all nodes along an axis. */
  static final int ALL = Integer.MAX_VALUE;

  /** Whole rows of the lattice: best for a duct on the machines tried. */
  static final BundleShape LONG_ROWS = new BundleShape(ALL, 10, 10);

  /** What a shape must look like. */
  static final String GRAMMAR = "N or NX,NY,NZ, each a number of nodes or all";

  private static final String ALL_WORD = "all";
  private static final int AXES = 3;

  /**
   * Reads a shape.
   *
   * @throws IllegalArgumentException if it is none
   */
  static BundleShape parse(String text) {
    String[] edges = text.split(",", -1);
    if (edges.length == 1) {
      return new BundleShape(edge(text), edge(text), edge(text));
    }
    if (edges.length == AXES) {
      return new BundleShape(edge(edges[0]), edge(edges[1]), edge(edges[2]));
    }
    throw new IllegalArgumentException("bundle must be " + GRAMMAR + ": bundle=" + text);
  }

  private static int edge(String text) {
    if (text.equals(ALL_WORD)) {
      return ALL;
    }
    int edge = Integer.parseInt(text);
    if (edge < 1) {
      throw new IllegalArgumentException("bundle must be at least 1 node: nodes=" + edge);
    }
    return edge;
  }

  /** Reads an option. */
  static final class Converter implements ITypeConverter<BundleShape> {
    @Override
    public BundleShape convert(String text) {
      try {
        return parse(text);
      } catch (IllegalArgumentException e) {
        throw new GrammarException(GRAMMAR);
      }
    }
  }

  /**
   * The size that it has in a cube of nodes.
   *
   * @throws IllegalArgumentException if that has too many nodes
   */
  BundleSize in(int side) {
    return new BundleSize(within(nx, side), within(ny, side), within(nz, side));
  }

  private static int within(int edge, int side) {
    return Math.max(1, Math.min(edge, side)); // a side below 1 is for the duct to refuse
  }

  /** As it is written. */
  @Override
  public String toString() {
    return nx == ny && ny == nz ? word(nx) : word(nx) + "," + word(ny) + "," + word(nz);
  }

  private static String word(int edge) {
    return edge == ALL ? ALL_WORD : Integer.toString(edge);
  }
}
