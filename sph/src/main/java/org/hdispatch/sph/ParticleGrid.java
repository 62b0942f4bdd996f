package org.hdispatch.sph;

import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;

/** Cuts a box into cells that are no shorter than a reach, along x, y and z. */
final class ParticleGrid {
  private static final int MOST = 1 << 20; // cells along an axis

  private final ParticleBox box;
  private final CellGrid cells;
  private final double ex;
  private final double ey;
  private final double ez;

  /**
   * A grid of cells as near to an edge as fits the box.
   *
   * @param edge wanted, at least the reach
   */
  ParticleGrid(ParticleBox box, double edge) {
    this.box = box;
    int nx = number(box.lx(), edge);
    int ny = number(box.ly(), edge);
    int nz = box.dimensions() == 2 ? 1 : number(box.lz(), edge);
    cells = new CellGrid(nx, ny, nz, box.x(), box.y(), box.z());
    ex = box.lx() / nx;
    ey = box.ly() / ny;
    ez = box.dimensions() == 2 ? Double.POSITIVE_INFINITY : box.lz() / nz;
  }

  private static int number(double length, double edge) {
    if (length / edge > MOST) {
      throw new IllegalArgumentException(
          "cells along an axis must number at most "
              + MOST
              + ": length="
              + length
              + ", edge="
              + edge);
    }
    return Math.max(1, (int) Math.floor(length / edge * (1 + 1e-12)));
  }

  CellGrid cells() {
    return cells;
  }

  ParticleBox box() {
    return box;
  }

  /** Shortest edge of a cell. */
  double leastEdge() {
    return Math.min(ex, Math.min(ey, ez));
  }

  /** Key of the cell at a place in the box. */
  long keyAt(double x, double y, double z) {
    int i = Math.min((int) (x / ex), cells.nx() - 1);
    int j = Math.min((int) (y / ey), cells.ny() - 1);
    int k = Math.min((int) (z / ez), cells.nz() - 1);
    return CellKey.of(i, j, k);
  }

  double edge(int axis) {
    return axis == 0 ? ex : axis == 1 ? ey : ez;
  }

  /** Where a cell begins along an axis; the next one begins where it ends. */
  double low(long key, int axis) {
    return axis == 0
        ? CellKey.i(key) * ex
        : axis == 1
            ? CellKey.j(key) * ey
            : box.dimensions() == 2 ? Double.NEGATIVE_INFINITY : CellKey.k(key) * ez;
  }

  /** Where a cell ends along an axis. */
  double high(long key, int axis) {
    return axis == 0
        ? (CellKey.i(key) + 1) * ex
        : axis == 1
            ? (CellKey.j(key) + 1) * ey
            : box.dimensions() == 2 ? Double.POSITIVE_INFINITY : (CellKey.k(key) + 1) * ez;
  }

  /** What is added to a place in the cell of a slot to see it from the cell in its middle. */
  double shift(long key, int slot, int axis) {
    int number = axis == 0 ? CellKey.i(key) : axis == 1 ? CellKey.j(key) : CellKey.k(key);
    int there = number + ParticleCell.offset(slot, axis);
    int all = axis == 0 ? cells.nx() : axis == 1 ? cells.ny() : cells.nz();
    double length = axis == 0 ? box.lx() : axis == 1 ? box.ly() : box.lz();
    return there < 0 ? -length : there >= all ? length : 0;
  }
}
