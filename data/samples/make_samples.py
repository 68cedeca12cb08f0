#!/usr/bin/env python3
"""Makes the sample parts beside this script: the kind of thing that bureaus print, in millimetres.

Needs nothing but Python 3. Every part is one closed shell, outward oriented and free of self-intersections; that
each directed edge is met by its opposite and that the volume is positive is checked before anything is written.
Most are binary STL; nut.stl is ASCII and wedge.obj holds polygons, so that the samples touch every reader.
samples.csv names them with counts that fill a tray of about 160 x 120 x 100 mm.

The parts and this script are part of spectralpack and under its licence (Apache-2.0).
"""
import math
import pathlib
import struct
from collections import Counter

FOLDER = pathlib.Path(__file__).resolve().parent


# --- Vectors and loops -------------------------------------------------------------------------------------------
# A point is a tuple of three floats. A loop is a list of points, closed without repeating the first; seen from
# outside the part, a face's outer loop runs counter-clockwise and its holes clockwise.

def point(x, y, z):
    """Rounded, so that every machine writes the same bytes and equal points are equal."""
    return (round(x, 4) + 0.0, round(y, 4) + 0.0, round(z, 4) + 0.0)


def add(a, b, scale=1.0):
    return tuple(p + scale * q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def unit(a):
    size = math.sqrt(dot(a, a))
    return tuple(p / size for p in a)


def arc(cx, cy, radius, start, end, count):
    """Points in the plane from angle start to end (degrees), both included."""
    angles = [math.radians(start + (end - start) * i / (count - 1)) for i in range(count)]
    return [(cx + radius * math.cos(a), cy + radius * math.sin(a)) for a in angles]


def circle(cx, cy, radius, count, turn=0.0):
    return arc(cx, cy, radius, turn, turn + 360 * (count - 1) / count, count)


def rounded_rectangle(width, depth, radius, steps):
    """Round the origin, counter-clockwise."""
    x, y = width / 2 - radius, depth / 2 - radius
    corners = [(x, y, 0), (-x, y, 90), (-x, -y, 180), (x, -y, 270)]
    return [p for cx, cy, a in corners for p in arc(cx, cy, radius, a, a + 90, steps)]


def at_height(flat, z):
    return [point(x, y, z) for x, y in flat]


# --- Solids ------------------------------------------------------------------------------------------------------

class Solid:
    def __init__(self):
        self.triangles = []

    def face(self, outer, *holes):
        """A flat face."""
        self.triangles += triangulate(outer, holes)

    def tube(self, a, b):
        """The wall between two loops of equal length; outward if they run counter-clockwise seen from b's side."""
        for i in range(len(a)):
            j = (i + 1) % len(a)
            for triangle in ((a[i], a[j], b[j]), (a[i], b[j], b[i])):
                if len(set(triangle)) == 3:  # a loop may shrink to a point
                    self.triangles.append(triangle)

    def loft(self, loops, closed=False):
        """Walls through all loops in turn, ended by the first and the last as faces or by joining them."""
        for a, b in zip(loops, loops[1:] + loops[:1] if closed else loops[1:]):
            self.tube(a, b)
        if not closed:
            for end in (loops[0][::-1], loops[-1]):
                if len(set(end)) > 1:
                    self.face(end)

    def extrude(self, outer, holes, z0, z1):
        """outer counter-clockwise, holes clockwise, both in the plane."""
        low, high = [[at_height(loop, z) for loop in [outer, *holes]] for z in (z0, z1)]
        self.face(*[loop[::-1] for loop in low])
        self.face(*high)
        for a, b in zip(low, high):
            self.tube(a, b)

    def moved(self, move):
        """Every point through move(x, y, z), which must not mirror."""
        self.triangles = [tuple(point(*move(*p)) for p in t) for t in self.triangles]
        return self

    def volume(self):
        return sum(dot(a, cross(b, c)) for a, b, c in self.triangles) / 6

    def size(self):
        points = [p for t in self.triangles for p in t]
        return tuple(max(p[i] for p in points) - min(p[i] for p in points) for i in range(3))

    def check(self, name):
        edges = Counter((t[i], t[(i + 1) % 3]) for t in self.triangles for i in range(3))
        for (a, b), count in edges.items():
            assert a != b, f"{name}: a triangle without area at {a}"
            assert count == 1 and edges[(b, a)] == 1, f"{name}: not closed at {a} - {b}"
        assert self.volume() > 0, f"{name}: inside out"
        assert len(self.triangles) <= 2500, f"{name}: {len(self.triangles)} triangles"


def triangulate(outer, holes):
    """Ear clipping; holes are first joined to the outer loop by bridges."""
    normal = (0.0, 0.0, 0.0)
    for a, b in zip(outer, outer[1:] + outer[:1]):
        normal = add(normal, cross(a, b))
    normal = unit(normal)
    across = unit(cross((0, 1, 0) if abs(normal[1]) < 0.9 else (1, 0, 0), normal))
    along = cross(normal, across)
    flat = {p: (dot(p, across), dot(p, along)) for loop in (outer, *holes) for p in loop}

    def turn(a, b, c):
        (ax, ay), (bx, by), (cx, cy) = flat[a], flat[b], flat[c]
        return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)

    def crosses(a, b, c, d):
        return turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0

    ring = list(outer)
    waiting = sorted((list(h) for h in holes), key=lambda h: -max(flat[p][0] for p in h))
    while waiting:
        hole = waiting.pop(0)
        walls = [(l[i - 1], l[i]) for l in (ring, hole, *waiting) for i in range(len(l))]

        def reach(pair):
            a, b = flat[ring[pair[0]]], flat[hole[pair[1]]]
            return (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2

        pairs = sorted(((i, j) for i in range(len(ring)) for j in range(len(hole))), key=reach)
        i, j = next((i, j) for i, j in pairs
                    if not any(crosses(ring[i], hole[j], c, d) for c, d in walls))
        ring = ring[:i + 1] + hole[j:] + hole[:j + 1] + ring[i:]

    triangles = []
    while len(ring) > 3:
        best = None
        for i in range(len(ring)):
            a, b, c = ring[i - 1], ring[i], ring[(i + 1) % len(ring)]
            if turn(a, b, c) <= 1e-9:
                continue
            if any(p not in (a, b, c) and turn(a, b, p) >= 0 and turn(b, c, p) >= 0 and turn(c, a, p) >= 0
                   for p in ring):
                continue
            cut = sum((flat[a][k] - flat[c][k]) ** 2 for k in (0, 1))
            if best is None or cut < best[0]:
                best = (cut, i)
        i = best[1]
        triangles.append((ring[i - 1], ring[i], ring[(i + 1) % len(ring)]))
        del ring[i]
    return triangles + [tuple(ring)]


def sweep(path, radii, sides):
    """Round sections along a path in the xz plane, as loops. A radius of 0 is a tip."""
    loops = []
    for i, (x, z) in enumerate(path):
        before, after = path[max(0, i - 1)], path[min(len(path) - 1, i + 1)]
        heading = unit((after[0] - before[0], 0, after[1] - before[1]))
        aside = cross((0, 1, 0), heading)
        loops.append([point(*add(add((x, 0, z), aside, radii[i] * c), (0, 1, 0), radii[i] * s))
                      for c, s in circle(0, 0, 1, sides)])
    return loops


# --- Parts -------------------------------------------------------------------------------------------------------

def bracket():
    """Angle with two screw holes in each leg."""
    solid = Solid()
    width, long, tall, thick, radius = 32, 52, 40, 5, 3.2
    side = [(0, 0), (long, 0), (long, thick), (thick, thick), (thick, tall), (0, tall)]  # x, z
    solid.face([point(x, 0, z) for x, z in side])
    solid.face([point(x, width, z) for x, z in side][::-1])
    lying = [[point(x, y, z) for x, y in circle(cx, 16, radius, 20)] for cx in (22, 42) for z in (0, thick)]
    upright = [[point(x, y, z) for y, z in circle(cy, 28, radius, 20)] for cy in (9, 23) for x in (0, thick)]
    holes = {0: lying[0::2], 2: [h[::-1] for h in lying[1::2]],
             3: [h[::-1] for h in upright[1::2]], 5: upright[0::2]}
    for i, ((x0, z0), (x1, z1)) in enumerate(zip(side, side[1:] + side[:1])):
        wall = [point(x0, 0, z0), point(x0, width, z0), point(x1, width, z1), point(x1, 0, z1)]
        solid.face(wall, *holes.get(i, []))
    for low, high in zip(lying[0::2] + upright[0::2], lying[1::2] + upright[1::2]):
        solid.tube(low[::-1], high[::-1])
    return solid


def gear():
    """Spur gear, 22 teeth, with keyway and lightening holes."""
    teeth, root, tip = 22, 20.2, 25.0
    outer = []
    for i in range(teeth):
        for share, radius in ((-0.27, root), (-0.21, root + 1.2), (-0.10, tip), (0.10, tip), (0.21, root + 1.2),
                              (0.27, root)):
            a = 2 * math.pi * (i + share) / teeth
            outer.append((radius * math.cos(a), radius * math.sin(a)))
    key = 5 * math.sin(math.radians(25))
    holes = [arc(0, 0, 5, 25, 335, 24) + [(6.6, -key), (6.6, key)]]
    holes += [circle(x, y, 3.6, 18) for x, y in circle(0, 0, 12.8, 6, 30)]
    solid = Solid()
    solid.extrude(outer, [h[::-1] for h in holes], 0, 9)
    return solid


def hinge():
    """Half of a hinge: a plate with three holes and two knuckles for the pin."""
    solid = Solid()
    thick, long, knuckle, pin = 3.5, 34, 4.5, 2.1
    stations = [0, 12, 24, 36, 48]  # knuckles on the first and third stretch; seen in the xz plane, extruded along y
    plate = [(0, 0), (long, 0), (long, thick), (0, thick)]
    start = math.degrees(math.asin((thick - knuckle) / knuckle))
    reach = -math.sqrt(knuckle ** 2 - (thick - knuckle) ** 2)
    barrel = arc(reach, knuckle, knuckle, start, 270, 22)[1:]  # from (0, thick) round to below the pin
    barrel[-1] = (reach, 0)
    eye = circle(reach, knuckle, pin, 16)

    def loop(flat, y):
        return [point(x, y, z) for x, z in flat]

    spots = [(24, 8), (24, 24), (24, 40)]
    drilled = [[[point(x, y, z) for x, y in circle(cx, cy, 2.2, 16)] for cx, cy in spots] for z in (0, thick)]
    bottom = [point(*p) for p in [(0, y, 0) for y in stations] + [(long, y, 0) for y in stations[::-1]]]
    top = [(x, y, thick) for x, y, z in bottom]
    # The stretches with a knuckle have an edge less on the plate's near side: its wall leads on into the barrel.
    solid.face(bottom, *drilled[0])
    solid.face(top[::-1], *[h[::-1] for h in drilled[1]])
    for low, high in zip(*drilled):
        solid.tube(low[::-1], high[::-1])
    far = [p for p in bottom if p[0] == long]
    solid.face(far[::-1] + [(x, y, thick) for x, y, z in far])
    for i, (y0, y1) in enumerate(zip(stations, stations[1:])):
        if i % 2:
            solid.face(loop([(0, 0), (0, thick)], y0) + loop([(0, thick), (0, 0)], y1))
            continue
        around = [(0, thick)] + barrel + [(0, 0)]
        for a, b in zip(around, around[1:]):
            solid.face(loop([b, a], y0) + loop([a, b], y1))
        solid.tube(loop(eye, y0), loop(eye, y1))
    ends = {0: -1, 12: 1, 24: -1, 36: 1}  # y -> which way a knuckle's end looks
    knuckle_face = [(0, 0), (0, thick)] + barrel
    for y, way in ends.items():
        shape = plate + knuckle_face[2:] if y == 0 else knuckle_face
        outer, hole = loop(shape, y), loop(eye, y)[::-1]
        solid.face(*((outer, hole) if way < 0 else (outer[::-1], hole[::-1])))
    solid.face(loop(plate, 48)[::-1])
    return solid


def hook():
    """S-shaped hook."""
    wire = 3.2
    upper, lower = arc(11, 22, 11, 20, 180, 16), arc(-14, -22, 14, 0, -200, 20)
    path = upper + [(0, z) for z in (12, 0, -12)] + lower
    # Round ends: four steps of a hemisphere before and after.
    steps = [0, 0.35, 0.65, 0.87]

    def end(tip, inner):
        way = unit((tip[0] - inner[0], 0, tip[1] - inner[1]))
        bulge = [wire * math.sqrt(1 - s * s) for s in steps]
        return [((tip[0] + b * way[0], tip[1] + b * way[2]), wire * s) for b, s in zip(bulge, steps)]

    first, last = end(path[0], path[1]), end(path[-1], path[-2])[::-1]
    points = [p for p, _ in first] + path + [p for p, _ in last]
    radii = [r for _, r in first] + [wire] * len(path) + [r for _, r in last]
    solid = Solid()
    solid.loft(sweep(points, radii, 14))
    return solid


def ring():
    """Bangle: a torus."""
    solid = Solid()
    solid.loft([[point((21 + 4 * c) * x, (21 + 4 * c) * y, 4 * s) for x, y in circle(0, 0, 1, 48)]
                for c, s in circle(0, 0, 1, 16)], closed=True)
    return solid


def knob():
    """Drawer knob, turned, with a hole for the screw."""
    profile = [(2, 0), (8, 0), (8, 2), (5, 4), (4.5, 10), (6, 13)]
    profile += arc(6, 18.5, 5.5, -70, 90, 12) + [(0, 24), (0, 14), (2, 14)]
    solid = Solid()
    solid.loft([[point(r * x, r * y, z) for x, y in circle(0, 0, 1, 32)] for r, z in profile], closed=True)
    return solid


def box():
    """Thin-walled tray without a lid."""
    wall = 1.6
    outer = rounded_rectangle(62, 42, 7, 7)
    inner = rounded_rectangle(62 - 2 * wall, 42 - 2 * wall, 7 - wall, 7)
    solid = Solid()
    solid.loft([at_height(outer, 0), at_height(outer, 26), at_height(inner, 26), at_height(inner, wall)])
    return solid


def elbow():
    """Pipe bend with two flanges."""
    bend = arc(0, 0, 22, 180, 90, 12)
    path = [(-22, -14), (-22, -10), (-22, -10), *bend, (10, 22), (10, 22), (14, 22)]
    radii = [15, 15, 10.5] + [10.5] * len(bend) + [10.5, 15, 15]
    headings = [(0, 1)] * 3 + arc(0, 0, 1, 90, 0, len(bend)) + [(1, 0)] * 3

    def loops(radius_of):
        result = []
        for i, ((x, z), (hx, hz)) in enumerate(zip(path, headings)):
            aside = cross((0, 1, 0), (hx, 0, hz))
            result.append([point(*add(add((x, 0, z), aside, radius_of(i) * c), (0, 1, 0), radius_of(i) * s))
                           for c, s in circle(0, 0, 1, 24)])
        return result

    outside = loops(lambda i: radii[i])
    inside = [l for i, l in enumerate(loops(lambda i: 8.5)) if i not in (1, 2, len(path) - 3, len(path) - 2)]
    solid = Solid()
    solid.loft(outside + inside[::-1], closed=True)
    return solid


def clip():
    """Spring clip for a tube, with flared lips and a foot."""
    thick, inner = 2.4, 11.0
    opening = 48
    outside = arc(0, 0, inner + thick, 90 - opening, -60, 20)
    foot = [(7, -inner - thick - 3), (-7, -inner - thick - 3)]
    outside = outside + foot + [(-x, y) for x, y in outside[::-1]]
    inside = arc(0, 0, inner, 90 + opening, 90 - opening + 360, 40)
    lip = [(12.5, 16.6), (14.6, 15.4)]
    outline = inside + [lip[0], lip[1]] + outside + [(-lip[1][0], lip[1][1]), (-lip[0][0], lip[0][1])]
    solid = Solid()
    solid.extrude(outline[::-1], [], 0, 14)
    return solid.moved(lambda x, y, z: (x, -z, y))


def star_handle():
    """Clamping handle with five lobes and a through bore."""
    def lobes(scale):
        flat = []
        for i in range(60):
            a = 2 * math.pi * i / 60
            r = (19.5 + 4.2 * math.cos(5 * a)) * scale
            flat.append((r * math.cos(a), r * math.sin(a)))
        return flat

    neck, bore = circle(0, 0, 9, 60), circle(0, 0, 3, 60)
    loops = [at_height(neck, 0), at_height(neck, 9)]
    loops += [at_height(lobes(s), z)
              for s, z in ((0.86, 9), (0.96, 10.2), (1, 12), (1, 16), (0.96, 17.8), (0.86, 19))]
    loops += [at_height(bore, 19), at_height(bore, 0)]
    solid = Solid()
    solid.loft(loops, closed=True)
    return solid


def mug():
    """Mug; the handle grows out of the wall, where two patches of it are left open."""
    around, bends = 40, 10
    heights = [0, 7, 10, 13, 30, 33, 36, 42]
    outer = [at_height(circle(0, 0, 17 + 2.5 * h / 42, around), h) for h in heights]
    inner = [at_height(circle(0, 0, 17.6, around), 42), at_height(circle(0, 0, 15.2, around), 2.2)]
    solid = Solid()

    def patch(row):
        a, b, c = outer[row:row + 3]
        return [a[-1], a[0], a[1], b[1], c[1], c[0], c[-1], b[-1]]

    for row in range(len(heights) - 1):
        for i in range(around):
            j = (i + 1) % around
            if i in (around - 1, 0) and row in (1, 2, 4, 5):
                continue
            solid.triangles += [(outer[row][i], outer[row][j], outer[row + 1][j]),
                                (outer[row][i], outer[row + 1][j], outer[row + 1][i])]
    solid.face(outer[0][::-1])
    solid.tube(outer[-1], inner[0])
    solid.tube(inner[0], inner[1])
    solid.face(inner[1])

    # Sections of eight points lead from the lower patch round to the upper one, where up is down.
    section = [(-1, -1), (0, -1.15), (1, -1), (1.15, 0), (1, 1), (0, 1.15), (-1, 1), (-1.15, 0)]
    loops = [patch(1)]
    for i in range(bends):
        a = math.radians(-82 + 164 * i / (bends - 1))
        c, s = math.cos(a), math.sin(a)
        loops.append([point(22 + (12 - 2.3 * v) * c, 2.5 * u, 21.5 + (11.8 - 2.3 * v) * s) for u, v in section])
    upper = patch(4)
    loops.append([upper[i] for i in (6, 5, 4, 3, 2, 1, 0, 7)])
    for a, b in zip(loops, loops[1:]):
        solid.tube(a, b)
    return solid


def nut():
    """Hexagon nut without its thread."""
    solid = Solid()
    across, tall, chamfer = 24, 10, 1.2
    hexagon = circle(0, 0, across / math.sqrt(3), 6)
    bore, mouth = circle(0, 0, 7, 36)[::-1], circle(0, 0, 7 + chamfer, 36)[::-1]
    solid.face(at_height(hexagon, 0)[::-1], at_height(mouth, 0)[::-1])
    solid.face(at_height(hexagon, tall), at_height(mouth, tall))
    solid.tube(at_height(hexagon, 0), at_height(hexagon, tall))
    rings = [(mouth, 0), (bore, chamfer), (bore, tall - chamfer), (mouth, tall)]
    for (a, z0), (b, z1) in zip(rings, rings[1:]):
        solid.tube(at_height(a, z0), at_height(b, z1))
    return solid


def wedge_polygons():
    """Door stop; its corners and faces, for a format that holds polygons."""
    long, wide, tall, nose = 70, 26, 20, 3
    corners = [point(*p) for p in [(0, 0, 0), (long, 0, 0), (long, 0, nose), (0, 0, tall),
                                   (0, wide, 0), (long, wide, 0), (long, wide, nose), (0, wide, tall)]]
    return corners, [(0, 1, 2, 3), (5, 4, 7, 6), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)]


def frame():
    """The edges of a block as square bars."""
    size, bar = (44, 34, 34), 4.5
    solid = Solid()

    def square(axis, depth, inset):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        loop = []
        for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
            corner = [0.0, 0.0, 0.0]
            corner[axis] = depth
            corner[u] = size[u] - inset if a else inset
            corner[v] = size[v] - inset if b else inset
            loop.append(point(*corner))
        return loop

    for axis in range(3):
        for far in (False, True):
            face = square(axis, size[axis] if far else 0, 0)
            mouth = square(axis, size[axis] if far else 0, bar)
            deep = square(axis, size[axis] - bar if far else bar, bar)
            if far:
                solid.face(face, mouth[::-1])
                solid.tube(deep[::-1], mouth[::-1])
            else:
                solid.face(face[::-1], mouth)
                solid.tube(mouth[::-1], deep[::-1])
    return solid


# --- Files -------------------------------------------------------------------------------------------------------

def normal_of(triangle):
    a, b, c = triangle
    return unit(cross(add(b, a, -1), add(c, a, -1)))


def binary_stl(solid):
    data = struct.pack("<80sI", b"spectralpack sample, millimetres", len(solid.triangles))
    for triangle in solid.triangles:
        data += struct.pack("<12fH", *normal_of(triangle), *[x for p in triangle for x in p], 0)
    return data


def ascii_stl(solid, name):
    lines = [f"solid {name}"]
    for triangle in solid.triangles:
        lines += ["facet normal {:.6f} {:.6f} {:.6f}".format(*normal_of(triangle)), " outer loop"]
        lines += ["  vertex {:g} {:g} {:g}".format(*p) for p in triangle]
        lines += [" endloop", "endfacet"]
    return ("\n".join(lines + [f"endsolid {name}"]) + "\n").encode()


def obj(corners, faces):
    lines = ["# spectralpack sample, millimetres", "o wedge"]
    lines += ["v {:g} {:g} {:g}".format(*p) for p in corners]
    lines += ["f " + " ".join(str(i + 1) for i in face) for face in faces]
    return ("\n".join(lines) + "\n").encode()


COUNTS = {"bracket": 5, "gear": 5, "hinge": 6, "hook": 6, "ring": 6, "knob": 8, "box": 3, "elbow": 3, "clip": 8,
          "star_handle": 4, "mug": 3, "nut": 10, "wedge": 4, "frame": 3}


def main():
    rows = ["mesh,count,scale"]
    total = 0
    for make in (bracket, gear, hinge, hook, ring, knob, box, elbow, clip, star_handle, mug, nut, wedge_polygons,
                 frame):
        name = make.__name__.split("_poly")[0]
        if make is wedge_polygons:
            corners, faces = make()
            solid = Solid()
            for face in faces:
                solid.face([corners[i] for i in face])
            file, data = f"{name}.obj", obj(corners, faces)
        else:
            solid = make()
            file, data = f"{name}.stl", ascii_stl(solid, name) if make is nut else binary_stl(solid)
        solid.check(name)
        (FOLDER / file).write_bytes(data)
        rows.append(f"{file},{COUNTS[name]},1")
        total += COUNTS[name] * solid.volume()
        size = " x ".join(f"{s:.1f}" for s in solid.size())
        print(f"{file:16} {len(solid.triangles):5} triangles, {size} mm, {solid.volume() / 1000:.2f} cm3,"
              f" {len(data)} bytes")
    (FOLDER / "samples.csv").write_text("\n".join(rows) + "\n")
    print(f"samples.csv: {sum(COUNTS.values())} copies, {total / 1000:.0f} cm3")


if __name__ == "__main__":
    main()
