// Memory bandwidth beside a lattice Boltzmann kernel: two arrays swept by all threads, in place as
// AA and esotwist do, and from one to the other as pull does.
#define _GNU_SOURCE
#include <omp.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>

static double *from;
static double *to;
static int64_t length;

// Returns 0 unless there is no memory for 2 arrays of so many bytes.
int probe_open(int64_t bytes, int threads) {
  omp_set_num_threads(threads);
  length = bytes / (int64_t)sizeof(double);
  const size_t huge = (size_t)1 << 21;
  const size_t size = ((size_t)bytes + huge - 1) / huge * huge;
  from = aligned_alloc(huge, size);
  to = aligned_alloc(huge, size);
  if (!from || !to) return 1;
  madvise(from, size, MADV_HUGEPAGE);  // as numpy does with the populations
  madvise(to, size, MADV_HUGEPAGE);
#pragma omp parallel for schedule(static)
  for (int64_t i = 0; i < length; i++) {
    from[i] = 1 + (double)(i & 1023);
    to[i] = 0.5;
  }
  return 0;
}

// Seconds of a sweep in place: 16 bytes an element.
double probe_in_place(double factor) {
  const double start = omp_get_wtime();
#pragma omp parallel for schedule(static)
  for (int64_t i = 0; i < length; i++) from[i] *= factor;
  return omp_get_wtime() - start;
}

// Seconds of a copy with plain stores: 24 bytes an element, since a line is read before it is
// written. The factor keeps compilers from calling memcpy, whose stores may pass the caches by.
double probe_copy(double factor) {
  const double start = omp_get_wtime();
#pragma omp parallel for schedule(static)
  for (int64_t i = 0; i < length; i++) to[i] = factor * from[i];
  return omp_get_wtime() - start;
}
