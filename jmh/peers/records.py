"""What the peers written in Python share: our JSON replies, where a run took place, what is kept of it."""

import json
import os
import pathlib
import re
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def say(text):
    print(text, file=sys.stderr, flush=True)


def spread(values):
    values = list(values)
    return {"median": statistics.median(values), "min": min(values), "max": max(values)}


def reply_of(command, keys):
    """The JSON object that a command of ours prints, in which each of the keys is a number above 0."""
    done = subprocess.run(command, shell=True, cwd=ROOT, capture_output=True, text=True)
    try:
        if done.returncode:
            raise ValueError(f"exit code {done.returncode}")
        reply, _ = json.JSONDecoder().raw_decode(done.stdout, done.stdout.index("{"))
        for key in keys:
            if not 0 < float(reply[key]) < float("inf"):
                raise ValueError(f"{key} must be positive: {reply[key]}")
        return reply
    except (ValueError, KeyError) as fault:
        told = (done.stderr or done.stdout)[-2000:]
        raise SystemExit(f"no reading ({fault!r}) of: {command}\n{told}") from fault


def plain(text):
    """Without this machine's folders."""
    return re.sub(r"(?<![\w.~}])/(?:[^\s/'\":;=]+/)+", "", text.replace(str(ROOT), "."))


def said(*command):
    """The first line that a program says of itself."""
    try:
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    except FileNotFoundError:
        return None
    return ((done.stdout + done.stderr).splitlines() or [None])[0]


def java():
    home = os.environ.get("JAVA_HOME")
    return said(f"{home}/bin/java" if home else "java", "-version")


def machine():
    cpu = re.search(r"model name\s*:\s*(.*)", pathlib.Path("/proc/cpuinfo").read_text())
    return {
        "processor": cpu[1] if cpu else None,
        "processors": os.cpu_count(),
        "memoryGiB": round(os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30, 1),
        "loadBefore": os.getloadavg(),
    }


def environment(*prefixes):
    return {
        name: plain(value) for name, value in sorted(os.environ.items()) if name.startswith(prefixes)
    }


def keep(result, path):
    """JSON with figures of four decimals and each list of figures on a line of its own."""
    figures = json.loads(json.dumps(result), parse_float=lambda text: round(float(text), 4))
    text = re.sub(
        r"\[[\d\s.,e+-]+\]", lambda found: " ".join(found[0].split()), json.dumps(figures, indent=1)
    )
    file = pathlib.Path(path)
    temporary = file.with_name(file.name + ".part")
    temporary.write_text(text + "\n")
    temporary.replace(file)
