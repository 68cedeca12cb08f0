#!/usr/bin/env python3
"""Makes docs/benchmarks.md, and the tables of README.md and docs/reliability.md, from bench/results/*.csv.

    figures.py            writes them
    figures.py --check    writes nothing; names what is not up to date and exits with 1

Values are medians of all runs of one commit on one machine: those of the last row of a set. Sets that sets.csv does not
have yet come from published.csv, which keeps older figures; its `recorded_in` is the commit that brought them into the
documents. In README.md and docs/reliability.md only what is between the markers is replaced.
"""
import collections
import pathlib
import re
import statistics
import sys

from measured import ROOT, rows_of

RESULTS = ROOT / "bench" / "results"
BEGIN, END = "<!-- figures: begin -->", "<!-- figures: end -->"


# Values of rows

def results(name):
    return rows_of(RESULTS / f"{name}.csv")


def key_of_run(row):
    return row.get("commit", ""), row.get("machine", "")


def newest(rows):
    """Of one set: the rows of the same commit and machine as the last."""
    return [row for row in rows if key_of_run(row) == key_of_run(rows[-1])]


def grouped(rows, *keys):
    groups = collections.OrderedDict()
    for row in rows:
        groups.setdefault(tuple(row[key] for key in keys), []).append(row)
    return groups


def median(rows, field):
    values = [float(row[field]) for row in rows if row.get(field)]
    return statistics.median(values) if values else None


def merged(rows):
    """One row of all runs: medians of numbers, how many runs, and whether all were found sound."""
    one = dict(rows[-1])
    for field in one:
        if field.startswith("seconds") or field in ("density", "height", "placed", "memory_mb"):
            one[field] = median(rows, field)
    one["runs"] = sum(int(row.get("runs") or 1) for row in rows)
    one["ok"] = "no" if any(row.get("ok") == "no" for row in rows) else rows[-1].get("ok", "")
    return one


def suite(name):
    """Rows of a suite by set, medians; where sets.csv has none of a set, what was published."""
    published = grouped([row for row in results("published") if row["suite"] == name], "set", "options")
    measured = grouped([row for row in results("sets") if row["suite"] == name], "set")
    known = {name_of_set for name_of_set, in measured}
    rows = {}
    for (name_of_set, options), group in published.items():
        if name_of_set not in known:
            rows[name_of_set, options] = merged(newest(group))
    for (name_of_set,), group in measured.items():
        rows[name_of_set, ""] = merged(newest(group))
    order = ["mixtures", "pieces", "locks", "quick", "thousand", "sixthousand"]
    return sorted(rows.values(), key=lambda row: order.index(row["set"]) if row["set"] in order else len(order))


def by_option(name, option):
    """Rows of a suite of published.csv: set: value of --option: row."""
    rows = collections.OrderedDict()
    for row in results("published"):
        if row["suite"] == name:
            found = re.search(rf"--{option}(?: (\S+)|$)", row["options"])
            rows.setdefault(row["set"], {})[found.group(1) if found else None] = merged([row])
    return rows


# Cells

def number(value, digits=1):
    return "–" if value in (None, "") else f"{float(value):,.{digits}f}"


def count(value):
    return number(value, 0)


def percent(value, digits=1):
    return "–" if value in (None, "") else f"{100 * float(value):.{digits}f} %"


def millimetres(value):
    return "–" if value in (None, "") else f"{float(value):.1f} mm"


def duration(value):
    if value in (None, ""):
        return "–"
    value = float(value)
    if value < 1:
        return f"{value:.2f} s"
    if value < 20:
        return f"{value:.1f} s"
    return f"{value:.0f} s" if value < 120 else f"{int(value) // 60} min {int(value) % 60} s"


def time_of(row):
    """Of the whole run by the clock; where only the processor's time is known, that, and so marked."""
    if row.get("seconds_total") not in (None, ""):
        return duration(row["seconds_total"])
    return f"{duration(row['seconds_cpu'])} cpu" if row.get("seconds_cpu") not in (None, "") else "–"


def code(text):
    return f"`{text}`" if text else "defaults"


def table(titles, rows):
    lines = ["| " + " | ".join(titles) + " |", "| " + " | ".join("---" for _ in titles) + " |"]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


# What stands under a table

def listed(words):
    words = list(dict.fromkeys(words))
    return words[0] if len(words) == 1 else ", ".join(words[:-1]) + " and " + words[-1]


def one_command(commands):
    """Commands that differ in the name of the set alone are shown as one with SET."""
    commands = list(dict.fromkeys(filter(None, commands)))
    general = list(dict.fromkeys(re.sub(r"(DATA/sets/)\w+\.csv", r"\1SET.csv", command) for command in commands))
    return "; ".join(f"`{command}`" for command in (general if len(general) < len(commands) else commands))


def runs_of(rows):
    if any(row.get("runs") == "" for row in rows):
        return "number of runs not noted"
    runs = sorted({int(row.get("runs", 1)) for row in rows})
    return f"{runs[0]} to {runs[-1]} runs" if len(runs) > 1 else "1 run" if runs[0] == 1 else f"{runs[0]} runs"


def commits_of(rows):
    commits = [row["commit"] for row in rows if row.get("commit")]
    noted = [f"commit {listed(commits)}"] if commits else []
    others = [row["recorded_in"] for row in rows if not row.get("commit")]
    return "; ".join(noted + ([f"commit not noted, recorded in {listed(others)}"] if others else []))


def source(rows, name="set"):
    """Command, machine, commit and runs of what is in a table."""
    groups = grouped(rows, "machine")
    names = {machine: listed(str(row[name]) for row in group) for machine, group in groups.items()}
    most = max(groups, key=lambda machine: len(groups[machine]))
    parts = []
    for machine, group in groups.items():
        which = "" if len(set(names.values())) == 1 else "all others" if machine == most else names[machine]
        if len(group) == 1 and group[0].get("options"):
            which = f"{which} `{group[0]['options']}`".strip()
        parts.append(f"{machine[0]}{f' ({which})' if which and len(groups) > 1 else ''}; {commits_of(group)}; {runs_of(group)}")
    lines = [f"Command: {one_command(row.get('command') for row in rows)}.", f"Measured on: {'. '.join(parts)}."]
    checks = [row.get("ok") for row in rows if row.get("ok")]
    if checks:
        wrong = [row[name] for row in rows if row.get("ok") == "no"]
        lines.append(f"**`check` found fault with {listed(wrong)}.**" if wrong else "`check` found nothing wrong.")
    return " ".join(lines)


def section(heading, text, *parts):
    return "\n\n".join([f"## {heading}", text.strip(), *parts])


# Sections

ABOUT = {
    "mixtures": "286 parts, large and small",
    "pieces": "1,446 small parts",
    "locks": "468 rings, hooks and frames",
    "thousand": "1,000 parts, as many trays as it takes",
    "sixthousand": "6,596 parts, as many trays as it takes",
    "quick": "40 parts in a tray of 160×120×100 mm",
}
MEANS = {
    "mixtures": "small parts fill the room between large ones",
    "pieces": "you can pack again whenever an order comes in",
    "locks": "open shapes pack loosely, and some would lock",
    "thousand": "one run plans the whole week",
}


def placed_of(row):
    if int(row["trays"]) > 1:
        all_placed = float(row["placed"]) == float(row["copies"])
        return f"{'all' if all_placed else count(row['placed'])}, {row['trays']} trays"
    return f"{count(row['placed'])} of {count(row['copies'])}"


def defaults():
    rows = suite("default")
    cells = [[row["set"], ABOUT[row["set"]], placed_of(row), percent(row["density"]), time_of(row),
              duration(row["seconds_search"]), duration(row["seconds_refine"]), duration(row["seconds_disassemble"])]
             for row in rows]
    return section("Whole runs with the defaults", """
The tray is 480×245×200 mm where nothing else is said. *Density* is the volume of the parts divided by that of the tray; of
several trays it is the mean. The whole run is the program by the clock: reading, packing, the plan, writing. Three sets
overflow their tray, so "placed" says how full it gets. *locks* is the hardest set: it fills a fifth of the tray.
""", table(["set", "parts", "placed", "density", "whole run", "search", "refining", "taking apart"], cells), source(rows))


def small():
    rows = suite("small")
    if not rows:
        return ""
    cells = [[row["set"], code(row["options"]), placed_of(row), percent(row["density"]), millimetres(row["height"]),
              time_of(row)] for row in rows]
    return section("Sets that anyone can pack", """
The samples of the repository, and sets that `spectralpack generate` makes. The same seed makes the same files on every
machine. Compare your own machine with these rows: `bench/sets.py PROGRAM --only small`.
""", table(["set", "options", "placed", "density", "height", "whole run"], cells), source(rows))


def bare_search():
    rows = suite("search")
    cells = [[row["set"], placed_of(row), percent(row["density"]), time_of(row), duration(row["seconds_search"])]
             for row in rows]
    return section("The bare search", """
No gap, collisions on voxels of 2 mm, no refining, no plan. This is the setting of the paper's method alone. It shows
what the rest of a run costs: plan, gap and finer voxels take more than the search.
""", table(["set", "placed", "density", "whole run", "of it search"], cells), source(rows))


def voxels():
    coarse = by_option("detail", "detail")
    rows = by_option("interlock", "interlock")
    of_size = {size: [row for row in results("published") if row["suite"] == "interlock" and "post" in row["options"] and
                      f"--voxel {size}" in row["options"]] for size in ("2", "1")}
    cells, used = [], []
    for name in rows:
        line = [coarse[name]["1"]] + [merged([r for r in of_size[size] if r["set"] == name]) for size in ("2", "1")]
        used += line
        cells.append([name] + [f"{count(row['placed'])}, {percent(row['density'])}, {time_of(row)}" for row in line])
    return section("Finer voxels", """
Each cell has the copies placed, the density and the whole run. `--detail 2`, the default, decides collisions on voxels half
as large. Half the voxel size brings one to two points of density in a tray that overflows, and takes four to six times as
long. The fixed sets [below](#what-a-plan-costs) gain nothing to 6 % of their height.
""", table(["set", "`--detail 1`, 2 mm", "defaults, 2 mm", "`--voxel 1`"], cells), source(used))


def refining():
    cells, used = [], []
    tray = grouped([row for row in results("published") if row["suite"] == "refine"], "set")
    fixed = grouped([row for row in results("published") if row["suite"] == "refine fixed"], "set")
    for name, rows in tray.items():
        off, on = ([merged([row for row in group if ("no-refine" in row["options"]) == without][:1])
                    for group in (rows, fixed[name])] for without in (True, False))
        used += [off[0], on[0]]
        cells.append([name[0], *(f"{count(a['placed'])}, {percent(a['density'])}, {time_of(a)}" for a in (off[0], on[0])),
                      *(millimetres(a["height"]) for a in (off[1], on[1]))])
    return section("Refining", """
Refining moves copies off the grid until they touch. It lowers fixed sets by up to 4 %. In a tray that overflows it changes
which copies get in: *mixtures* places more of them and is half a point less dense.
""", table(["set", "`--no-refine`", "refined (default)", "fixed set: `--no-refine`", "refined"], cells), source(used))


def interlocking():
    cells, used = [], []
    fixed = {(row["set"], row["options"]): row for row in results("published") if row["suite"] == "interlock fixed"}
    for (name,), rows in grouped([row for row in results("published") if row["suite"] == "interlock"], "set").items():
        for size in ("2", "1"):
            line = [next(row for row in rows if row["options"] == f"--voxel {size} --interlock {mode}")
                    for mode in ("off", "post", "place")]
            used += line
            cells.append([name, f"{size} mm", *(f"{count(row['placed'])}, {percent(row['density'])}, {time_of(row)}; "
                                                f"{millimetres(fixed[name, row['options']]['height'])}" for row in line)])
    return section("What a plan costs", """
`post`, the default, packs so that every copy comes out, and finds the plan. `off` looks at none of this. `place` asks for a
way out of each copy as it is placed. Behind the semicolon: the height of the fixed set (the first 500, 120 and 150 copies, no
ceiling). A plan costs no density on *pieces*, at most 0.9 points on *mixtures* and 1.2 on *locks*. `place` is slower and packs
less, always. Disappointing: the fixed *mixtures* come out 4 % higher with a plan, at 1 mm 13 %.
""", table(["set", "voxel", "`off`", "`post`", "`place`"], cells), source(used))


def turns():
    cells, used = [], []
    fixed = {(row["set"], row["options"]): row for row in results("published") if row["suite"] == "turns fixed"}
    for (name,), rows in grouped([row for row in results("published") if row["suite"] == "turns"], "set").items():
        used += rows
        cells.append([name, *(f"{count(row['placed'])}, {percent(row['density'])}, {duration(row['seconds_cpu'])} cpu; "
                              f"{millimetres(fixed[name, row['options']]['height'])}" for row in rows)])
    return section("Finer turns", """
Steps of 90° are 24 ways to stand, 45° 208, 30° 744. 45° fills *pieces* to 1.6 points more and packs the fixed *mixtures* 5 %
lower, for five to ten times the work. *locks* lose. 30° brings no more.
""", table(["set", "`--rotations 90`", "`--rotations 45`", "`--rotations 30`"], cells), source(used))


def open_height():
    rows = suite("open")
    bare = [merged([row]) for row in results("published") if row["suite"] == "open bare"]
    short = re.compile(r" --gap 0 --detail 1.*")
    cells = [[row["set"], code(row["options"]), millimetres(row["height"]), percent(row["density"]), time_of(row)] for row in rows]
    cells_bare = [[row["set"], code(short.sub("", row["options"])), millimetres(row["height"]), percent(row["density"]),
                   time_of(row)] for row in bare]
    titles = ["set", "options", "height", "density in its box", "time"]
    return section("Without a ceiling", """
All copies are placed; what counts is the height.
""", table(titles, cells), source(rows), """The bare search on smaller bases. On *tori48* finer voxels gain more than finer turns. On *quick* thirty orders gain more
than either. A height of 144 mm is known to be possible there, so one pass is far from the best.""", table(titles, cells_bare),
                   source(bare))


def low_jobs():
    cells, used = [], []
    for (name,), rows in grouped([row for row in results("published") if row["suite"] == "low jobs"], "set").items():
        used += rows
        cells.append([name, *(f"{millimetres(row['height'])}, {duration(row['seconds_cpu'])} cpu" for row in rows)])
    full, used_full = [], []
    for (name,), rows in grouped([row for row in results("published") if row["suite"] == "height at"], "set").items():
        used_full += rows
        full.append([name, *(f"{count(row['placed'])}, {percent(row['density'])}, {duration(row['seconds_cpu'])} cpu"
                             for row in rows)])
    return section("Small jobs in large trays", """
`--height-at auto`, the default, packs low what fits with room to spare (`top`), and fills what overflows (`bottom`, the
paper's rule). Buckets nest when they stand, which `top` does not see: there `auto` is 4 % higher than `bottom`. The tray of the
first four jobs is that of `--printer hp-mjf-5200`.
""", table(["job", "`bottom`", "`top`", "`auto`"], cells), source(used), "Trays that overflow, all options but this one at their defaults:",
                   table(["set", "`bottom`", "`top`"], full), source(used_full))


def shown(what, value):
    return millimetres(value) if what == "height" else percent(value) if what == "density" else f"{value:.3f}"


def improving():
    cells, used = [], []
    for (job,), rows in grouped(results("improve"), "job").items():
        line, orders, grids = [job], [], []
        for seconds in ("0", "10", "60"):
            group = [row for row in rows if row["seconds"] == seconds]
            group = [row for row in group if row["commit"] == group[-1]["commit"]]
            if not group:
                line.append("–")
                continue
            used.append({**group[-1], "runs": len(group)})
            what = group[0]["what"]
            values = sorted((float(row["now"]) for row in group), reverse=what == "density")
            spread = f" ({shown(what, values[0])} to {shown(what, values[-1])})" if len(values) > 1 else ""
            line.append(f"{shown(what, statistics.median(values))}{spread}")
            if seconds != "0":
                orders.append(count(median(group, "steps")))
                grids.append(f"{float(group[0]['voxel']):g} mm, {group[0]['rotations']}")
        cells.append(line + [", ".join(dict.fromkeys(grids)), ", ".join(orders)])
    return section("Improving", """
`--improve` uses the time that you give it. Heights are of sets that fit, on bases of 120×120, 100×100 and 480×245 mm; densities
are of trays that cannot hold all, by `--goal`; *thousand* counts trays, of the last the share that is filled. Medians, in
brackets the best and the worst seed. The seconds come on top of the first packing.
""", table(["job", "packed once", "10 s more", "60 s more", "grid", "orders tried"], cells), source(used, "job"), """Disappointing: *quick* and *pieces-500* gain nothing from ten minutes that they had not after two to six.
A full tray gains little from other orders by `volume`. *thousand* keeps its five trays.

![Heights over ten minutes: most is gained in the first minute or two](images/improve.svg)

Command: `bench/improve.py --curve 600 PROGRAM DATA bench/results/improve-curve.csv --only tori48,quick,mixtures-120,pieces-500`,
then `bench/plot.py curve docs/images/improve.svg tori48=bench/results/improve-curve.csv ...`. Measured on: 2 cores, busy; commit
not noted, recorded in 15b61ae; 1 run.""")


def orders():
    cells, used = [], []
    fixed = {(row["set"], row["options"]): row for row in results("published") if row["suite"] == "order fixed"}
    for row in (row for row in results("published") if row["suite"] == "order"):
        used.append(row)
        low = fixed[row["set"], row["options"]]
        cells.append([row["set"], code(row["options"]), count(row["placed"]), percent(row["density"]),
                      f"{duration(row['seconds_cpu'])} cpu", millimetres(low["height"]), f"{duration(low['seconds_cpu'])} cpu"])
    return section("Orders, restarts and beams", """
`volume` fills the tray with other parts, it does not pack them better: its fixed sets are higher. The best of twenty orders
lowers fixed sets by 2 to 10 %. A beam of five gains next to nothing, for 16 to 75 times the work. `--improve` does better than
both in less time.
""", table(["set", "options", "placed", "density", "time", "fixed set: height", "time"], cells), source(used))


def large_trays():
    rows = [merged([row]) for row in results("published") if row["suite"] == "large tray"]
    cells = [[code(row["options"]), placed_of(row), millimetres(row["height"]), percent(row["density"]), time_of(row),
              duration(row["seconds_search"]), f"{float(row['memory_mb']) / 1000:.1f} GB"] for row in rows]
    copies = results("copies")
    return section("Large trays and many copies", """
*sixthousand*, 6,596 parts, in one tray of 78 million voxels:
""", table(["options", "placed", "height", "density", "whole run", "search", "memory"], cells), source(rows),
                   """500 copies of one part against 500 different parts of the same kind. Copies reuse what the first one found.
Gap 0 with p = 4 is the search in a full tray.""",
                   table(["part", "options", "copies", "different parts", "share"],
                         [[row["part"], code(row["options"]), duration(row["copies_seconds"]), duration(row["new_parts_seconds"]),
                           f"{100 * float(row['copies_seconds']) / float(row['new_parts_seconds']):.0f} %"] for row in copies]),
                   source(copies, "part"))


def plain_method():
    cells, used = [], []
    for row in results("plain"):
        used.append(row)
        spread = f" ({row['least']} to {row['greatest']})" if row["least"] else ""
        cells.append([row["set"], f"{row['gap']} mm, {row['detail']}, {row['voxel']} mm", row["machine"],
                      duration(row["seconds_search"]), f"{float(row['ratio']):.0f}{spread}", row["runs"]])
    gpu = results("gpu")
    gpu_cells = [[row["set"], f"{row['voxel']} mm", " to ".join(dict.fromkeys((row["seconds_search_least"], row["seconds_search_greatest"]))) + " s",
                  f"{row['plain_gpu_ms']} ms an orientation, {row['plain_gpu_seconds']} s", row["gpu_over_cpu"]] for row in gpu]
    verified = results("verified")
    verified_cells = [[row["set"], f"{row['voxel']} mm", f"{float(row['height_penalty']):g}", f"{row['gap']} mm, {row['detail']}",
                       f"{row['verified']} of {row['searches']}" if row["searches"] else row["verified"], row["differences"]]
                      for row in verified]
    return section("Against the plain method", """
The plain method is the paper's, in single precision with FFTW and two threads: for every orientation a forward and two
inverse transforms of the tray. It is timed on 6 to 17 searches of a run and extrapolated. *Ratio* is its time divided by ours
in the same run. Disappointing: *mixtures* at gap 0 stays below 100 on the EPYC.
""", table(["set", "gap, detail, voxel", "machine", "our search", "ratio (least to greatest)", "runs"], cells), source(used), """**Beside a GPU.** The plain method with cuFFT, against our search on two processor cores. The last column is the GPU's
time divided by ours: a GPU would pay only with another method.""",
                   table(["set", "voxel", "our search, 2 cores", "plain, GPU", "GPU over ours"], gpu_cells), source(gpu), """**Equal answers.** `--verify-with reference` asks the plain method for the same placements. Where not all searches of a
run were asked, a seed chose them. `scripts/test.sh -L long` makes such runs again.""",
                   table(["set", "voxel", "p", "gap, detail", "searches compared", "differences"], verified_cells), source(verified))


def threads():
    rows = results("threads")
    cells = [[row["set"], row["what"], row["threads"], duration(row["seconds"])] for row in rows]
    return section("Threads", """
Two threads take a little more than half the time. More than four bring little at 2 mm.
""", table(["set", "what", "threads", "time"], cells), source(rows))


def memory():
    rows = results("memory")
    of_runs = grouped([row for row in rows if row["kind"] == "defaults"], "set")
    modes = ("--voxel 2 --interlock off", "--voxel 2 --interlock post", "--voxel 1 --interlock off", "--voxel 1 --interlock post")
    taken = {(row["set"], row["options"]): row["taken_mb"] for row in rows if row["kind"] == "defaults"}
    planned = [row for row in rows if row["kind"] == "planned"]
    return section("Memory", """
MB at the peak of a run. Half the voxel size takes six to nine times as much. A plan takes at most a tenth more than
the search.
""", table(["set", *map(code, modes)], [[name, *(count(taken[name, mode]) for mode in modes)] for name, in of_runs]),
                   source([row for row in rows if row["options"] in modes]), """`--dry-run` says beforehand what a run may take. Only for `--rotations 45` on *mixtures* it said too little, by up to
a seventh.""",
                   table(["set", "options", "planned, MB", "taken, MB"],
                         [[row["set"], code(row["options"]), count(row["planned_mb"]), count(row["taken_mb"])] for row in planned]),
                   source(planned))


def files():
    rows = results("formats")
    cells = [[row["what"], f"{row['size_mb']} MB", f"{count(row['read_ms'])} ms" if float(row["read_ms"]) >= 1 else f"{row['read_ms']} ms",
              f"{row['write_ms']} ms" if row["write_ms"] else "–"] for row in rows]
    return section("Reading and writing", """
Reading is everything until a mesh can be packed: welding, shells, repairs. Copies strewn through each other in one file are
the slowest.
""", table(["what", "size", "read", "write"], cells), source(rows, "what"))


def life():
    costs, limits = results("costs"), results("time-limit")
    cells = [[row["topic"], row["what"], f"{row['without']} {row['unit']}", f"{row['with_']} {row['unit']}"] for row in costs]
    limit_cells = [[name, *(", ".join(f"{float(row[field]):g} s" for row in group) for field in ("limit", "took"))]
                   for (name,), group in grouped(limits, "run").items()]
    return section("Time limits, the journal, Python", """
Neither the journal nor the way through Python costs time.
""", table(["what", "job", "without", "with"], cells), source(costs, "topic"),
                   "`--time-limit` holds on an overloaded machine, but pictures and reports come on top:",
                   table(["run", "limit", "took"], limit_cells), source(limits, "run"))


def page():
    path = RESULTS / "page.csv"
    if not path.exists():
        return ""
    rows = [row for row in rows_of(path) if not row["what"].startswith("#")]
    note = next(line for line in path.read_text(encoding="utf-8").splitlines() if line.startswith("#"))
    command, commit, machine = (word.strip() for word in note.lstrip("# ").split(";")[:3])
    return section("The page", """
What users of `spectralpack serve` wait for. The browser draws without a graphics processor here, which is the slowest case.
""", table(["what", "median", "runs"], [[row["what"], f"{row['median']} {row['unit']}", row["runs"]] for row in rows]),
                   f"Command: `{command}`. Measured on: {machine}; {commit}.")


def others():
    rows = results("others")
    cells = [[row["program"], percent(row["density_of_box"]), duration(row["seconds_cpu"])] for row in rows]
    instances = results("voxel-instances")
    lower = sum(float(row["one_pass"]) < float(row["published"]) for row in instances)
    better = sum(float(row["improve_10"]) < float(row["published"]) for row in instances)
    return section("Beside other programs", """
*quick*, density in each packing's own box. A rough comparison: sparrow-3d packed into a strip of 150×150 mm, the others into
boxes of their own, and none looks at interlocking.
""", table(["program", "density", "processor time"], cells), source(rows, "program"),
                   f"""Instances that others have published results for, in voxels. 24 orientations here, 10 there. Heights: one pass is lower
than the best published voxel run on {lower} of {len(instances)}, ten more seconds on {better}.""",
                   table(["instance", "copies", "base", "one pass", "`--improve 10`", "best published"],
                         [[row[key] for key in ("instance", "copies", "base", "one_pass", "improve_10", "published")] for row in instances]),
                   source(instances, "instance"))


def paper():
    rows = results("paper")
    cells = [[row["set"], row["what"], percent(row["density"], 2), millimetres(row["height"]), duration(row["seconds"])] for row in rows]
    published = results("published")
    letters = [merged([row]) for row in published if row["suite"] == "letters"]
    polyhedra = [row for row in published if row["suite"] == "polyhedra"]
    segments = results("segments")
    return section("The paper's own sets", """
The paper's figures on its own sets. Its parts are not available. Ours are made after its recipe and have other contents, so
these rows compare with each other only, not with ours. They show what to expect of such jobs elsewhere.
""", table(["the paper's set", "program", "density", "height", "time"], cells),
                   f"Source: the tables and figures of the paper (SIGGRAPH 2023), as it quotes others. Recorded in {rows[0]['recorded_in']}.",
                   "**Letters.** *mixtures* into letters of 322×322×80 mm. `bench/letters.py` makes them.",
                   table(["letter", "placed", "density", "whole run"],
                         [[row["set"], placed_of(row), percent(row["density"]), time_of(row)] for row in letters]), source(letters),
                   "![SIGGRAPH](images/letters.png)",
                   "**Polyhedra.** Ten generated kinds of solids of a few large faces, on the literature's bases.",
                   table(["copies", "options", "height", "density in its box", "time"],
                         [[row["copies"], code(row["options"]), millimetres(row["height"]), percent(row["density"]), time_of(row)]
                          for row in polyhedra]), source(polyhedra),
                   """**Segments.** Bodies cut into pieces, packed into the least box (`--minimise box`). Finer turns and voxels shrink the box by up
to 16 %, for 13 to 21 times the work.""",
                   table(["pieces", "turns", "voxel", "box", "filled", "time"],
                         [[row["pieces"], f"{row['turns']}°", f"{row['voxel']} mm", f"{int(row['box_mm3']) / 1000:.0f} cm³",
                           percent(row["filled"]), f"{duration(row['seconds_cpu'])} cpu"] for row in segments]), source(segments, "pieces"))


INTRO = """# Benchmarks

Made by `bench/figures.py` from `bench/results/*.csv`: change those, not this page. [Measuring](measuring.md) has the method and
what follows for you. This page has the figures, also those that disappoint.

`DATA` is the folder of the benchmark data: real printer parts. *mixtures* has large hollow and small solid parts, *pieces* many
small ones, *locks* rings, hooks and frames. `spectralpack generate` makes sets that are alike, not equal, so densities compare
only on the same set. Unless a table says otherwise: voxels of 2 mm, a gap of 0.2 mm, `--detail 2`, refined, two threads. "cpu" is
processor time of all threads, given where other programs ran beside; on two threads it is up to twice the time by the clock.

Where a commit is "not noted", the figure is older than the files of results. The commit that brought it into the documents
stands there instead; times of that age are of slower builds."""


def benchmarks(_):
    sections = [defaults(), small(), bare_search(), voxels(), refining(), interlocking(), turns(), open_height(), low_jobs(),
                improving(), orders(), large_trays(), plain_method(), threads(), memory(), files(), life(), page(), others(),
                paper()]
    return "\n\n".join([INTRO, *filter(None, sections)]) + "\n"


def between_markers(text, made):
    before, rest = text.split(BEGIN, 1)
    return f"{before}{BEGIN}\n{made}\n{END}{rest.split(END, 1)[1]}"


def readme(text):
    rows = [row for row in suite("default") if row["set"] in MEANS]
    cells = [[f"{row['set']}: {ABOUT[row['set']]}", placed_of(row).split(" of ")[0], percent(row["density"]), time_of(row),
              MEANS[row["set"]]] for row in rows]
    made = table(["parts", "placed", "density", "whole run", "what it means for you"], cells)
    runs = sorted({row["runs"] for row in rows})
    commits = listed(f"commit {row['commit']}" if row.get("commit") else f"recorded in {row['recorded_in']}" for row in rows)
    made += (f"\n\nMedians of {runs[0] if len(runs) == 1 else f'{runs[0]} to {runs[-1]}'} runs on {listed(row['machine'] for row in rows)}; "
             f"{commits}; `spectralpack pack SET.csv -o b.json` (*thousand*: and `--trays all`).")
    return between_markers(text, made)


ATTACKS = ["undisturbed", "KILL", "TERM", "INT", "HUP", "full disk", "address limit", "random jobs", "random jobs, killed",
           "renamed", "other unit", "shifted", "reordered", "left out", "total"]


def reliability(text):
    rows = {row["attack"]: row for row in results("attack")}
    fields = ["runs", "cut_off", "gone_on", "packings_judged", "copies", "steps_replayed", "differences"]
    made = table(["attack", "runs", "cut off", "went on", "packings judged", "copies", "steps replayed", "differences"],
                 [[name, *(count(rows[name][field]) for field in fields)] for name in ATTACKS])
    cut = [f"{row['cut_off_in']} {sum(int(value) for name, value in row.items() if name != 'cut_off_in')}"
           for row in results("attack-phases")]
    made += (f"\n\nCut off in: {', '.join(cut)}. Command: `scripts/attack.sh 4 out/attack 59`. Measured on: 2 cores of a "
             "Xeon server; commit not noted, recorded in b9cddc9; 1 run.")
    return between_markers(text, made)


PAGES = {"docs/benchmarks.md": benchmarks, "README.md": readme, "docs/reliability.md": reliability}


def main():
    check = sys.argv[1:] == ["--check"]
    if sys.argv[1:] and not check:
        sys.exit(__doc__)
    stale = []
    for name, make in PAGES.items():
        path = ROOT / name
        old = path.read_text(encoding="utf-8") if path.exists() else ""
        if old == (new := make(old)):
            continue
        stale.append(name)
        if not check:
            path.write_text(new, encoding="utf-8")
    if check and stale:
        sys.exit("\n".join(f"{name} is not what bench/figures.py makes of bench/results: run it" for name in stale))
    print("figures are up to date" if check or not stale else f"written: {', '.join(stale)}")


if __name__ == "__main__":
    main()
