"""LAMMPS's SPH and ours by turns in one run; see run.sh. Ratios are of readings that follow each other."""

import argparse
import os
import shlex
import subprocess
import sys

import shear
from records import ROOT, environment, java, keep, machine, plain, reply_of, said, say, spread

SEARCHES = ("verlet", "single", "double")
OURS = (
    "./hdispatch sph periodic --particles {particles} --search {search} --steps {steps}"
    " --threads {threads} --support {support} --json"
)
KEYS = {  # above 0; and their names in a reading, of LAMMPS or ours
    "particle_steps_per_s": "particleStepsPerS",
    "neighbours_mean": "neighboursMean",
    "pairs_per_s": "pairsPerS",
    "bytes_per_particle": "bytesPerParticle",
}
OTHERS = {  # may be 0; LAMMPS tells search from pairs (secondsPair) only
    "bytes_per_step": "bytesPerStep",
    "seconds_search": "secondsSearch",
    "seconds_density": "secondsDensity",
    "seconds_force": "secondsForce",
    "rebuilds": "rebuilds",
}
ALIKE = 0.05  # how far apart the two may be in their mean number of neighbours


def arguments():
    parser = argparse.ArgumentParser(
        prog="run.sh", description="LAMMPS's SPH and ours by turns: a shear flow in a periodic box."
    )
    parser.add_argument("--particles", type=int, default=60**3, help="a cube (default 216000)")
    parser.add_argument(
        "--support", type=float, nargs="+", default=[3.0], help="in spacings (default 3.0; 2.6 too)"
    )
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2], help="of LAMMPS: ranks")
    parser.add_argument(
        "--search", nargs="+", choices=SEARCHES, default=SEARCHES, help="of ours (default all three)"
    )
    parser.add_argument("--steps", type=int, default=40, help="timed steps of a reading (default 40)")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument(
        "--ours",
        default=OURS,
        metavar="COMMAND",
        help="a shell command, run in the top folder, that prints a JSON object with "
        + ", ".join([*KEYS, *OTHERS])
        + f"; default: {OURS}",
    )
    parser.add_argument("--alone", action="store_true", help="LAMMPS only")
    parser.add_argument("--output", metavar="FILE", help="every reading as JSON")
    options = parser.parse_args()
    for name, least in (("steps", 1), ("rounds", 1), ("threads", 1), ("support", 1)):
        values = getattr(options, name)
        for value in values if isinstance(values, list) else [values]:
            if value < least:
                parser.error(f"--{name} must be at least {least}: {value}")
    if 2 * (max(options.support) + shear.FLOW["skin"]) > shear.edge_of(options.particles):
        parser.error(f"the box must be twice the list's reach: --particles {options.particles}")
    return options


options = arguments()


def command_of(search, threads, support):
    command = options.ours
    for name, value in (
        ("particles", options.particles),
        ("search", search),
        ("steps", options.steps),
        ("threads", threads),
        ("support", support),
    ):
        command = command.replace("{" + name + "}", str(value))
    return command


def ours(search, threads, support):
    command = command_of(search, threads, support)
    reply = reply_of(command, KEYS)
    missing = [key for key in OTHERS if key not in reply]
    if missing:
        raise SystemExit(f"no {', '.join(missing)} in the reply of: {command}")
    return {name: float(reply[key]) for key, name in (KEYS | OTHERS).items()} | {"reply": reply}


def compared(mine, its):
    """Ours over LAMMPS, two readings of the same case; the neighbours must say that it is the same."""
    apart = mine["neighboursMean"] / its["neighboursMean"] - 1
    if abs(apart) > ALIKE:
        raise SystemExit(
            f"neighbours must be LAMMPS's within {ALIKE:.0%}: ours={mine['neighboursMean']},"
            f" LAMMPS={its['neighboursMean']}"
        )
    return mine["particleStepsPerS"] / its["particleStepsPerS"]


def measure():
    """All rounds: the readings in the order of time, each of ours right after one of LAMMPS."""
    readings = []
    for round_ in range(1, options.rounds + 1):
        for support in options.support:
            for threads in options.threads:
                where = {"round": round_, "support": support, "threads": threads}

                def record(what, search, reading):
                    readings.append(where | {"what": what, "search": search} | reading)
                    say(
                        f"round {round_}, support {support}, threads {threads}: {what} {search or ''}"
                        f" {reading['particleStepsPerS'] / 1e3:.1f} k particle-steps/s,"
                        f" {reading['neighboursMean']:.1f} neighbours,"
                        f" {reading['rebuilds']:.0f} rebuilds in {options.steps} steps"
                    )

                for search in [None] if options.alone else options.search:
                    its = shear.read(options.particles, support, threads, options.steps)
                    record("lammps", None, its)
                    if search:
                        mine = ours(search, threads, support)
                        record("ours", search, mine | {"ratio": compared(mine, its)})
    return readings


def summary(readings):
    """A record for LAMMPS and one for each search of ours, at each support and number of threads."""
    groups = {}
    for reading in readings:
        key = reading["support"], reading["threads"], reading["what"], reading["search"]
        groups.setdefault(key, []).append(reading)
    results = []
    for (support, threads, what, search), some in groups.items():
        record = {"support": support, "threads": threads, "what": what, "search": search}
        for name in (
            *("ratio", "particleStepsPerS", "neighboursMean", "pairsPerS", "rebuilds"),
            *("bytesPerParticle", "bytesPerStep"),
            *("secondsSearch", "secondsDensity", "secondsForce", "secondsPair", "secondsExchange"),
        ):
            if name in some[0]:
                record[name] = spread(reading[name] for reading in some)
        results.append(record)
    return results


def table(results):
    yield (
        "| support | threads | | 10^3 particle-steps/s | ours / LAMMPS | neighbours | 10^6 pairs/s"
        " | bytes a particle | rebuilds |"
    )
    yield "|---|---|---|---|---|---|---|---|---|"
    for one in results:
        rate, ratio = one["particleStepsPerS"], one.get("ratio")
        beside = (
            f"**{ratio['median']:.3f}** ({ratio['min']:.3f} to {ratio['max']:.3f})" if ratio else ""
        )
        yield (
            f"| {one['support']} | {one['threads']} | {one['search'] or 'LAMMPS'}"
            f" | {rate['median'] / 1e3:.1f} ({rate['min'] / 1e3:.1f} to {rate['max'] / 1e3:.1f})"
            f" | {beside}"
            f" | {one['neighboursMean']['median']:.1f}"
            f" | {one['pairsPerS']['median'] / 1e6:.1f}"
            f" | {one['bytesPerParticle']['median']:.0f}"
            f" | {one['rebuilds']['median']:.0f} in {options.steps} |"
        )


def surroundings():
    return {
        "command": plain(shlex.join(["jmh/peers/lammps/run.sh"] + sys.argv[1:])),
        "versions": shear.versions()
        | {"java": java(), "ours": said("git", "describe", "--always", "--dirty")},
        **machine(),
        "environment": environment("OMP_", "MPI", "HDISPATCH_", "JAVA_TOOL_OPTIONS"),
        "flow": shear.FLOW,
        "particles": options.particles,
        "warmUp": shear.WARM_UP,
        "steps": options.steps,
        "rounds": options.rounds,
        "ours": None if options.alone else options.ours,
    }


def main():
    result = surroundings()
    if not options.alone and options.ours.startswith("./hdispatch"):
        subprocess.run(["./hdispatch", "--help"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    result["readings"] = measure()
    result["loadAfter"] = os.getloadavg()
    result["results"] = summary(result["readings"])
    print("\n".join(table(result["results"])))
    if options.output:
        keep(result, options.output)


main()
