"""A strategy of one's own on top of the search: the best of many random orders, by height.

Each copy goes to the position of least height, then of least proximity (equation 4 of the paper); whole orders are
compared by the height they come to. order_search.py [ORDERS]
"""

from __future__ import annotations

import random
import sys

import spectralpack as sp

TRAY = (90.0, 90.0, 300.0)
VOXEL = 2.0


def height_of(order: list[sp.Mesh], shapes: dict[int, sp.Shape], tray: sp.Tray) -> float:
    """Packs in that order into the empty tray, and empties it again."""
    copies = []
    top = 0.0
    for mesh in order:
        best = tray.best_placement(shapes[id(mesh)], height_at="top")
        if best is None:
            top = float("inf")
            break
        copies.append(tray.add(shapes[id(mesh)], best))
        top = max(top, float((mesh.vertices @ best.transform[2, :3] + best.transform[2, 3]).max()))
    for copy in copies:
        tray.remove(copy)
    return top


def main() -> None:
    orders = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    meshes = [mesh for _, mesh, count in sp.generate("tori", seed=1, copies=12) for _ in range(count)]
    tray = sp.Tray(TRAY, voxel=VOXEL)
    shapes = {id(mesh): tray.shape(mesh, "90") for mesh in meshes}
    chance = random.Random(1)
    order = sorted(meshes, key=lambda mesh: -mesh.volume)
    best = height_of(order, shapes, tray)
    print(f"by volume: {best:.1f} mm")
    for i in range(orders):
        chance.shuffle(order)
        height = height_of(order, shapes, tray)
        if height < best:
            best = height
            print(f"order {i + 1}: {best:.1f} mm")


if __name__ == "__main__":
    main()
