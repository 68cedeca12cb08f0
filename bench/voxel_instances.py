#!/usr/bin/env python3
"""Packs the voxel instances of the benchmark data without a ceiling, one voxel a millimetre, and prints the heights.

    bench/voxel_instances.py build/apps/cli/spectralpack DATA/voxel-instances [INSTANCE...] [-- more options of pack]

Bases are those, in voxels, of the published voxel runs (best_known.csv); where there is none, the instance's own base
divided by the voxel size, rounded down.
"""

import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile


def voxel_size(binvox):
    """scale / largest dimension, from the text header."""
    values = {}
    with open(binvox, "rb") as file:
        for line in file:
            words = line.split()
            if words[0] == b"data":
                break
            values[words[0]] = [float(word) for word in words[1:] if words[0] != b"#binvox"]
    return values[b"scale"][0] / max(values[b"dim"])


def published(folder):
    """By instance: base in voxels and best height of voxel runs."""
    rows = csv.DictReader(open(folder / "best_known.csv", encoding="utf-8"))
    return {
        row["instance"]: (row["container_base_voxels_used_by_that_run"], row["best_height"])
        for row in rows
        if row["geometry"] == "voxel"
    }


def own_base(folder, name):
    for row in csv.DictReader(open(folder / "instances.csv", encoding="utf-8")):
        if row["instance"] == name and row["container_base_divided_by_voxel_size"]:
            return "x".join(str(math.floor(float(n) + 1e-6)) for n in row["container_base_divided_by_voxel_size"].split(" x "))
    return None


def main():
    arguments = sys.argv[1:]
    options = []
    if "--" in arguments:
        cut = arguments.index("--")
        arguments, options = arguments[:cut], arguments[cut + 1:]
    program, folder, names = arguments[0], pathlib.Path(arguments[1]), arguments[2:]
    known = published(folder)
    print("| instance | copies | base, voxels | height | published | seconds |")
    print("| --- | --- | --- | --- | --- | --- |")
    for instance in sorted((folder / "instances").glob("*.txt")):
        name = instance.stem
        if names and name not in names:
            continue
        base, best = known.get(name, (own_base(folder, name), "-"))
        if base is None:
            continue
        base = base.replace(" ", "")
        with tempfile.TemporaryDirectory() as scratch:
            set_file, packing = pathlib.Path(scratch) / "set.csv", pathlib.Path(scratch) / "packing.json"
            with open(set_file, "w", encoding="utf-8") as out:
                out.write("mesh,count,scale\n")
                for line in open(instance, encoding="utf-8"):
                    if line.startswith("#") or not line.strip():
                        continue
                    piece, copies = line.rstrip("\n").split("\t")
                    mesh = (folder / "data" / piece).resolve()
                    out.write(f'"{mesh}",{copies},{1 / voxel_size(mesh)!r}\n')
            subprocess.run(
                [program, "pack", set_file, "--open-height", "--tray", base, "--voxel", "1", "--gap", "0", "--progress",
                 "none", "-o", packing, *options],
                check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            done = json.load(open(packing, encoding="utf-8"))
        metrics = done["metrics"]
        left = "" if not done["unplaced"] else f" ({len(done['unplaced'])} left over)"
        print(f"| {name} | {metrics['copies']}{left} | {base} | {done['trays'][0]['height']:.4g} | {best} |"
              f" {metrics['seconds']['total']:.1f} |", flush=True)


main()
