#!/usr/bin/env bash
# Builds dispatch.c into jmh/target/peers and runs it with the arguments given; CC chooses the compiler.
set -euo pipefail

here=$(dirname "$0")
target=$here/../../target/peers
flags="-std=c11 -O3 -march=native -fopenmp"
compiler=${CC:-gcc}

mkdir -p "$target"
# $compiler and $flags unquoted: several words each
probe='#include <omp.h>
#include <sys/prctl.h>
int main(void) { return omp_get_max_threads() < 1; }'
if ! $compiler $flags -x c - -o "$target/probe" <<< "$probe" 2> /dev/null; then
  echo "skipped: no compiler with OpenMP on Linux: CC=$compiler"
  exit 0
fi
rm "$target/probe"

$compiler $flags -Wall -Wextra -Wpedantic -DFLAGS="\"$flags\"" \
  "$here/dispatch.c" -o "$target/openmp-dispatch"
exec "$target/openmp-dispatch" "$@"
