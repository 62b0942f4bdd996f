#!/usr/bin/env bash
# The dispatcher and OpenMP by turns, five rounds, so that what disturbs the machine disturbs both:
# ratios of the medians of each round, and the median of those. Takes a folder for the JSON.
set -euo pipefail
cd "$(dirname "$0")/../.."
out=${1:?folder for the results}
mkdir -p "$out"
jmh() { # file, benchmark, cells, works
  java -jar jmh/target/benchmarks.jar -jvm java -f 1 -rf json -rff "$out/$1" "$2" \
    -p cells="$3" -p work="$4" -p peer=PULL,SCATTER,SEQUENTIAL > "$out/log"
}
for round in 1 2 3 4 5; do
  jmh "empty-$round.json" EmptyTaskBenchmark 10000 0
  jmh/peers/openmp/run.sh --cells 10000 --work 0 --output "$out/openmp-0-$round.json" > "$out/log"
  for work in 800 40000; do
    jmh "work-$work-$round.json" TaskCostBenchmark 1000 "$work"
    jmh/peers/openmp/run.sh --cells 1000 --work "$work" \
      --output "$out/openmp-$work-$round.json" > "$out/log"
  done
done
rm "$out/log"
python3 - "$out" <<'PYTHON'
import json, statistics, sys

def median(file, peer):
    for record in json.load(open(file)):
        if record["params"]["peer"] == peer:
            data = record["secondaryMetrics"]["task"]["rawData"]
            return statistics.median(reading for fork in data for reading in fork)

for name, work in (("empty", 0), ("work-800", 800), ("work-40000", 40000)):
    rows = {}
    for n in range(1, 6):
        file = f"{sys.argv[1]}/{name}-{n}.json"
        pull, alone = median(file, "PULL"), median(file, "SEQUENTIAL")
        rows.setdefault("pull, efficiency", []).append(alone / 2 / pull)
        rows.setdefault("bare partition, efficiency", []).append(alone / 2 / median(file, "SCATTER"))
        for record in json.load(open(f"{sys.argv[1]}/openmp-{work}-{n}.json"))["results"]:
            if record["schedule"] in ("static", "dynamic,1"):
                schedule = "OpenMP " + record["schedule"]
                rows.setdefault("pull / " + schedule, []).append(pull / record["nsPerTaskMedian"])
                rows.setdefault(schedule + ", efficiency", []).append(record["efficiency"])
    for what, ratios in rows.items():
        print(f"work {work}: {what}: {statistics.median(ratios):.3f} of {[round(r, 3) for r in ratios]}")
PYTHON
