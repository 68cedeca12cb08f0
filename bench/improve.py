#!/usr/bin/env python3
"""What --improve makes of sets: heights, contents of trays, and curves over time.

    improve.py PROGRAM DATA OUT.csv [--seconds 0,10,60] [--seeds 0,1,2,3,4] [--only NAME,...]
    improve.py --curve SECONDS PROGRAM DATA OUT.csv [--only NAME,...]
    improve.py --table OUT.csv      a table in Markdown of what was measured: medians, and of several seeds best and worst

0 seconds: without --improve. A row of OUT.csv is one run, or with --curve one gain. Every packing is judged by
`check --require-plan`. Rows are added to what is there.
"""
import argparse
import csv
import json
import os
import statistics
import subprocess
import sys
import tempfile

from measured import add_row, commit_of, machine, rows_of

# Name: set, first so many copies (0: all), options.
JOBS = {
    "tori48": ("tori48", 0, ["--tray", "120x120", "--open-height"]),
    "quick": ("quick", 0, ["--tray", "100x100", "--open-height"]),
    "mixtures-120": ("mixtures", 120, ["--tray", "480x245", "--open-height"]),
    "pieces-500": ("pieces", 500, ["--tray", "480x245", "--open-height"]),
    "thousand": ("thousand", 0, ["--tray", "480x245x200", "--trays", "all"]),
    "mixtures volume": ("mixtures", 0, ["--tray", "480x245x200", "--goal", "volume"]),
    "pieces volume": ("pieces", 0, ["--tray", "480x245x200", "--goal", "volume"]),
    "locks volume": ("locks", 0, ["--tray", "480x245x200", "--goal", "volume"]),
    "mixtures fair": ("mixtures", 0, ["--tray", "480x245x200"]),
    "pieces fair": ("pieces", 0, ["--tray", "480x245x200"]),
    "locks fair": ("locks", 0, ["--tray", "480x245x200"]),
}
FIELDS = ["job", "seconds", "seed", "voxel", "rotations", "what", "before", "now", "steps", "wall", "cpu", "program",
          "command", "commit", "machine"]


def write_set(data, name, copies, path):
    left = copies or 10**9
    with open(os.path.join(data, "sets", name + ".csv")) as source, open(path, "w") as out:
        out.write("mesh,count,scale\n")
        for row in csv.DictReader(source):
            count = min(int(row["count"]), left)
            if count == 0:
                break
            left -= count
            out.write(f"{row['mesh']},{count},{row['scale']}\n")


def run(program, data, job, options, folder, on_line=None):
    name, copies, tray = JOBS[job]
    parts, build = os.path.join(folder, "parts.csv"), os.path.join(folder, "build.json")
    write_set(data, name, copies, parts)
    command = [program, "pack", parts, "--mesh-dir", os.path.join(data, "meshes"), *tray, *options, "-o", build,
               "--journal", os.path.join(folder, "journal"), "--no-resume", "--progress", "json" if on_line else "none"]
    before = os.times()
    process = subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
    for line in process.stderr:
        if on_line and line.startswith("{"):
            on_line(json.loads(line))
    if process.wait() != 0:
        sys.exit(f"{' '.join(command)}: exit {process.returncode}")
    after = os.times()
    subprocess.run([program, "check", "--require-plan", build], check=True, stdout=subprocess.DEVNULL)
    with open(build) as text:
        packing = json.load(text)
    return packing, after.elapsed - before.elapsed, after.children_user - before.children_user


def first_packing(job, packing):
    """What metrics.improvement would say of a packing that is not improved."""
    trays, options = packing["trays"], JOBS[job][2]
    if "--trays" in options:
        what, value = "trays", len(trays) - 1 + trays[-1]["density"]
    elif "--open-height" in options:
        what, value = "height", trays[0]["height"]
    else:
        what, value = "density", trays[0]["density"]
    return {"what": what, "before": value, "now": value, "steps": 0}


def measure(arguments, jobs):
    command = f"bench/improve.py PROGRAM DATA OUT.csv --seconds {arguments.seconds}"
    commit = commit_of(arguments.program)
    for seconds in arguments.seconds.split(","):
        for job in jobs:
            for seed in arguments.seeds.split(",") if float(seconds) > 0 else ["0"]:
                options = ["--improve", seconds, "--seed", seed] if float(seconds) > 0 else []
                with tempfile.TemporaryDirectory() as folder:
                    packing, wall, cpu = run(arguments.program, arguments.data, job, options, folder)
                gain = packing["metrics"]["improvement"] or first_packing(job, packing)
                row = dict(zip(FIELDS, [job, seconds, seed, packing["options"]["voxel"],
                                        packing["options"]["rotations"], gain["what"], round(gain["before"], 4),
                                        round(gain["now"], 4), gain["steps"], round(wall, 1), round(cpu, 1),
                                        packing["program"], command, commit, machine(packing["metrics"]["threads"])]))
                add_row(arguments.out, row, FIELDS)
                print(row, flush=True)


def measure_curves(arguments, jobs):
    for job in jobs:
        points, last = [], []

        def on_line(line):
            if line.get("phase") != "improve":
                return
            last[:] = [(line["seconds"], line["now"], line["done"])]
            if not points or points[-1][1] != line["now"]:
                points.extend(last)

        with tempfile.TemporaryDirectory() as folder:
            run(arguments.program, arguments.data, job, ["--improve", str(arguments.curve)], folder, on_line)
        for second, now, steps in points + last:
            add_row(arguments.out, {"job": job, "second": round(second, 1), "now": round(now, 4), "steps": steps},
                    ["job", "second", "now", "steps"])
        print(job, points[0], points[-1], flush=True)


def shown(what, value):
    value = float(value)
    return f"{value:.1f} mm" if what == "height" else f"{100 * value:.1f} %" if what == "density" else f"{value:.3f}"


def print_table(path):
    rows = rows_of(path)
    times = sorted({float(row["seconds"]) for row in rows})
    titles = ["packed once" if t == 0 else f"{t:g} s more" for t in times]
    print("| job | " + " | ".join(titles) + " | grid | orders tried |")
    print("| --- " * (len(times) + 3) + "|")
    for job in dict.fromkeys(row["job"] for row in rows):
        cells, grids, steps = [job], [], []
        for t in times:
            of_time = [row for row in rows if row["job"] == job and float(row["seconds"]) == t]
            if not of_time:
                cells.append("–")
                continue
            what = of_time[0]["what"]
            values = sorted((float(row["now"]) for row in of_time), reverse=what in ("density", "copies", "value"))
            spread = f" ({shown(what, values[0])}, {shown(what, values[-1])})" if len(values) > 1 else ""
            cells.append(f"**{shown(what, statistics.median(values))}**{spread}")
            if t == 0:
                continue
            grids.append(f"{float(of_time[0]['voxel']):g} mm, {of_time[0]['rotations']}")
            steps.append(f"{statistics.median(int(row['steps']) for row in of_time):.0f}")
        cells += ["; ".join(dict.fromkeys(grids)), ", ".join(steps)]
        print("| " + " | ".join(cells) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--table")
    parser.add_argument("--curve", type=int)
    parser.add_argument("--seconds", default="0,10,60")
    parser.add_argument("--seeds", default="0,1,2,3,4")
    parser.add_argument("--only", default=",".join(JOBS))
    parser.add_argument("program", nargs="?")
    parser.add_argument("data", nargs="?")
    parser.add_argument("out", nargs="?")
    arguments = parser.parse_args()
    if arguments.table:
        return print_table(arguments.table)
    jobs = arguments.only.split(",")
    return measure_curves(arguments, jobs) if arguments.curve else measure(arguments, jobs)


if __name__ == "__main__":
    main()
