package org.hdispatch.sph;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import org.hdispatch.cell.CellChanges;
import org.hdispatch.cell.CellMap;

/**
 * The state of a scheme on its way to a stream and back: a number that tells schemes of other boxes
 * apart, then cell by cell its particles in their order, with what the last step has found out
 * about them, and those that have left it.
 */
final class SavedState {
  // The texts of errors stand here and not in the scheme, which runs in steps.

  private final long print; // tells other boxes, cells, kernels, phases and numbers apart
  private final CellMap<ParticleCell> cells;
  private final long particles;
  private final boolean walled;

  SavedState(
      ParticleGrid grid, SphSchemeBuilder settings, int particles, CellMap<ParticleCell> cells) {
    ParticleBox box = settings.box;
    SmoothingKernel kernel = settings.kernel;
    long sum = mix(mix(mix(box.dimensions(), bits(box.lx())), bits(box.ly())), bits(box.lz()));
    int ends = box.x().ordinal() + 2 * box.y().ordinal() + 4 * box.z().ordinal();
    sum = mix(mix(sum, ends), grid.cells().nx());
    sum = mix(mix(sum, grid.cells().ny()), grid.cells().nz());
    sum = mix(mix(sum, bits(kernel.smoothingLength())), bits(kernel.supportRadius()));
    sum = mix(sum, kernel.toString().hashCode());
    print = mix(mix(mix(sum, settings.phases.size()), bits(settings.timeStep)), particles);
    this.cells = cells;
    this.particles = particles;
    walled = settings.walls != null;
  }

  void write(int buffer, boolean fresh, double fastest, DataOutput out) throws IOException {
    out.writeLong(print);
    out.writeBoolean(fresh);
    out.writeDouble(fastest);
    out.writeInt(cells.size());
    for (int index = 0; index < cells.size(); index++) {
      out.writeLong(cells.keyAt(index));
    }
    for (int index = 0; index < cells.size(); index++) {
      ParticleCell cell = cells.cellAt(index);
      out.writeInt(cell.count);
      out.writeInt(cell.fluids);
      out.writeInt(cell.leaving);
      out.writeDouble(cell.leastCompression);
      out.writeDouble(cell.mostCompression);
      for (int n = 0; n < cell.count; n++) {
        write(cell.buffers[buffer], n, out);
        out.writeDouble(fresh ? 0 : cell.volume[n]);
        out.writeDouble(fresh ? 0 : cell.pressure[n]);
        out.writeDouble(n < Math.min(cell.fluids, cell.virial.length) ? cell.virial[n] : 0);
      }
      for (int n = 0; n < cell.leaving; n++) {
        out.writeInt(cell.leavers[n]);
        out.writeByte(cell.ways[n]);
      }
    }
  }

  private static void write(ParticleArrays from, int n, DataOutput out) throws IOException {
    out.writeInt(from.id[n]);
    out.writeByte(from.phase[n]);
    out.writeDouble(from.x[n]);
    out.writeDouble(from.y[n]);
    out.writeDouble(from.z[n]);
    out.writeDouble(from.vx[n]);
    out.writeDouble(from.vy[n]);
    out.writeDouble(from.vz[n]);
    out.writeDouble(from.ux[n]);
    out.writeDouble(from.uy[n]);
    out.writeDouble(from.uz[n]);
  }

  /** Refuses what is not the state of such a scheme. */
  void check(DataInput in) throws IOException {
    long saved = in.readLong();
    if (saved != print) {
      throw new IllegalArgumentException(
          "state must be of the same box, cells, kernel, time step and number of phases and"
              + " particles: saved="
              + Long.toHexString(saved)
              + ", here="
              + Long.toHexString(print));
    }
  }

  /** Reads the cells. */
  void read(int buffer, DataInput in) throws IOException {
    CellChanges changes = new CellChanges();
    for (int index = 0; index < cells.size(); index++) {
      changes.remove(cells.keyAt(index));
    }
    int count = in.readInt();
    for (int n = 0; n < count; n++) {
      changes.add(in.readLong());
    }
    cells.apply(changes);
    long left = particles;
    for (int index = 0; index < cells.size(); index++) {
      left -= read(cells.cellAt(index), buffer, left, in);
    }
    if (left != 0) {
      throw new IllegalArgumentException(
          "state must hold all particles: particles=" + particles + ", missing=" + left);
    }
  }

  private int read(ParticleCell cell, int buffer, long most, DataInput in) throws IOException {
    int count = in.readInt();
    int fluids = in.readInt();
    int leaving = in.readInt();
    if (fluids < 0 || fluids > count || count > most || leaving < 0 || leaving > fluids) {
      throw new IllegalArgumentException(
          "state must have as many particles in a cell as there are: particles="
              + count
              + ", fluids="
              + fluids
              + ", leaving="
              + leaving);
    }
    cell.leastCompression = in.readDouble();
    cell.mostCompression = in.readDouble();
    cell.count = count;
    cell.fluids = fluids;
    cell.makeRoom(count, walled);
    cell.makeVirialRoom();
    cell.buffers[buffer].makeRoom(count);
    for (int n = 0; n < count; n++) {
      read(cell.buffers[buffer], n, in);
      cell.volume[n] = in.readDouble();
      cell.pressure[n] = in.readDouble();
      double virial = in.readDouble();
      if (n < fluids) {
        cell.virial[n] = virial;
      }
    }
    cell.leaving = 0;
    for (int n = 0; n < leaving; n++) {
      int leaver = in.readInt();
      cell.addLeaver(leaver, in.readByte());
    }
    return count;
  }

  private static void read(ParticleArrays to, int n, DataInput in) throws IOException {
    to.id[n] = in.readInt();
    to.phase[n] = in.readByte();
    to.x[n] = in.readDouble();
    to.y[n] = in.readDouble();
    to.z[n] = in.readDouble();
    to.vx[n] = in.readDouble();
    to.vy[n] = in.readDouble();
    to.vz[n] = in.readDouble();
    to.ux[n] = in.readDouble();
    to.uy[n] = in.readDouble();
    to.uz[n] = in.readDouble();
  }

  private static long bits(double value) {
    return Double.doubleToLongBits(value);
  }

  private static long mix(long sum, long number) {
    return (sum ^ number) * 0x9E3779B97F4A7C15L; // 2^64 over the golden ratio
  }
}
