"""The shear flow as LAMMPS computes it (shear.lmp), each reading a run of its own under mpiexec."""

import os
import pathlib
import re
import subprocess
import sys
import sysconfig
from importlib import metadata

# The flow in spacings, steps and particle masses. At its fastest a particle crosses half the skin in
# ten steps; the sound covers 0.15 of a spacing in a step, the viscosity 0.01 of its square.
FLOW = {"skin": 0.3, "speed": 0.015, "sound": 0.15, "viscosity": 0.01, "seed": 20}
WARM_UP = 10  # steps
INPUT = pathlib.Path(__file__).resolve().with_name("shear.lmp")
TASKS = {"Pair": "secondsPair", "Neigh": "secondsSearch", "Comm": "secondsExchange"}


def read(particles, support, ranks, steps):
    """Particle-steps a second by LAMMPS's own loop time, and what it says of lists and memory."""
    variables = FLOW | {
        "edge": edge_of(particles),
        "support": support,
        "warmup": WARM_UP,
        "steps": steps,
    }
    folder = pathlib.Path(sysconfig.get_path("scripts"))
    command = [str(folder / "mpiexec"), "-n", str(ranks), str(_program())]
    command += ["-log", "none", "-in", str(INPUT)]
    for name, value in variables.items():
        command += ["-var", name, str(value)]
    libraries = {"LD_LIBRARY_PATH": str(folder.parent / "lib"), "OMP_NUM_THREADS": "1"}
    done = subprocess.run(command, capture_output=True, text=True, env=os.environ | libraries)
    try:
        if done.returncode:
            raise ValueError(f"exit code {done.returncode}")
        return _reading(done.stdout, particles, ranks, steps)
    except (ValueError, IndexError) as fault:
        told = (done.stdout + done.stderr)[-2000:]
        raise SystemExit(f"no reading ({fault!r}) of: {' '.join(command)}\n{told}") from fault


def edge_of(particles):
    edge = round(particles ** (1 / 3))
    if edge**3 != particles:
        raise SystemExit(f"particles must be a cube: particles={particles}")
    return edge


def versions():
    packages = {name: metadata.version(name) for name in ("lammps", "mpich")}
    return packages | {"python": sys.version.split()[0]}


def _program():
    (program,) = pathlib.Path(sysconfig.get_path("purelib")).glob("lammps/lmp")
    return program


def _reading(said, particles, ranks, steps):
    """Three runs: warm-up, the timed one, and one of no steps that says what became of the flow."""
    _, timed, after = said.split("Setting up Verlet run")[1:]

    def figures(pattern, text):
        return [float(figure) for figure in re.search(pattern, text, re.MULTILINE).groups()]

    try:
        seconds, on, did = figures(r"^Loop time of (\S+) on (\d+) procs for (\d+) steps", timed)
        (listed,) = figures(r"^Ave neighs/atom = (\S+)", timed)
        (rebuilds,) = figures(r"^Neighbor list builds = (\d+)", timed)
        (dangerous,) = figures(r"^Dangerous builds = (\d+)", timed)
        (mebibytes,) = figures(r"^Per MPI rank memory allocation .* = \S+ \| (\S+) \|", timed)
        tasks = {
            name: figures(rf"^{task}\s*\|\s*\S+\s*\|\s*(\S+)", timed)[0] for task, name in TASKS.items()
        }
        row = r"^\s+\d+" + 5 * r"\s+(\S+)"
        neighbours, density, least, most, fastest = figures(row, after)
    except AttributeError as fault:
        raise ValueError("LAMMPS speaks otherwise than this script expects") from fault
    if (on, did) != (ranks, steps):
        raise ValueError(f"must be {ranks} ranks and {steps} steps: ranks={on}, steps={did}")
    if dangerous or not 0.8 < least <= density <= most < 1.2 or not 0.5 < fastest / FLOW["speed"] < 1.5:
        raise ValueError(
            f"the flow blew up, died away, or outran its list: densities {least} to {most},"
            f" speed {fastest}, dangerous rebuilds {dangerous}"
        )
    rate = particles * steps / seconds
    return tasks | {
        "particleStepsPerS": rate,
        "seconds": seconds,
        "rebuilds": rebuilds,
        "neighboursMean": neighbours,
        "listedMean": listed,
        "pairsPerS": rate * neighbours,
        "bytesPerParticle": ranks * mebibytes * 2**20 / particles,
        "densityLeast": least,
        "densityMost": most,
        "speedMost": fastest,
    }
