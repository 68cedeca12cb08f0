"""Packs meshes from memory and writes a 3MF and a picture: pack_meshes.py [OUT_FOLDER]

Takes primitives of trimesh where that is installed, generated parts otherwise.
"""

from __future__ import annotations

import importlib
import pathlib
import random
import sys
from typing import Any, Callable

import spectralpack as sp


def parts(count: int) -> list[tuple[str, Any]]:
    try:
        trimesh = importlib.import_module("trimesh")
    except ImportError:
        return [(name, mesh) for name, mesh, _ in sp.generate("pieces", seed=7)[:count]]
    chance = random.Random(7)
    makers: list[Callable[[], Any]] = [
        lambda: trimesh.creation.box((chance.uniform(5, 40), chance.uniform(5, 40), chance.uniform(5, 40))),
        lambda: trimesh.creation.cylinder(chance.uniform(3, 15), chance.uniform(5, 50)),
        lambda: trimesh.creation.torus(chance.uniform(12, 25), chance.uniform(2, 5)),
    ]
    return [(f"part {i + 1}", makers[i % len(makers)]()) for i in range(count)]


def main() -> None:
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    job = sp.Job(tray=(200, 150, 100), gap=1.0)
    for name, mesh in parts(12):
        job.add(mesh, count=4, name=name)
    packing = sp.pack(job, progress=True)
    print(f"{packing.placed} copies placed, {100 * packing.density:.1f} % filled, {packing.height:.1f} mm high")
    report = packing.check()
    plan = packing.plan
    print("sound" if report.ok else report.findings, "and", "comes apart" if plan and plan.complete else "holds itself")
    for path in packing.save(folder / "build.3mf") + packing.save(folder / "build.png"):
        print("written:", path)


if __name__ == "__main__":
    main()
