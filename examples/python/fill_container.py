"""Fills a letter with as many small parts as fit: fill_container.py [OUT_FOLDER]"""

from __future__ import annotations

import pathlib
import sys
import tempfile

import numpy as np

import spectralpack as sp


def write_stl(mesh: sp.Mesh, path: pathlib.Path) -> None:
    """A binary STL."""
    corners = mesh.vertices[mesh.faces].astype("<f4")
    facets = np.zeros(len(corners), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attributes", "<u2")])
    facets["corners"] = corners
    path.write_bytes(bytes(80) + np.uint32(len(facets)).tobytes() + facets.tobytes())


def main() -> None:
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    letters = {name: mesh for name, mesh, _ in sp.generate("letters")}
    with tempfile.TemporaryDirectory() as scratch:
        container = pathlib.Path(scratch) / "S.stl"
        write_stl(letters["letter-S"], container)
        job = sp.Job(container=container, voxel=4, fill=True)
        for name, mesh, count in sp.generate("pieces", seed=2)[:6]:
            job.add(mesh, count=count, name=name)
        packing = sp.pack(job, progress=True)
        print(f"{packing.placed} copies in the letter, {100 * packing.density:.1f} % filled")
        print("written:", packing.save(folder / "letter.png")[0])


if __name__ == "__main__":
    main()
