#!/usr/bin/env python3
"""Prints what JMH and the OpenMP peer measured as Markdown.

    python3 jmh/results/table.py [--metric NAME] [--over-ideal] FILE.json ...

One table per file and benchmark: a row for each peer (schedule, method, or else the parameter that
varies most), a column for each set of the other parameters that vary. A figure is the median of all
readings of all forks. Behind it, in percent, stands the efficiency: sequential / (workers * time),
sequential being the row of that name in the same column, or in the one column like it but for the
number of workers.

A metric is `score` or the name of a secondary one, as `gc.alloc.rate.norm`. Without --metric it is
the benchmark's own counter (task, cell, mflups), or the score where there is none; of single shots
the slowest stands beside the median. With --over-ideal a figure is time - sequential / workers.

Below a table stands what handing a cache line back and forth cost while it was measured.
"""

import argparse
import json
import statistics
from dataclasses import dataclass, replace

COUNTERS = ("task", "cell", "mflups")  # of our benchmarks; other metrics are profilers'


@dataclass(frozen=True)
class Reading:
    """What one set of parameters gave."""

    name: str  # of the benchmark
    method: str
    params: tuple  # of (name, value), in order
    metric: str
    unit: str
    values: tuple  # all readings
    single_shot: bool = False
    sequential: float = 0.0  # where the record itself says it
    round_trips: tuple = ()  # of a cache line, ns

    def param(self, name):
        return dict(self.params).get(name)

    def without(self, *names):
        return tuple(p for p in self.params if p[0] not in names)


def raw(data):
    """All readings of all forks."""
    return tuple(v for fork in data.get("rawData", []) for v in fork if v != "NaN")


def jmh(record, wanted):
    """The reading of one record of a JMH file; None if it lacks the metric."""
    secondary = record["secondaryMetrics"]
    counters = [name for name in COUNTERS if name in secondary]
    metric = wanted or (counters[0] if counters else "score")
    if metric != "score" and metric not in secondary:
        return None
    data = record["primaryMetric"] if metric == "score" else secondary[metric]
    values = raw(data)
    name, method = record["benchmark"].rsplit(".", 1)
    return Reading(
        name.rsplit(".", 1)[1],
        method,
        tuple(record.get("params", {}).items()),
        metric,
        unit(metric, data["scoreUnit"]),
        values,
        record["mode"] == "ss",
        round_trips=raw(secondary.get("roundTripNs", {})),
    )


def unit(metric, score_unit):
    """The counters' unit: JMH writes that of the score."""
    if metric not in COUNTERS:
        return score_unit
    if metric == "mflups" and score_unit == "ops/us":
        return "10^6 a second"
    return score_unit.replace("/op", " a " + metric)


def openmp(record, threads):
    """The reading of one record of the OpenMP peer: a table for each kind of load."""
    load = f"{record['law']}, work {record['work']}" + (", a core taken" if record["taken"] else "")
    return Reading(
        f"{record['peer']}: {load}",
        "step",
        (
            ("schedule", record["schedule"]),
            ("cells", str(record["cells"])),
            ("workers", str(threads)),
        ),
        "task",
        "ns a task",
        (record["nsPerTaskMedian"],),
        sequential=record["sequentialNsPerTaskMedian"],
        round_trips=tuple(t for t in [record.get("roundTripNs")] if t),
    )


def read(path, wanted):
    """All readings of a file that have the metric."""
    with open(path, encoding="utf-8") as file:
        content = json.load(file)
    if isinstance(content, dict):
        results = content["results"]
        threads = max(record["threads"] for record in results)  # the plain loop says 1
        return [openmp(record, threads) for record in results]
    readings = (jmh(record, wanted) for record in content)
    return [reading for reading in readings if reading and reading.values]


def row_parameter(readings, varying):
    """The parameter that names the rows."""
    for name in ("peer", "schedule"):
        if readings[0].param(name) is not None:
            return name
    if len({r.method for r in readings}) > 1 or not varying:
        return "method"
    return max(varying, key=lambda name: len({r.param(name) for r in readings}))


def is_sequential(reading, row):
    return reading.param(row).lower() == "sequential"


def sequential_of(reading, row, readings):
    """Time of the sequential loop on the same load; 0 if nobody measured it or this is no time."""
    if reading.sequential or reading.metric not in ("score", *COUNTERS):
        return reading.sequential

    def load(other):
        return other.without("workers", row)

    loops = [r for r in readings if is_sequential(r, row) and load(r) == load(reading)]
    same = [r for r in loops if r.param("workers") == reading.param("workers")]
    found = same or loops
    return statistics.median(found[0].values) if len(found) == 1 else 0.0


def figure(value):
    """Three significant digits, no exponent."""
    exponent = int(f"{value:.2e}".split("e")[1])
    return f"{value:.{max(0, 2 - exponent)}f}"


def cell(reading, row, readings, over_ideal):
    """What stands in the table for one set of parameters."""
    median = statistics.median(reading.values)
    if reading.single_shot:
        return f"{figure(median)} (slowest {figure(max(reading.values))})"
    sequential = sequential_of(reading, row, readings)
    if not sequential or is_sequential(reading, row):
        return figure(median)
    workers = int(reading.param("workers") or 1)
    if over_ideal:
        return figure(median - sequential / workers)
    return f"{figure(median)} ({100 * sequential / (workers * median):.0f} %)"


def table(readings, over_ideal):
    """The lines of one table."""
    names = [name for name, _ in readings[0].params]
    varying = [n for n in names if len({r.param(n) for r in readings}) > 1]
    row = row_parameter(readings, varying)
    if row == "method":
        readings = [replace(r, params=(("method", r.method), *r.params)) for r in readings]
    fixed = [f"{n}={readings[0].param(n)}" for n in names if n not in varying and n != row]
    across = [n for n in varying if n != row]

    def column(reading):
        return tuple(reading.param(n) for n in across)

    columns = list(dict.fromkeys(column(r) for r in readings))
    rows = list(dict.fromkeys(r.param(row) for r in readings))
    cells = {(r.param(row), column(r)): cell(r, row, readings, over_ideal) for r in readings}
    heads = [", ".join(f"{n}={v}" for n, v in zip(across, c)) or readings[0].unit for c in columns]
    yield f"{readings[0].metric}, {readings[0].unit}" + "".join(f"; {f}" for f in fixed)
    yield ""
    yield "| " + " | ".join([row, *heads]) + " |"
    yield "|---" * (1 + len(heads)) + "|"
    for name in rows:
        yield "| " + " | ".join([name, *(cells.get((name, c), "") for c in columns)]) + " |"
    trips = [t for r in readings for t in r.round_trips]
    if trips:
        median = statistics.median(trips)
        yield ""
        yield f"round trip of a cache line: {min(trips):.0f} to {max(trips):.0f} ns, median {median:.0f}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--metric", help="score, or the name of a secondary metric")
    parser.add_argument("--over-ideal", action="store_true", help="time - sequential / workers")
    parser.add_argument("files", nargs="+", metavar="FILE.json")
    arguments = parser.parse_args()
    for path in arguments.files:
        readings = read(path, arguments.metric)
        for name in dict.fromkeys(r.name for r in readings):
            print(f"**{name}** ({path})\n")
            lines = table([r for r in readings if r.name == name], arguments.over_ideal)
            print("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
