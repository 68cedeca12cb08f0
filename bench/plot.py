#!/usr/bin/env python3
"""Draws what search_bench and improve.py tell as an SVG.

    plot.py trace OUT.svg NAME=TRACE [NAME=TRACE ...]    milliseconds a search against objects placed, running medians
                                                         (traces of search_bench --trace)
    plot.py volume OUT.svg NAME=LINES [NAME=LINES ...]   the mean of a run against the voxels of its tray (a file of
                                                         search_bench's lines, one for each tray)
    plot.py curve OUT.svg JOB=CSV [JOB=CSV ...]          height against seconds of --improve (improve.py --curve)
"""
import csv
import math
import re
import statistics
import sys

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 720, 400, 64, 16, 16, 44
COLOURS = ["#1f6f8b", "#c8553d", "#5b8c3e", "#6c4f9e"]
WINDOW = 15
POINTS = 500
MARKS = [float(f"{digit}e{power}") for power in range(-3, 7) for digit in (1, 2, 5)]


def read_trace(path):
    times = []
    with open(path) as lines:
        for line in lines:
            words = line.split()
            if len(words) == 4 and words[0].isdigit():
                times.append(float(words[3]))
    medians = [statistics.median(times[max(0, i - WINDOW):i + WINDOW + 1]) for i in range(len(times))]
    return [(i, medians[i]) for i in range(0, len(medians), max(1, len(medians) // POINTS))]


def read_lines(path):
    line_of_run = re.compile(r"tray (\d+)x(\d+)x(\d+) voxels.* (\d+) searches.* search ([\d.]+) s")
    points = []
    with open(path) as lines:
        for found in filter(None, map(line_of_run.search, lines)):
            x, y, z, searches = map(int, found.groups()[:4])
            points.append((x * y * z / 1e6, 1e3 * float(found.group(5)) / searches))
    return sorted(points)


def read_curve(path, job):
    """Stairs, from a second on: what is best stays so until something is better."""
    points = []
    with open(path) as text:
        rows = [row for row in csv.DictReader(text) if row["job"] == job]
    for row in rows:
        second = max(1, float(row["second"]) - float(rows[0]["second"]))
        if points:
            points.append((second, points[-1][1]))
        points.append((second, float(row["now"])))
    return points


class Axis:
    """Maps values to pixels, from..to, by their logarithms or not."""

    def __init__(self, values, from_pixel, to_pixel, logarithmic):
        self.log = logarithmic
        self.low, self.high = min(values), max(values)
        if logarithmic:
            self.low = max(mark for mark in MARKS if mark <= self.low)
            self.high = min(mark for mark in MARKS if mark >= self.high)
        self.from_pixel, self.to_pixel = from_pixel, to_pixel

    def pixel(self, value):
        low, high, at = (math.log10(v) if self.log else v for v in (self.low, self.high, value))
        return self.from_pixel + (self.to_pixel - self.from_pixel) * (at - low) / max(1e-9, high - low)

    def ticks(self):
        if self.log:
            marks = [mark for mark in MARKS if self.low <= mark <= self.high]
            return marks if len(marks) <= 8 else [mark for mark in marks if math.log10(mark) % 1 == 0]
        return [round(self.low + (self.high - self.low) * k / 4) for k in range(5)]


def draw(path, series, x_label, logarithmic_x, y_label="ms a search", logarithmic_y=True):
    points = [point for _, line in series for point in line]
    x_axis = Axis([x for x, _ in points], LEFT, WIDTH - RIGHT, logarithmic_x)
    y_axis = Axis([y for _, y in points], HEIGHT - BOTTOM, TOP, logarithmic_y)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="12">',
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>']
    for value in y_axis.ticks():
        y = y_axis.pixel(value)
        out.append(f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>')
        out.append(f'<text x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{value:g}</text>')
    for value in x_axis.ticks():
        out.append(f'<text x="{x_axis.pixel(value):.1f}" y="{HEIGHT - BOTTOM + 16}" text-anchor="middle">{value:g}</text>')
    out.append(f'<text x="{WIDTH / 2}" y="{HEIGHT - 8}" text-anchor="middle">{x_label}</text>')
    out.append(f'<text x="14" y="{HEIGHT / 2}" text-anchor="middle" transform="rotate(-90 14 {HEIGHT / 2})">{y_label}</text>')
    for k, (name, line) in enumerate(series):
        colour = COLOURS[k % len(COLOURS)]
        pixels = " ".join(f"{x_axis.pixel(x):.1f},{y_axis.pixel(y):.1f}" for x, y in line)
        out.append(f'<polyline points="{pixels}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
        out.append(f'<text x="{WIDTH - RIGHT - 8}" y="{TOP + 16 * (k + 1)}" text-anchor="end" fill="{colour}">{name}</text>')
    out.append("</svg>\n")
    with open(path, "w") as file:
        file.write("\n".join(out))


def main():
    kinds = {"trace": (read_trace, "searches", False), "volume": (read_lines, "million voxels of the tray", True)}
    if len(sys.argv) < 4 or sys.argv[1] not in (*kinds, "curve"):
        sys.exit(__doc__)
    named = [word.rsplit("=", 1) for word in sys.argv[3:]]
    if sys.argv[1] == "curve":
        series = [(name, read_curve(path, name)) for name, path in named]
        return draw(sys.argv[2], series, "seconds of --improve", True, "height, mm", False)
    read, label, logarithmic_x = kinds[sys.argv[1]]
    draw(sys.argv[2], [(name, read(path)) for name, path in named], label, logarithmic_x)


main()
