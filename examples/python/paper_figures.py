"""The paper's figures 2 and 3 anew: where a part collides, and how near it comes to what stands.

Needs matplotlib and a build with the reference engine. paper_figures.py [OUT_FOLDER]
"""

from __future__ import annotations

import importlib
import pathlib
import sys

import numpy as np
import numpy.typing as npt

import spectralpack as sp


def cut(field: npt.NDArray[np.int64], y: int) -> npt.NDArray[np.float64]:
    """Across y, z upwards; what is below 0 is left blank."""
    values = field[:, y, :].T.astype(float)
    values[values < 0] = np.nan
    return values


def main() -> None:
    importlib.import_module("matplotlib").use("Agg")
    pyplot = importlib.import_module("matplotlib.pyplot")
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    pieces = sp.generate("polyhedra", seed=3)
    tray = sp.Tray((90, 40, 60), voxel=1)
    for _, mesh, count in pieces[1:]:
        shape = tray.shape(mesh, "90")
        for _ in range(count // 2):
            best = tray.best_placement(shape)
            if best:
                tray.add(shape, best)
    part = tray.shape(pieces[0][1], "none")
    collision, proximity = tray.metric_fields(part, 0)
    y = collision.shape[1] // 2
    stands = tray.occupied()[:, y + part.voxels(0).shape[1] // 2, :].T
    for name, field, title in [("collision", collision, "collision ζ (equation 2)"),
                               ("proximity", np.where(collision == 0, proximity, -1), "proximity ρ (equation 4), where free")]:
        figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4), constrained_layout=True)
        left.imshow(stands, origin="lower", cmap="Greys")
        left.set_title("what stands, cut through the middle of the part")
        picture = right.imshow(cut(field, y), origin="lower", cmap="viridis")
        right.set_title(title)
        right.set_xlabel("x of q")
        right.set_ylabel("z of q")
        figure.colorbar(picture, ax=right)
        path = folder / f"{name}.png"
        figure.savefig(path, dpi=120)
        print("written:", path)


if __name__ == "__main__":
    main()
