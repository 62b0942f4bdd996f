#!/usr/bin/env bash
# lbmpy's kernels and our duct by turns, in one go, with the memory's bandwidth probed between:
#
#   jmh/peers/lbmpy/run.sh --output FILE.json          # 200^3, D3Q15, double: in place and pull
#   jmh/peers/lbmpy/run.sh --size 192 200 204 --lattice D3Q19
#   jmh/peers/lbmpy/run.sh --alone --form D3Q15/double/in-place --form D3Q15/single/in-place
#   jmh/peers/lbmpy/run.sh --ours 'in place' './hdispatch duct --size {size} --threads {threads}
#       --streaming in-place --steps {steps} --json' --ours ...   # all of --help
#
# On first use it installs lbmpy (requirements.txt) into SCRATCH, by default a folder hdispatch-lbmpy
# among the temporary files; the kernels it compiles stay there too. Needs Linux on x86-64 with AVX2,
# Python 3.10 or newer with venv, g++ and gcc (or CC) with OpenMP; else it says so and skips.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
scratch=${SCRATCH:-${TMPDIR:-/tmp}/hdispatch-lbmpy}
flags="-std=gnu11 -O3 -march=native -fopenmp"
compiler=${CC:-gcc}

skip() {
  echo "skipped: $1"
  exit 0
}
python3 -c 'import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 10))' 2> /dev/null ||
  skip "no Python 3.10 or newer with venv"
g++ --version > /dev/null 2>&1 || skip "no g++"
grep -qw avx2 /proc/cpuinfo 2> /dev/null || skip "no processor with AVX2 on Linux"

mkdir -p "$scratch"
# $compiler and $flags unquoted: several words each
$compiler $flags -Wall -Wextra -Wpedantic -shared -fPIC "$here/probe.c" -o "$scratch/probe.so" ||
  skip "no compiler with OpenMP on Linux: CC=$compiler"

if ! cmp -s "$here/requirements.txt" "$scratch/installed"; then
  echo "installing lbmpy (once)" >&2
  rm -rf "$scratch/venv" "$scratch/kernels" "$scratch/installed"
  python3 -m venv "$scratch/venv"
  "$scratch/venv/bin/pip" install --quiet --disable-pip-version-check -r "$here/requirements.txt" >&2
  cp "$here/requirements.txt" "$scratch/installed"
fi

# Threads that spin for long after a sweep would take ours their cores.
unset OMP_WAIT_POLICY GOMP_SPINCOUNT
export PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$here/.." PROBE_COMPILER="$($compiler --version | head -1), $flags"
exec "$scratch/venv/bin/python" "$here/peer.py" --scratch "$scratch" "$@"
