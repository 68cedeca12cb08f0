#!/usr/bin/env python3
"""Writes the letters of SIGGRAPH as closed meshes of 322 x 322 x 80 mm, for use as containers.

    bench/letters.py FOLDER
"""

import struct
import sys
from pathlib import Path

SIDE, HEIGHT = 322.0, 80.0
LETTERS = {
    "S": "XXXXXXX XXXXXXX XX..... XXXXXXX .....XX XXXXXXX XXXXXXX",
    "I": "XXXXXXX ..XXX.. ..XXX.. ..XXX.. ..XXX.. ..XXX.. XXXXXXX",
    "G": "XXXXXXX XXXXXXX XX..... XX.XXXX XX...XX XXXXXXX XXXXXXX",
    "R": "XXXXXXX XXXXXXX XX...XX XXXXXXX XXXXX.. XX.XXX. XX..XXX",
    "A": "XXXXXXX XXXXXXX XX...XX XXXXXXX XXXXXXX XX...XX XX...XX",
    "P": "XXXXXXX XXXXXXX XX...XX XXXXXXX XXXXXXX XX..... XX.....",
    "H": "XX...XX XX...XX XXXXXXX XXXXXXX XXXXXXX XX...XX XX...XX",
}


def facets(rows):
    """Triangles of the cells' outer faces; cells are squares, row 0 at the back."""
    cell = SIDE / len(rows)
    filled = {(x, len(rows) - 1 - y) for y, row in enumerate(rows) for x, c in enumerate(row) if c == "X"}
    for x, y in filled:
        low, high = (x * cell, y * cell), ((x + 1) * cell, (y + 1) * cell)
        corners = [(high[0] if i & 1 else low[0], high[1] if i & 2 else low[1], HEIGHT if i & 4 else 0.0) for i in range(8)]
        faces = [(0, 2, 3, 1), (4, 5, 7, 6)]
        for step, face in {(0, -1): (0, 1, 5, 4), (0, 1): (2, 6, 7, 3), (-1, 0): (0, 4, 6, 2), (1, 0): (1, 3, 7, 5)}.items():
            if (x + step[0], y + step[1]) not in filled:
                faces.append(face)
        for a, b, c, d in faces:
            yield corners[a], corners[b], corners[c]
            yield corners[a], corners[c], corners[d]


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for letter, text in LETTERS.items():
        triangles = list(facets(text.split()))
        with open(folder / f"{letter}.stl", "wb") as out:
            out.write(b"letter, millimetres".ljust(80) + struct.pack("<I", len(triangles)))
            for triangle in triangles:
                out.write(struct.pack("<12fH", 0, 0, 0, *(c for corner in triangle for c in corner), 0))


if __name__ == "__main__":
    main()
