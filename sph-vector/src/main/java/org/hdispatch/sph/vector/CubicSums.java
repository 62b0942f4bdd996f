package org.hdispatch.sph.vector;

import static org.hdispatch.sph.Neighbourhood.DEPTH;
import static org.hdispatch.sph.Neighbourhood.LANES;
import static org.hdispatch.sph.Neighbourhood.PRESSURE;
import static org.hdispatch.sph.Neighbourhood.UX;
import static org.hdispatch.sph.Neighbourhood.UY;
import static org.hdispatch.sph.Neighbourhood.UZ;
import static org.hdispatch.sph.Neighbourhood.VISCOSITY;
import static org.hdispatch.sph.Neighbourhood.VOLUME;
import static org.hdispatch.sph.Neighbourhood.Y;
import static org.hdispatch.sph.Neighbourhood.Z;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorOperators;
import org.hdispatch.sph.PairModel;

/** Sums with the cubic spline. Written by SumsSource: do not edit. */
final class CubicSums extends VectorSums {
  private final double inverseLength;

  CubicSums(PairModel model) {
    super(model);
    inverseLength = model.kernel().inverseLength();
  }

  @Override
  double density(double[] v, int stride, int own, char[] quads, int from, int to) {
    int ys = Y * stride;
    int zs = Z * stride;
    DoubleVector x = DoubleVector.broadcast(QUAD, v[own]);
    DoubleVector y = DoubleVector.broadcast(QUAD, v[ys + own]);
    DoubleVector z = DoubleVector.broadcast(QUAD, v[zs + own]);
    DoubleVector scale = DoubleVector.broadcast(QUAD, inverseLength);
    DoubleVector least = DoubleVector.broadcast(QUAD, LEAST_SQUARE);
    DoubleVector sum = DoubleVector.broadcast(QUAD, 0);
    DoubleVector q = DoubleVector.broadcast(QUAD, FAR);
    for (int entry = from; entry < to; entry++) {
      int n = quads[entry] * LANES;
      DoubleVector a = DoubleVector.broadcast(QUAD, 2).sub(q);
      DoubleVector b = DoubleVector.broadcast(QUAD, 1).sub(q);
      a = a.add(a.abs());
      b = b.add(b.abs());
      DoubleVector shape = b.mul(b).mul(b).fma(DoubleVector.broadcast(QUAD, -4), a.mul(a).mul(a));
      DoubleVector dx = DoubleVector.fromArray(QUAD, v, n).sub(x);
      DoubleVector dy = DoubleVector.fromArray(QUAD, v, ys + n).sub(y);
      DoubleVector dz = DoubleVector.fromArray(QUAD, v, zs + n).sub(z);
      q = dz.fma(dz, dy.fma(dy, dx.fma(dx, least))).sqrt().mul(scale);
      sum = sum.add(shape);
    }
    DoubleVector a = DoubleVector.broadcast(QUAD, 2).sub(q);
    DoubleVector b = DoubleVector.broadcast(QUAD, 1).sub(q);
    a = a.add(a.abs());
    b = b.add(b.abs());
    DoubleVector shape = b.mul(b).mul(b).fma(DoubleVector.broadcast(QUAD, -4), a.mul(a).mul(a));
    sum = sum.add(shape);
    return (sum.lane(0) + sum.lane(1)) + (sum.lane(2) + sum.lane(3));
  }

  @Override
  void uniform(
      double[] v, int stride, int own, char[] quads, int from, int to, double twiceViscosity) {
    int ys = Y * stride;
    int zs = Z * stride;
    int uxs = UX * stride;
    int uys = UY * stride;
    int uzs = UZ * stride;
    int volumes = VOLUME * stride;
    int pressures = PRESSURE * stride;
    DoubleVector x = DoubleVector.broadcast(QUAD, v[own]);
    DoubleVector y = DoubleVector.broadcast(QUAD, v[ys + own]);
    DoubleVector z = DoubleVector.broadcast(QUAD, v[zs + own]);
    DoubleVector ux = DoubleVector.broadcast(QUAD, v[uxs + own]);
    DoubleVector uy = DoubleVector.broadcast(QUAD, v[uys + own]);
    DoubleVector uz = DoubleVector.broadcast(QUAD, v[uzs + own]);
    DoubleVector pressure = DoubleVector.broadcast(QUAD, v[pressures + own]);
    DoubleVector volume = DoubleVector.broadcast(QUAD, twiceViscosity * v[volumes + own]);
    DoubleVector scale = DoubleVector.broadcast(QUAD, inverseLength);
    DoubleVector least = DoubleVector.broadcast(QUAD, LEAST_SQUARE);
    DoubleVector sumX = DoubleVector.broadcast(QUAD, 0);
    DoubleVector sumY = DoubleVector.broadcast(QUAD, 0);
    DoubleVector sumZ = DoubleVector.broadcast(QUAD, 0);
    DoubleVector dx = DoubleVector.broadcast(QUAD, 0);
    DoubleVector dy = DoubleVector.broadcast(QUAD, 0);
    DoubleVector dz = DoubleVector.broadcast(QUAD, 0);
    DoubleVector q = DoubleVector.broadcast(QUAD, FAR);
    int last = own / LANES * LANES; // of the quad whose dx, dy, dz and q are known
    for (int entry = from; entry < to; entry++) {
      int n = quads[entry] * LANES;
      DoubleVector a = DoubleVector.broadcast(QUAD, 2).sub(q);
      DoubleVector b = DoubleVector.broadcast(QUAD, 1).sub(q);
      a = a.add(a.abs());
      b = b.add(b.abs());
      DoubleVector slope = b.mul(b).fma(DoubleVector.broadcast(QUAD, -4), a.mul(a)).div(q);
      DoubleVector volumeJ = DoubleVector.fromArray(QUAD, v, volumes + last);
      DoubleVector drag = volume.mul(volumeJ).mul(slope);
      DoubleVector pressureJ = DoubleVector.fromArray(QUAD, v, pressures + last);
      DoubleVector p = pressure.add(pressureJ).mul(slope);
      sumX = ux.sub(DoubleVector.fromArray(QUAD, v, uxs + last)).fma(drag, dx.fma(p, sumX));
      sumY = uy.sub(DoubleVector.fromArray(QUAD, v, uys + last)).fma(drag, dy.fma(p, sumY));
      sumZ = uz.sub(DoubleVector.fromArray(QUAD, v, uzs + last)).fma(drag, dz.fma(p, sumZ));
      dx = DoubleVector.fromArray(QUAD, v, n).sub(x);
      dy = DoubleVector.fromArray(QUAD, v, ys + n).sub(y);
      dz = DoubleVector.fromArray(QUAD, v, zs + n).sub(z);
      q = dz.fma(dz, dy.fma(dy, dx.fma(dx, least))).sqrt().mul(scale);
      last = n;
    }
    DoubleVector a = DoubleVector.broadcast(QUAD, 2).sub(q);
    DoubleVector b = DoubleVector.broadcast(QUAD, 1).sub(q);
    a = a.add(a.abs());
    b = b.add(b.abs());
    DoubleVector slope = b.mul(b).fma(DoubleVector.broadcast(QUAD, -4), a.mul(a)).div(q);
    DoubleVector volumeJ = DoubleVector.fromArray(QUAD, v, volumes + last);
    DoubleVector drag = volume.mul(volumeJ).mul(slope);
    DoubleVector pressureJ = DoubleVector.fromArray(QUAD, v, pressures + last);
    DoubleVector p = pressure.add(pressureJ).mul(slope);
    sumX = ux.sub(DoubleVector.fromArray(QUAD, v, uxs + last)).fma(drag, dx.fma(p, sumX));
    sumY = uy.sub(DoubleVector.fromArray(QUAD, v, uys + last)).fma(drag, dy.fma(p, sumY));
    sumZ = uz.sub(DoubleVector.fromArray(QUAD, v, uzs + last)).fma(drag, dz.fma(p, sumZ));
    sums[0] = (sumX.lane(0) + sumX.lane(1)) + (sumX.lane(2) + sumX.lane(3));
    sums[1] = (sumY.lane(0) + sumY.lane(1)) + (sumY.lane(2) + sumY.lane(3));
    sums[2] = (sumZ.lane(0) + sumZ.lane(1)) + (sumZ.lane(2) + sumZ.lane(3));
  }

  @Override
  void arithmetic(
      double[] v,
      int stride,
      int own,
      char[] quads,
      int from,
      int to,
      double nearness,
      double wallFactor) {
    int ys = Y * stride;
    int zs = Z * stride;
    int uxs = UX * stride;
    int uys = UY * stride;
    int uzs = UZ * stride;
    int volumes = VOLUME * stride;
    int pressures = PRESSURE * stride;
    int viscosities = VISCOSITY * stride;
    int depths = DEPTH * stride;
    DoubleVector x = DoubleVector.broadcast(QUAD, v[own]);
    DoubleVector y = DoubleVector.broadcast(QUAD, v[ys + own]);
    DoubleVector z = DoubleVector.broadcast(QUAD, v[zs + own]);
    DoubleVector ux = DoubleVector.broadcast(QUAD, v[uxs + own]);
    DoubleVector uy = DoubleVector.broadcast(QUAD, v[uys + own]);
    DoubleVector uz = DoubleVector.broadcast(QUAD, v[uzs + own]);
    DoubleVector pressure = DoubleVector.broadcast(QUAD, v[pressures + own]);
    DoubleVector volume = DoubleVector.broadcast(QUAD, v[volumes + own]);
    DoubleVector viscosity = DoubleVector.broadcast(QUAD, v[viscosities + own]);
    DoubleVector near = DoubleVector.broadcast(QUAD, nearness);
    DoubleVector most = DoubleVector.broadcast(QUAD, wallFactor);
    DoubleVector zero = DoubleVector.broadcast(QUAD, 0);
    DoubleVector scale = DoubleVector.broadcast(QUAD, inverseLength);
    DoubleVector least = DoubleVector.broadcast(QUAD, LEAST_SQUARE);
    DoubleVector sumX = DoubleVector.broadcast(QUAD, 0);
    DoubleVector sumY = DoubleVector.broadcast(QUAD, 0);
    DoubleVector sumZ = DoubleVector.broadcast(QUAD, 0);
    DoubleVector dragX = DoubleVector.broadcast(QUAD, 0);
    DoubleVector dragY = DoubleVector.broadcast(QUAD, 0);
    DoubleVector dragZ = DoubleVector.broadcast(QUAD, 0);
    DoubleVector bend = DoubleVector.broadcast(QUAD, 0);
    DoubleVector dx = DoubleVector.broadcast(QUAD, 0);
    DoubleVector dy = DoubleVector.broadcast(QUAD, 0);
    DoubleVector dz = DoubleVector.broadcast(QUAD, 0);
    DoubleVector q = DoubleVector.broadcast(QUAD, FAR);
    int last = own / LANES * LANES; // of the quad whose dx, dy, dz and q are known
    for (int entry = from; entry < to; entry++) {
      int n = quads[entry] * LANES;
      DoubleVector a = DoubleVector.broadcast(QUAD, 2).sub(q);
      DoubleVector b = DoubleVector.broadcast(QUAD, 1).sub(q);
      a = a.add(a.abs());
      b = b.add(b.abs());
      DoubleVector slope = b.mul(b).fma(DoubleVector.broadcast(QUAD, -4), a.mul(a)).div(q);
      DoubleVector volumeJ = DoubleVector.fromArray(QUAD, v, volumes + last);
      DoubleVector depth = DoubleVector.fromArray(QUAD, v, depths + last);
      DoubleVector free = depth.fma(near, DoubleVector.broadcast(QUAD, 1));
      DoubleVector wall = free.blend(most, free.compare(VectorOperators.GT, most));
      DoubleVector other = DoubleVector.fromArray(QUAD, v, viscosities + last);
      DoubleVector touched = other.blend(viscosity, other.compare(VectorOperators.EQ, zero));
      DoubleVector mu = touched.add(viscosity);
      DoubleVector bare = volume.mul(volumeJ).mul(slope);
      DoubleVector pair = bare.mul(mu);
      DoubleVector drag = pair.mul(wall);
      bend = bend.add(pair.mul(free).mul(free.sub(DoubleVector.broadcast(QUAD, 1))));
      DoubleVector pressureJ = DoubleVector.fromArray(QUAD, v, pressures + last);
      DoubleVector p = pressure.add(pressureJ).mul(slope);
      sumX = dx.fma(p, sumX);
      sumY = dy.fma(p, sumY);
      sumZ = dz.fma(p, sumZ);
      dragX = ux.sub(DoubleVector.fromArray(QUAD, v, uxs + last)).fma(drag, dragX);
      dragY = uy.sub(DoubleVector.fromArray(QUAD, v, uys + last)).fma(drag, dragY);
      dragZ = uz.sub(DoubleVector.fromArray(QUAD, v, uzs + last)).fma(drag, dragZ);
      dx = DoubleVector.fromArray(QUAD, v, n).sub(x);
      dy = DoubleVector.fromArray(QUAD, v, ys + n).sub(y);
      dz = DoubleVector.fromArray(QUAD, v, zs + n).sub(z);
      q = dz.fma(dz, dy.fma(dy, dx.fma(dx, least))).sqrt().mul(scale);
      last = n;
    }
    DoubleVector a = DoubleVector.broadcast(QUAD, 2).sub(q);
    DoubleVector b = DoubleVector.broadcast(QUAD, 1).sub(q);
    a = a.add(a.abs());
    b = b.add(b.abs());
    DoubleVector slope = b.mul(b).fma(DoubleVector.broadcast(QUAD, -4), a.mul(a)).div(q);
    DoubleVector volumeJ = DoubleVector.fromArray(QUAD, v, volumes + last);
    DoubleVector depth = DoubleVector.fromArray(QUAD, v, depths + last);
    DoubleVector free = depth.fma(near, DoubleVector.broadcast(QUAD, 1));
    DoubleVector wall = free.blend(most, free.compare(VectorOperators.GT, most));
    DoubleVector other = DoubleVector.fromArray(QUAD, v, viscosities + last);
    DoubleVector touched = other.blend(viscosity, other.compare(VectorOperators.EQ, zero));
    DoubleVector mu = touched.add(viscosity);
    DoubleVector bare = volume.mul(volumeJ).mul(slope);
    DoubleVector pair = bare.mul(mu);
    DoubleVector drag = pair.mul(wall);
    bend = bend.add(pair.mul(free).mul(free.sub(DoubleVector.broadcast(QUAD, 1))));
    DoubleVector pressureJ = DoubleVector.fromArray(QUAD, v, pressures + last);
    DoubleVector p = pressure.add(pressureJ).mul(slope);
    sumX = dx.fma(p, sumX);
    sumY = dy.fma(p, sumY);
    sumZ = dz.fma(p, sumZ);
    dragX = ux.sub(DoubleVector.fromArray(QUAD, v, uxs + last)).fma(drag, dragX);
    dragY = uy.sub(DoubleVector.fromArray(QUAD, v, uys + last)).fma(drag, dragY);
    dragZ = uz.sub(DoubleVector.fromArray(QUAD, v, uzs + last)).fma(drag, dragZ);
    sums[0] = (sumX.lane(0) + sumX.lane(1)) + (sumX.lane(2) + sumX.lane(3));
    sums[1] = (sumY.lane(0) + sumY.lane(1)) + (sumY.lane(2) + sumY.lane(3));
    sums[2] = (sumZ.lane(0) + sumZ.lane(1)) + (sumZ.lane(2) + sumZ.lane(3));
    sums[3] = (dragX.lane(0) + dragX.lane(1)) + (dragX.lane(2) + dragX.lane(3));
    sums[4] = (dragY.lane(0) + dragY.lane(1)) + (dragY.lane(2) + dragY.lane(3));
    sums[5] = (dragZ.lane(0) + dragZ.lane(1)) + (dragZ.lane(2) + dragZ.lane(3));
    sums[6] = (bend.lane(0) + bend.lane(1)) + (bend.lane(2) + bend.lane(3));
  }

  @Override
  void harmonic(
      double[] v,
      int stride,
      int own,
      char[] quads,
      int from,
      int to,
      double nearness,
      double wallFactor) {
    int ys = Y * stride;
    int zs = Z * stride;
    int uxs = UX * stride;
    int uys = UY * stride;
    int uzs = UZ * stride;
    int volumes = VOLUME * stride;
    int pressures = PRESSURE * stride;
    int viscosities = VISCOSITY * stride;
    int depths = DEPTH * stride;
    DoubleVector x = DoubleVector.broadcast(QUAD, v[own]);
    DoubleVector y = DoubleVector.broadcast(QUAD, v[ys + own]);
    DoubleVector z = DoubleVector.broadcast(QUAD, v[zs + own]);
    DoubleVector ux = DoubleVector.broadcast(QUAD, v[uxs + own]);
    DoubleVector uy = DoubleVector.broadcast(QUAD, v[uys + own]);
    DoubleVector uz = DoubleVector.broadcast(QUAD, v[uzs + own]);
    DoubleVector pressure = DoubleVector.broadcast(QUAD, v[pressures + own]);
    DoubleVector volume = DoubleVector.broadcast(QUAD, v[volumes + own]);
    DoubleVector viscosity = DoubleVector.broadcast(QUAD, v[viscosities + own]);
    DoubleVector near = DoubleVector.broadcast(QUAD, nearness);
    DoubleVector most = DoubleVector.broadcast(QUAD, wallFactor);
    DoubleVector zero = DoubleVector.broadcast(QUAD, 0);
    DoubleVector scale = DoubleVector.broadcast(QUAD, inverseLength);
    DoubleVector least = DoubleVector.broadcast(QUAD, LEAST_SQUARE);
    DoubleVector sumX = DoubleVector.broadcast(QUAD, 0);
    DoubleVector sumY = DoubleVector.broadcast(QUAD, 0);
    DoubleVector sumZ = DoubleVector.broadcast(QUAD, 0);
    DoubleVector dragX = DoubleVector.broadcast(QUAD, 0);
    DoubleVector dragY = DoubleVector.broadcast(QUAD, 0);
    DoubleVector dragZ = DoubleVector.broadcast(QUAD, 0);
    DoubleVector bend = DoubleVector.broadcast(QUAD, 0);
    DoubleVector dx = DoubleVector.broadcast(QUAD, 0);
    DoubleVector dy = DoubleVector.broadcast(QUAD, 0);
    DoubleVector dz = DoubleVector.broadcast(QUAD, 0);
    DoubleVector q = DoubleVector.broadcast(QUAD, FAR);
    int last = own / LANES * LANES; // of the quad whose dx, dy, dz and q are known
    for (int entry = from; entry < to; entry++) {
      int n = quads[entry] * LANES;
      DoubleVector a = DoubleVector.broadcast(QUAD, 2).sub(q);
      DoubleVector b = DoubleVector.broadcast(QUAD, 1).sub(q);
      a = a.add(a.abs());
      b = b.add(b.abs());
      DoubleVector slope = b.mul(b).fma(DoubleVector.broadcast(QUAD, -4), a.mul(a)).div(q);
      DoubleVector volumeJ = DoubleVector.fromArray(QUAD, v, volumes + last);
      DoubleVector depth = DoubleVector.fromArray(QUAD, v, depths + last);
      DoubleVector free = depth.fma(near, DoubleVector.broadcast(QUAD, 1));
      DoubleVector wall = free.blend(most, free.compare(VectorOperators.GT, most));
      DoubleVector other = DoubleVector.fromArray(QUAD, v, viscosities + last);
      DoubleVector touched = other.blend(viscosity, other.compare(VectorOperators.EQ, zero));
      DoubleVector mu = touched.add(viscosity);
      DoubleVector bare = volume.mul(volumeJ).mul(slope);
      DoubleVector pair = bare.mul(DoubleVector.broadcast(QUAD, 4).div(mu));
      DoubleVector drag = pair.mul(wall);
      bend = bend.add(pair.mul(free).mul(free.sub(DoubleVector.broadcast(QUAD, 1))));
      DoubleVector pressureJ = DoubleVector.fromArray(QUAD, v, pressures + last);
      DoubleVector p = pressure.add(pressureJ).mul(slope);
      sumX = dx.fma(p, sumX);
      sumY = dy.fma(p, sumY);
      sumZ = dz.fma(p, sumZ);
      dragX = ux.sub(DoubleVector.fromArray(QUAD, v, uxs + last)).fma(drag, dragX);
      dragY = uy.sub(DoubleVector.fromArray(QUAD, v, uys + last)).fma(drag, dragY);
      dragZ = uz.sub(DoubleVector.fromArray(QUAD, v, uzs + last)).fma(drag, dragZ);
      dx = DoubleVector.fromArray(QUAD, v, n).sub(x);
      dy = DoubleVector.fromArray(QUAD, v, ys + n).sub(y);
      dz = DoubleVector.fromArray(QUAD, v, zs + n).sub(z);
      q = dz.fma(dz, dy.fma(dy, dx.fma(dx, least))).sqrt().mul(scale);
      last = n;
    }
    DoubleVector a = DoubleVector.broadcast(QUAD, 2).sub(q);
    DoubleVector b = DoubleVector.broadcast(QUAD, 1).sub(q);
    a = a.add(a.abs());
    b = b.add(b.abs());
    DoubleVector slope = b.mul(b).fma(DoubleVector.broadcast(QUAD, -4), a.mul(a)).div(q);
    DoubleVector volumeJ = DoubleVector.fromArray(QUAD, v, volumes + last);
    DoubleVector depth = DoubleVector.fromArray(QUAD, v, depths + last);
    DoubleVector free = depth.fma(near, DoubleVector.broadcast(QUAD, 1));
    DoubleVector wall = free.blend(most, free.compare(VectorOperators.GT, most));
    DoubleVector other = DoubleVector.fromArray(QUAD, v, viscosities + last);
    DoubleVector touched = other.blend(viscosity, other.compare(VectorOperators.EQ, zero));
    DoubleVector mu = touched.add(viscosity);
    DoubleVector bare = volume.mul(volumeJ).mul(slope);
    DoubleVector pair = bare.mul(DoubleVector.broadcast(QUAD, 4).div(mu));
    DoubleVector drag = pair.mul(wall);
    bend = bend.add(pair.mul(free).mul(free.sub(DoubleVector.broadcast(QUAD, 1))));
    DoubleVector pressureJ = DoubleVector.fromArray(QUAD, v, pressures + last);
    DoubleVector p = pressure.add(pressureJ).mul(slope);
    sumX = dx.fma(p, sumX);
    sumY = dy.fma(p, sumY);
    sumZ = dz.fma(p, sumZ);
    dragX = ux.sub(DoubleVector.fromArray(QUAD, v, uxs + last)).fma(drag, dragX);
    dragY = uy.sub(DoubleVector.fromArray(QUAD, v, uys + last)).fma(drag, dragY);
    dragZ = uz.sub(DoubleVector.fromArray(QUAD, v, uzs + last)).fma(drag, dragZ);
    sums[0] = (sumX.lane(0) + sumX.lane(1)) + (sumX.lane(2) + sumX.lane(3));
    sums[1] = (sumY.lane(0) + sumY.lane(1)) + (sumY.lane(2) + sumY.lane(3));
    sums[2] = (sumZ.lane(0) + sumZ.lane(1)) + (sumZ.lane(2) + sumZ.lane(3));
    sums[3] = (dragX.lane(0) + dragX.lane(1)) + (dragX.lane(2) + dragX.lane(3));
    sums[4] = (dragY.lane(0) + dragY.lane(1)) + (dragY.lane(2) + dragY.lane(3));
    sums[5] = (dragZ.lane(0) + dragZ.lane(1)) + (dragZ.lane(2) + dragZ.lane(3));
    sums[6] = (bend.lane(0) + bend.lane(1)) + (bend.lane(2) + bend.lane(3));
  }
}
