#!/usr/bin/env python3
"""What the way through Python costs: the same job by the command line and by the package, in turn; and importing it.

    PYTHONPATH=build/python bench/python_cost.py build/apps/cli/spectralpack SET.csv MESH_DIR [RUNS]
"""
import statistics
import subprocess
import sys
import time

import spectralpack as sp

OPTIONS = {"tray": (480, 245, 200), "voxel": 4}


def seconds(work):
    begun = time.perf_counter()
    work()
    return time.perf_counter() - begun


def median(values):
    return statistics.median(values)


def main():
    program, parts, mesh_dir = sys.argv[1:4]
    runs = int(sys.argv[4]) if len(sys.argv) > 4 else 7
    command = [program, "pack", parts, "--mesh-dir", mesh_dir, "--tray", "480x245x200", "--voxel", "4", "--json",
               "--progress", "none"]
    by_program, by_package, inside = [], [], []
    for _ in range(runs):
        by_program.append(seconds(lambda: subprocess.run(command, check=True, capture_output=True)))

        def pack():
            packing = sp.pack(sp.Job.from_files(parts, mesh_dir=mesh_dir, **OPTIONS), progress=lambda _: None)
            inside.append(packing.metrics["seconds"]["total"])

        by_package.append(seconds(pack))
    imports = {name: median([seconds(lambda: subprocess.run([sys.executable, "-c", f"import {name}"], check=True)) for _ in range(runs)])
               for name in ("sys", "numpy", "spectralpack")}
    print(f"command line {median(by_program):.3f} s, package {median(by_package):.3f} s "
          f"(ratio {median(by_package) / median(by_program):.3f}; of which packing {median(inside):.3f} s)")
    print("import: " + ", ".join(f"{name} {imports[name] - imports['sys']:.3f} s" for name in ("numpy", "spectralpack")))


if __name__ == "__main__":
    import warnings

    warnings.simplefilter("ignore", sp.Remark)
    main()
