#!/usr/bin/env python3
"""Draws search_bench --trace output as an SVG: milliseconds a search against objects placed, running medians.

    plot_trace.py OUT.svg NAME=TRACE [NAME=TRACE ...]
"""
import math
import statistics
import sys

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 720, 400, 64, 16, 16, 44
COLOURS = ["#1f6f8b", "#c8553d", "#5b8c3e", "#6c4f9e"]
WINDOW = 15
POINTS = 500


def read(path):
    times = []
    with open(path) as lines:
        for line in lines:
            words = line.split()
            if len(words) == 4 and words[0].isdigit():
                times.append(float(words[3]))
    return [statistics.median(times[max(0, i - WINDOW):i + WINDOW + 1]) for i in range(len(times))]


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    series = [(word.rsplit("=", 1)[0], read(word.rsplit("=", 1)[1])) for word in sys.argv[2:]]
    most = max(len(times) for _, times in series)
    low = math.floor(math.log10(min(min(times) for _, times in series)))
    high = math.ceil(math.log10(max(max(times) for _, times in series)))

    def place(i, value):
        x = LEFT + (WIDTH - LEFT - RIGHT) * i / max(1, most - 1)
        y = TOP + (HEIGHT - TOP - BOTTOM) * (high - math.log10(value)) / (high - low)
        return x, y

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="12">',
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>']
    for power in range(low, high + 1):
        _, y = place(0, 10.0 ** power)
        out.append(f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>')
        out.append(f'<text x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{10.0 ** power:g}</text>')
    for k in range(5):
        i = round(k * (most - 1) / 4)
        x, _ = place(i, 10.0 ** low)
        out.append(f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 16}" text-anchor="middle">{i}</text>')
    out.append(f'<text x="{WIDTH / 2}" y="{HEIGHT - 8}" text-anchor="middle">searches</text>')
    out.append(f'<text x="14" y="{HEIGHT / 2}" text-anchor="middle" transform="rotate(-90 14 {HEIGHT / 2})">ms a search</text>')
    for k, (name, times) in enumerate(series):
        step = max(1, len(times) // POINTS)
        points = " ".join(f"{x:.1f},{y:.1f}" for x, y in (place(i, times[i]) for i in range(0, len(times), step)))
        colour = COLOURS[k % len(COLOURS)]
        out.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
        out.append(f'<text x="{WIDTH - RIGHT - 8}" y="{TOP + 16 * (k + 1)}" text-anchor="end" fill="{colour}">{name}</text>')
    out.append("</svg>\n")
    with open(sys.argv[1], "w") as file:
        file.write("\n".join(out))


main()
