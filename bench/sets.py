#!/usr/bin/env python3
"""Packs the benchmark sets and adds a row for each run to bench/results/sets.csv.

    sets.py PROGRAM [DATA] [--only NAME,...] [--runs 3] [--out FILE]

DATA is the folder of the benchmark data; without it $SPECTRALPACK_DATA, else ../shared/data. NAME is a suite, a set, or
SUITE/SET; without --only all suites are run:

    default   the sets with all options at their defaults, as a user runs them
    search    the bare search: no gap, no finer voxels for collisions, no refining, no plan
    open      without a ceiling
    small     samples and generated sets, which need no DATA

Runs go round the sets, so that a busy minute does not hit one set alone. seconds_total is the time of the whole program by
the clock, the other seconds are metrics.seconds of the packing file. Every packing is judged by `check`, with
--require-plan where it has a plan; the column ok has the answer. Then `bench/figures.py` makes the tables.
"""
import argparse
import datetime
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from measured import ROOT, add_row, commit_of, machine

RESULTS = ROOT / "bench" / "results" / "sets.csv"
FIELDS = ["suite", "set", "options", "placed", "copies", "trays", "density", "height", "seconds_total", "seconds_search",
          "seconds_refine", "seconds_disassemble", "ok", "command", "commit", "machine", "date"]

TRAY = "--tray 480x245x200"
BARE = "--gap 0 --detail 1 --no-refine --interlock off"
# Suite: set: options of pack.
SUITES = {
    "default": {
        "mixtures": TRAY,
        "pieces": TRAY,
        "locks": TRAY,
        "quick": "--tray 160x120x100",
        "thousand": f"{TRAY} --trays all",
        "sixthousand": f"{TRAY} --trays all",
    },
    "search": {
        "mixtures": f"{TRAY} {BARE}",
        "pieces": f"{TRAY} {BARE}",
        "locks": f"{TRAY} {BARE}",
    },
    "open": {
        "tori48": "--tray 240x240 --open-height",
        "quick": "--tray 100x100 --open-height",
    },
    "small": {
        "samples": "--tray 160x120x100 --voxel 1 --gap 1",
        "pieces 300": "--tray 200x160x120",
        "mixtures 60": "--tray 180x140x100",
        "locks 100": "--tray 240x200x120",
        "tori 48": "--tray 120x120 --open-height",
    },
}


def wanted(only):
    """Suite, set and options of what --only names; all without it."""
    names = set(only.split(",")) if only else set()
    jobs = [(suite, name, options) for suite, sets in SUITES.items() for name, options in sets.items()]
    known = {word for suite, name, _ in jobs for word in (suite, name, f"{suite}/{name}")}
    if names - known:
        sys.exit(f"no suite or set is named {', '.join(sorted(names - known))}")
    return [job for job in jobs if not names or names & {job[0], job[1], f"{job[0]}/{job[1]}"}]


def parts_of(program, suite, name, data, folder):
    """Arguments of pack for the set's parts, those for the column `command`, and what made the set."""
    if suite != "small":
        return ([f"{data}/sets/{name}.csv", "--mesh-dir", f"{data}/meshes"],
                f"DATA/sets/{name}.csv --mesh-dir DATA/meshes", "")
    if name == "samples":
        return [str(ROOT / "data/samples/samples.csv")], "data/samples/samples.csv", ""
    kind, count = name.split()
    subprocess.run([program, "generate", kind, "--count", count, "-o", folder / "set"], check=True,
                   stdout=subprocess.DEVNULL)
    return ([str(folder / "set" / f"{kind}.csv")], f"SET/{kind}.csv",
            f"spectralpack generate {kind} --count {count} -o SET && ")


def run(program, suite, name, options, data):
    # A folder of its own: a run goes on from the journal that an earlier one left beside the same output.
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        parts, parts_text, before = parts_of(program, suite, name, data, folder)
        build = folder / "b.json"
        began = time.perf_counter()
        subprocess.run([program, "pack", *parts, *options.split(), "-o", build, "--progress", "none"], check=True,
                       stdout=subprocess.DEVNULL)
        seconds_total = time.perf_counter() - began
        has_plan = "--interlock off" not in options
        check = subprocess.run([program, "check", build, *(["--require-plan"] if has_plan else [])],
                               stdout=subprocess.DEVNULL)
        with open(build, encoding="utf-8") as text:
            packing = json.load(text)
    metrics, trays = packing["metrics"], packing["trays"]
    seconds = metrics["seconds"]
    return {
        "suite": suite,
        "set": name,
        "options": options,
        "placed": metrics["placed"],
        "copies": metrics["copies"],
        "trays": len(trays),
        "density": round(metrics["density"], 5),
        "height": round(trays[0]["height"], 2) if len(trays) == 1 else "",
        "seconds_total": round(seconds_total, 2),
        "seconds_search": round(seconds["search"], 2),
        "seconds_refine": round(seconds["refine"], 2),
        "seconds_disassemble": round(seconds["disassemble"], 2),
        "ok": "yes" if check.returncode == 0 else "no",
        "command": f"{before}spectralpack pack {parts_text} {options} -o b.json",
        "machine": machine(metrics["threads"]),
        "date": datetime.date.today().isoformat(),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("data", nargs="?", default=os.environ.get("SPECTRALPACK_DATA", ROOT.parent / "shared" / "data"))
    parser.add_argument("--only")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--out", type=pathlib.Path, default=RESULTS)
    arguments = parser.parse_args()
    program = str(arguments.program.resolve())
    data = pathlib.Path(arguments.data).resolve()
    jobs = wanted(arguments.only)
    if any(job[0] != "small" for job in jobs) and not (data / "sets").is_dir():
        sys.exit(f"{data} has no sets: name the folder of the data, or --only small")
    commit = commit_of(program)
    for _ in range(arguments.runs):
        for suite, name, options in jobs:
            row = run(program, suite, name, options, data) | {"commit": commit}
            add_row(arguments.out, row, FIELDS)
            print({field: row[field] for field in FIELDS if field != "command"}, flush=True)


if __name__ == "__main__":
    main()
