"""lbmpy and ours by turns in one run; see run.sh. Ratios are of readings that follow each other."""

import argparse
import os
import pathlib
import re
import shlex
import subprocess
import sys
from importlib import metadata

from records import ROOT, environment, java, keep, machine, plain, reply_of, said, say, spread

DUCT = (
    "./hdispatch duct --size {size} --threads {threads} --lattice {lattice} --storage {storage}"
    " --streaming STREAMING --steps {steps} --json"
)


def arguments():
    parser = argparse.ArgumentParser(
        prog="run.sh",
        description="lbmpy's kernels and our duct by turns, with the bandwidth probed between.",
    )
    parser.add_argument("--scratch", help=argparse.SUPPRESS)
    parser.add_argument("--size", type=int, nargs="+", default=[200], help="nodes along an edge")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--lattice", default="D3Q15", help="D3Q15 (default) or D3Q19")
    parser.add_argument("--precision", default="double", help="double (default) or single, or float")
    parser.add_argument("--steps", type=int, default=40, help="timed steps of a reading (default 40)")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument(
        "--ours",
        action="append",
        nargs="+",
        metavar=("[LABEL]", "COMMAND"),
        help="a shell command, run in the top folder, that prints a JSON object with mlups_median;"
        " {size}, {threads}, {lattice}, {storage} and {steps} are filled in; --lattice, --storage and"
        " --streaming in it say what lbmpy is to do beside it. May be repeated; default: "
        + DUCT.replace("STREAMING", "in-place")
        + " and the same with pull",
    )
    parser.add_argument("--alone", action="store_true", help="lbmpy only")
    parser.add_argument(
        "--form",
        action="append",
        default=[],
        metavar="LATTICE/PRECISION/STREAMING",
        help="have lbmpy do this too, with none of ours beside it, as D3Q19/single/in-place",
    )
    parser.add_argument(
        "--pattern",
        choices=("aa", "esotwist", "esopull", "esopush"),
        help="of lbmpy in place; default: aa for D3Q15, esotwist for D3Q19",
    )
    parser.add_argument("--probe-size", type=float, default=1.25, help="GiB an array (default 1.25)")
    parser.add_argument("--output", metavar="FILE", help="every reading as JSON")
    options = parser.parse_args()
    if options.alone and options.ours:
        parser.error("--alone and --ours exclude each other")
    for name in ("threads", "steps", "rounds"):
        if getattr(options, name) < 1:
            parser.error(f"--{name} must be at least 1: {getattr(options, name)}")
    return options


options = arguments()
os.environ["OMP_NUM_THREADS"] = str(options.threads)  # before OpenMP starts
import kernel as lbm  # noqa: E402
from probe import Probe  # noqa: E402


class Ours:
    """A command of ours and the form of lbmpy that it is measured against."""

    def __init__(self, label, command, size):
        for name, value in (
            ("size", size),
            ("threads", options.threads),
            ("lattice", options.lattice),
            ("storage", lbm.Form.of(options.lattice, options.precision, "pull").precision),
            ("steps", options.steps),
        ):
            command = command.replace("{" + name + "}", str(value))
        self.command = command
        self.form = lbm.Form.of(
            self._option("lattice", options.lattice),
            self._option("storage", options.precision),
            self._option("streaming", "in-place"),
        )
        self.label = label or str(self.form)
        for name, value in (("size", size), ("threads", options.threads)):
            if self._option(name, str(value)) != str(value):
                raise SystemExit(f"{name} must be lbmpy's: {name}={value}, command={command}")

    def _option(self, name, default):
        found = re.findall(rf"--{name}[ =]([^\s'\"]+)", self.command)
        return found[-1] if found else default

    def read(self):
        reply = reply_of(self.command, ["mlups_median"])
        return {"mlupsMedian": float(reply["mlups_median"]), "reply": reply}


def default_ours():
    return [[streaming, DUCT.replace("STREAMING", streaming)] for streaming in lbm.STREAMINGS]


def plan(size):
    """What a round consists of: each of ours after lbmpy in the same form, then the forms left."""
    commands = [] if options.alone else options.ours or default_ours()
    if any(len(command) > 2 for command in commands):
        raise SystemExit("--ours takes a label and a command, or a command: quote both")
    ours = [Ours(c[0] if len(c) == 2 else None, c[-1], size) for c in commands]
    if len({one.label for one in ours}) < len(ours):
        raise SystemExit("each of ours needs a label of its own")
    left = [lbm.Form.of(*(form.split("/") + ["", ""])[:3]) for form in options.form]
    if options.alone and not left:
        left = [lbm.Form.of(options.lattice, options.precision, s) for s in lbm.STREAMINGS]
    left = [form for form in dict.fromkeys(left) if form not in {one.form for one in ours}]
    return [(one.form, one) for one in ours] + [(form, None) for form in left]


def measure(size, probe):
    """All rounds of a size: the readings in the order of time, a probe before and after each."""
    steps = plan(size)
    kernels = {}
    for form, _ in steps:
        if form not in kernels:
            say(f"{form}: compiling")
            pattern = options.pattern or lbm.IN_PLACE_PATTERNS[form.lattice]
            kernels[form] = lbm.Kernel(form, size, pattern, f"{options.scratch}/kernels")
    if any(one and one.command.startswith("./hdispatch") for _, one in steps):
        subprocess.run(["./hdispatch", "--help"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)

    memory = memory_held()
    readings = []
    for round_ in range(1, options.rounds + 1):

        def record(what, name, form, reading):
            where = {"size": size, "round": round_, "what": what}
            if form:
                where |= {"name": name, "form": str(form)}
            readings.append(where | reading)

        record("probe", None, None, probe.read())
        for form, one in steps:
            for what, name, source in (
                ("lbmpy", kernels[form].pattern, lambda: kernels[form].read(options.steps)),
                ("ours", one and one.label, one and one.read),
            ):
                if not source:
                    continue
                reading = source()
                record(what, name, form, reading)
                record("probe", None, None, probe.read())
                readings[-2] |= beside(form, reading["mlupsMedian"], readings[-3], readings[-1])
                say(
                    f"size {size}, round {round_}: {what} {name} ({form}):"
                    f" {reading['mlupsMedian']:.1f} MLUPS, {readings[-2]['GBps']:.1f} of"
                    f" {readings[-2]['besideGBps']:.1f} GB/s"
                )
    forms = [
        {
            "size": size,
            "form": str(form),
            "pattern": kernel.pattern,
            "bytesPerUpdate": form.bytes_per_update,
            "bytesPerNode": kernel.bytes_per_node,
            "secondsToBuild": kernel.seconds_to_build,
        }
        for form, kernel in kernels.items()
    ]
    commands = [
        {"size": size, "label": one.label, "form": str(one.form), "command": plain(one.command)}
        for _, one in steps
        if one
    ]
    return {"forms": forms, "ours": commands, "readings": readings, "memory": memory}


def beside(form, mlups, before, after):
    """The traffic of an update, and its share in the mean of the probes before and after."""
    key = "inPlaceGBpsMedian" if form.streaming == "in-place" else "copyGBpsMedian"
    traffic = mlups * form.bytes_per_update / 1e3
    bandwidth = (before[key] + after[key]) / 2
    return {"GBps": traffic, "besideGBps": bandwidth, "fraction": traffic / bandwidth}


def summary(readings):
    """A record for each of ours, then one for each form of lbmpy with all its readings."""
    pairs, alone = {}, {}
    peer = None
    for reading in readings:
        if reading["what"] == "lbmpy":
            peer = reading
            alone.setdefault((reading["size"], reading["form"], reading["name"]), []).append(reading)
        elif reading["what"] == "ours":
            key = reading["size"], reading["form"], reading["name"]
            pairs.setdefault(key, []).append((reading, peer))

    def of(key, some):
        size, form, name = key
        record = {"size": size, "form": form, "name": name}
        return record | {
            field: spread(reading[field] for reading in some)
            for field in ("mlupsMedian", "GBps", "besideGBps", "fraction")
        }

    ours = []
    for key, both in pairs.items():
        ratios = [mine["mlupsMedian"] / its["mlupsMedian"] for mine, its in both]
        shares = [mine["fraction"] / its["fraction"] for mine, its in both]
        record = of(key, [mine for mine, _ in both])
        record |= {"ratios": ratios, "ratio": spread(ratios)}
        record |= {"shareRatios": shares, "shareRatio": spread(shares)}
        ours.append(record | {"lbmpy": of(key[:2] + (both[0][1]["name"],), [its for _, its in both])})
    return {"ours": ours, "lbmpy": [of(key, some) for key, some in alone.items()]}


def table(results):
    def figures(record):
        mlups, share = record["mlupsMedian"], record["fraction"]
        return (
            f"{mlups['median']:.1f} ({mlups['min']:.1f} to {mlups['max']:.1f})"
            f" | {100 * share['median']:.0f} % ({100 * share['min']:.0f} to {100 * share['max']:.0f})"
        )

    if results["ours"]:
        yield (
            "| size | ours | MLUPS | of the bandwidth | lbmpy | MLUPS | of the bandwidth | ours / lbmpy"
            " | the same of the shares |"
        )
        yield "|---|---|---|---|---|---|---|---|---|"
        for one in results["ours"]:
            its, ratio, shares = one["lbmpy"], one["ratio"], one["shareRatio"]
            yield (
                f"| {one['size']} | {one['name']} | {figures(one)} | {one['form']}, {its['name']}"
                f" | {figures(its)}"
                f" | **{ratio['median']:.3f}** ({ratio['min']:.3f} to {ratio['max']:.3f})"
                f" | {shares['median']:.3f} ({shares['min']:.3f} to {shares['max']:.3f}) |"
            )
        yield ""
    yield "| size | lbmpy | MLUPS | of the bandwidth | GB/s | probe, GB/s |"
    yield "|---|---|---|---|---|---|"
    for one in results["lbmpy"]:
        bandwidth = one["besideGBps"]
        yield (
            f"| {one['size']} | {one['form']}, {one['name']} | {figures(one)}"
            f" | {one['GBps']['median']:.1f}"
            f" | {bandwidth['median']:.1f} ({bandwidth['min']:.1f} to {bandwidth['max']:.1f}) |"
        )


def memory_held():
    """GiB of this process, and how much of it lies in huge pages."""
    rollup = pathlib.Path("/proc/self/smaps_rollup").read_text()

    def gib(name):
        return int(re.search(rf"^{name}:\s+(\d+)", rollup, re.MULTILINE)[1]) / 2**20

    return {"residentGiB": gib("Rss"), "hugePagesGiB": gib("AnonHugePages")}


def surroundings():
    return {
        "command": plain(shlex.join(["jmh/peers/lbmpy/run.sh"] + sys.argv[3:])),
        "versions": {name: metadata.version(name) for name in ("lbmpy", "pystencils", "sympy", "numpy")}
        | {
            "python": sys.version.split()[0],
            "g++": said("g++", "--version"),
            "java": java(),
            "ours": said("git", "describe", "--always", "--dirty"),
        },
        "kernelCompiler": lbm.compiler(),
        "probeCompiler": os.environ.get("PROBE_COMPILER"),
        "target": str(lbm.target()),
        **machine(),
        "environment": environment("OMP_", "GOMP_", "HDISPATCH_", "JAVA_TOOL_OPTIONS"),
        "threads": options.threads,
        "steps": options.steps,
        "rounds": options.rounds,
        "probeGiB": options.probe_size,
    }


def main():
    result = surroundings()
    for size in options.size:
        plan(size)  # a mistake in the options shows before anything is measured
    probe = Probe(f"{options.scratch}/probe.so", options.probe_size, options.threads)
    parts = [measure(size, probe) for size in options.size]
    for name in ("forms", "ours", "readings"):
        result[name] = [record for part in parts for record in part[name]]
    result["memory"] = [part["memory"] for part in parts]
    result["loadAfter"] = os.getloadavg()
    result["results"] = summary(result["readings"])
    print("\n".join(table(result["results"])))
    if options.output:
        keep(result, options.output)


main()
