#!/usr/bin/env python3
"""Attacks the program for some minutes; scripts/attack.sh builds what it needs and calls it. docs/reliability.md says
what it tries and what it found. Any difference is kept in the folder it is told, with the command that shows it."""

import argparse
import collections
import contextlib
import copy
import csv
import json
import math
import os
import random
import resource
import select
import shlex
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PATIENCE = 600  # seconds for one run; more is a hang


# --- Parts -----------------------------------------------------------------------------------------------------------

def prism(outline, height, z=0.0):
    """Of a convex-or-not outline (counter-clockwise, and its triangles) between z and z + height."""
    points, triangles = outline
    n = len(points)
    low = [(x, y, z) for x, y in points]
    high = [(x, y, z + height) for x, y in points]
    facets = [(low[c], low[b], low[a]) for a, b, c in triangles] + [(high[a], high[b], high[c]) for a, b, c in triangles]
    for i in range(n):
        k = (i + 1) % n
        facets += [(low[i], low[k], high[k]), (low[i], high[k], high[i])]
    return facets


def box(x, y, z):
    return prism(([(0, 0), (x, 0), (x, y), (0, y)], [(0, 1, 2), (0, 2, 3)]), z)


def ell(x, y, thick, z):
    return prism(([(0, 0), (x, 0), (x, thick), (thick, thick), (thick, y), (0, y)],
                  [(0, 1, 2), (0, 2, 3), (0, 3, 5), (3, 4, 5)]), z)


def channel(x, y, thick, z):
    return prism(([(0, 0), (x, 0), (x, y), (x - thick, y), (x - thick, thick), (thick, thick), (thick, y), (0, y)],
                  [(0, 1, 4), (0, 4, 5), (1, 2, 3), (1, 3, 4), (0, 5, 6), (0, 6, 7)]), z)


def hook(x, y, thick, z, mouth):
    """A ring with a gap in it: hooks hang in each other."""
    side = (x - mouth) / 2
    return prism(([(0, 0), (x, 0), (x, y), (x - side, y), (x - side, y - thick), (x - thick, y - thick),
                   (x - thick, thick), (thick, thick), (thick, y - thick), (side, y - thick), (side, y), (0, y)],
                  [(0, 1, 6), (0, 6, 7), (1, 2, 5), (1, 5, 6), (2, 3, 4), (2, 4, 5),
                   (0, 7, 8), (0, 8, 11), (8, 9, 10), (8, 10, 11)]), z)


def torus(radius, thick, around=16, across=8):
    def at(i, k):
        a, b = 2 * math.pi * i / around, 2 * math.pi * k / across
        r = radius + thick * math.cos(b)
        # Multiples of 1/64, so that shifts and units are exact.
        return tuple(round(64 * v) / 64 for v in (r * math.cos(a), r * math.sin(a), thick * math.sin(b)))
    facets = []
    for i in range(around):
        for k in range(across):
            p, q = at(i, k), at((i + 1) % around, k)
            r, s = at((i + 1) % around, (k + 1) % across), at(i, (k + 1) % across)
            facets += [(p, q, r), (p, r, s)]
    return facets


KINDS = ["box", "ell", "channel", "hook", "torus"]


def random_part(rng, kinds):
    size = lambda low, high: rng.randrange(low * 4, high * 4) / 4
    kind = rng.choice(kinds)
    if kind == "box":
        return kind, box(size(6, 24), size(6, 24), size(3, 20))
    if kind == "ell":
        return kind, ell(size(12, 28), size(12, 28), size(2, 6), size(4, 16))
    if kind == "channel":
        return kind, channel(size(14, 28), size(10, 26), size(2, 5), size(4, 16))
    if kind == "hook":
        x = size(18, 32)
        return kind, hook(x, size(18, 32), 3, size(3, 6), rng.choice([4, 6, x - 8]))
    return kind, torus(size(8, 14), size(1, 3))


def shifted(facets, by):
    return [tuple(tuple(c + d for c, d in zip(p, by)) for p in facet) for facet in facets]


def scaled(facets, by):
    return [tuple(tuple(c * by for c in p) for p in facet) for facet in facets]


def write_stl(path, facets):
    data = bytearray(80) + struct.pack("<I", len(facets))
    for facet in facets:
        data += struct.pack("<12fH", 0, 0, 0, *[c for p in facet for c in p], 0)
    Path(path).write_bytes(data)


def size_of(facets):
    points = [p for facet in facets for p in facet]
    return [max(p[a] for p in points) - min(p[a] for p in points) for a in range(3)]


class Parts:
    """A set of parts: files and rows of a set file, in a folder."""

    def __init__(self, rng, number, copies, kinds=KINDS):
        self.rows = []  # name, facets, columns
        for i in range(number):
            kind, facets = random_part(rng, kinds)
            self.rows.append((f"{kind}{i}", facets, {"count": max(1, round(copies / number * rng.uniform(0.5, 1.5)))}))

    def write(self, folder, name="set"):
        """Returns the set file."""
        folder.mkdir(parents=True, exist_ok=True)
        columns = sorted({key for _, _, extra in self.rows for key in extra})
        lines = [",".join(["mesh", *columns])]
        for part, facets, extra in self.rows:
            write_stl(folder / f"{part}.stl", facets)
            lines.append(",".join([f"{part}.stl", *[str(extra.get(key, "")) for key in columns]]))
        (folder / f"{name}.csv").write_text("\n".join(lines) + "\n")
        return folder / f"{name}.csv"


# --- The options -----------------------------------------------------------------------------------------------------

def flag(name, shares=0.5):
    return lambda rng, job: [f"--{name}"] if rng.random() < shares else []


def one_of(name, *values):
    return lambda rng, job: [f"--{name}", str(rng.choice(values))]


def tray(rng, job):
    return ["--tray", "x".join(str(rng.choice([40, 50, 64, 75, 90])) for _ in range(3))]


def keep_out(rng, job):
    low = [rng.randrange(0, 25) for _ in range(3)]
    return ["--keep-out", ",".join(map(str, low + [c + rng.randrange(4, 25) for c in low]))]


def container(rng, job):
    file = job / "container.stl"
    if rng.random() < 0.5:
        write_stl(file, box(60, 50, 45))
    else:
        write_stl(file, ell(80, 70, 45, 40))
    return ["--container", str(file)]


# How each option is drawn. A new option has to be added here, or among those that are left out.
DRAWN = {
    "tray": tray, "container": container, "keep-out": keep_out, "physical": flag("physical"),
    "trays": one_of("trays", 2, 3, "all"), "try-per-tray": one_of("try-per-tray", 0, 1, 5, 100),
    "voxel": one_of("voxel", 1.5, 2, 3, 4), "detail": one_of("detail", 1, 2, 3),
    "rotations": one_of("rotations", "none", "90", "90+box", "icosahedron:0"), "upright": flag("upright"),
    "gap": one_of("gap", 0, 0.1, 0.5, 1, 2.5), "wall-gap": one_of("wall-gap", 0, 0.3, 1, 3),
    "refine": lambda rng, job: ["--no-refine"],
    "interlock": one_of("interlock", "off", "place", "post"), "links": one_of("links", "allow", "avoid"),
    "take-out": one_of("take-out", "smallest", "lightest", "thinnest"),
    "unpack": one_of("unpack", "any", "top", "auto"), "ray-spacing": one_of("ray-spacing", 0.5, 2, 10),
    "height-penalty": one_of("height-penalty", "auto", 0, 4, 1e8),
    "height-at": one_of("height-at", "bottom", "top", "auto"),
    "open-height": flag("open-height", 1), "minimise": one_of("minimise", "box"), "fill": flag("fill", 1),
    "max-density": one_of("max-density", 0.1, 0.3), "max-layer-fill": one_of("max-layer-fill", 0.2, 0.5),
    "order": one_of("order", "size", "input", "random", "volume", "mixed"),
    "restarts": one_of("restarts", 2, 3), "beam": one_of("beam", 2),
    "goal": one_of("goal", "fair", "volume", "copies", "value"), "improve-steps": one_of("improve-steps", 1, 5),
    "engine": one_of("engine", "auto", "cpu", "reference"), "threads": one_of("threads", 1, 2, 3),
    "seed": one_of("seed", 1, 7, 2**63), "memory": one_of("memory", "2G", "900M"),
    "verify-with": one_of("verify-with", "reference:2", "cpu"), "time-limit": one_of("time-limit", 0, 0.5, 2),
    "require-all": flag("require-all", 1), "skip-unusable": flag("skip-unusable", 1),
    "unit": one_of("unit", "mm"), "material": one_of("material", "PA 12"), "job-name": one_of("job-name", "a b"),
    "material-density": one_of("material-density", 1.01), "progress": one_of("progress", "json", "none"),
    "json": flag("json", 1), "details": flag("details", 1),
}
LEFT_OUT = {
    "output", "report",         # every job has them
    "dry-run",                  # writes nothing
    "printer", "onto", "keep",  # stand for other options; a second build
    "improve",                  # what comes of it depends on the clock; improve-steps does not
}
# Rarely, because hardly anything goes together with them, or because they take long.
RARE = {"container": 0.1, "open-height": 0.1, "minimise": 0.05, "fill": 0.1, "engine": 0.1, "verify-with": 0.1,
        "restarts": 0.1, "beam": 0.05, "improve-steps": 0.1, "time-limit": 0.1, "memory": 0.1, "max-density": 0.1,
        "max-layer-fill": 0.1}


def require_all_options_known(schema):
    options = set(json.loads(Path(schema).read_text())["properties"]["options"]["properties"])
    unknown = options - set(DRAWN) - LEFT_OUT
    if unknown:
        raise SystemExit(f"attack.py does not know how to draw: {', '.join(sorted(unknown))}")


def draw_options(rng, job):
    args = []
    for name, draw in DRAWN.items():
        if name == "tray" or rng.random() < RARE.get(name, 0.25):
            args += draw(rng, job)
    if "--container" in args:
        at = args.index("--tray")
        del args[at:at + 2]
    return args


# --- Runs ------------------------------------------------------------------------------------------------------------

class Ran:
    def __init__(self, status, err, cut_off, phase):
        self.status, self.err, self.cut_off, self.phase = status, err, cut_off, phase
        self.resumed = "goes on from" in err


class Program:
    def __init__(self, path):
        self.path = path
        self.phases = []  # of the last run that was not cut off: (name, began, ended)

    def run(self, args, sent=None, when=None, address=0, file_size=0):
        """Runs it. The signal `sent` comes `when` says: so many seconds after a phase began for the n-th time, from 1.
        Phases are read from standard error."""
        def limits():
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            if address:
                resource.setrlimit(resource.RLIMIT_AS, (address, address))
            if file_size:
                resource.setrlimit(resource.RLIMIT_FSIZE, (file_size, file_size))

        process = subprocess.Popen([str(self.path), *map(str, args)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                   preexec_fn=limits, env={**os.environ, "XDG_CONFIG_HOME": "/nonexistent"})
        began, text, phase, phases = time.time(), b"", "load", [["load", 0, 0]]
        due = began + when[2] if when and when[0] == "load" else None
        cut_off = False
        while True:
            now = time.time()
            if now - began > PATIENCE:
                process.kill()
                process.wait()
                return Ran("hang", text.decode(errors="replace"), cut_off, phase)
            if due is not None and not cut_off and now >= due:
                if process.poll() is None:
                    process.send_signal(sent)
                    cut_off = True
            wait = 0.2 if due is None or cut_off else max(0, min(0.2, due - now))
            if select.select([process.stderr], [], [], wait)[0]:
                more = os.read(process.stderr.fileno(), 65536)
                if not more:
                    break
                for line in more.split(b"\n"):
                    if b'"phase": "' not in line or cut_off:
                        continue
                    name = line.split(b'"phase": "')[1].split(b'"')[0].decode()
                    if name != phase:
                        phase = name
                        phases[-1][2] = time.time() - began
                        phases.append([phase, time.time() - began, 0])
                        if when and due is None and (phase, sum(p[0] == phase for p in phases)) == when[:2]:
                            due = time.time() + when[2]
                text += more
        status = process.wait()
        phases[-1][2] = time.time() - began
        if not cut_off:
            self.phases = phases
        return Ran(status, text.decode(errors="replace"), cut_off, phase)


def key(file):
    """What has to be the same. Paths of meshes are relative to the packing file."""
    packing = json.loads(Path(file).read_text())
    trays = [([{**p, "mesh": None} for p in t["placements"]], t["disassembly"], t["height"]) for t in packing["trays"]]
    return [trays, packing["unplaced"], packing["input_hash"]]


class Campaign:
    COLUMNS = ["attack", "runs", "cut_off", "gone_on", "packings_judged", "copies", "steps_replayed", "not_judged",
               "refused", "differences"]

    def __init__(self, program, second, out, seed):
        self.program, self.second, self.out = Program(Path(program).resolve()), Path(second).resolve(), Path(out)
        self.rng = random.Random(seed)
        self.rows = collections.defaultdict(collections.Counter)
        self.phases = collections.defaultdict(collections.Counter)
        self.kept = 0
        self.out.mkdir(parents=True, exist_ok=True)
        self.refusals = collections.Counter()

    def differs(self, attack, what, folder, commands):
        self.rows[attack]["differences"] += 1
        self.kept += 1
        place = self.out / f"difference-{self.kept}"
        shutil.rmtree(place, ignore_errors=True)
        shutil.copytree(folder, place, ignore=shutil.ignore_patterns("disk"))
        # In the folder that is kept, these commands can be tried again.
        lines = [" ".join(shlex.quote(str(a)).replace(str(folder), ".") for a in c) for c in commands]
        (place / "what.txt").write_text(what + "\n\n" + "\n".join(lines) + "\n")
        print(f"DIFFERENCE ({attack}): {what}\n  kept in {place}", flush=True)

    def judge(self, attack, file, folder, commands, require=True):
        """By `check` and by the second verifier. Returns whether both find it sound."""
        row = self.rows[attack]
        checked = subprocess.run([self.program.path, "check", "--json", file], capture_output=True, text=True)
        sound = checked.returncode == 0
        if not sound:
            self.differs(attack, f"check exits {checked.returncode}: {checked.stdout[:2000]}{checked.stderr[:500]}",
                         folder, commands)
        second = subprocess.run([self.second, file], capture_output=True, text=True)
        if second.returncode == 2:
            row["not_judged"] += 1
            print(second.stderr.strip(), flush=True)
        elif second.returncode in (0, 1):
            verdict = json.loads(second.stdout)
            row["packings_judged"] += 1
            row["copies"] += verdict["copies"]
            row["steps_replayed"] += verdict["steps"]
            if second.returncode == 1:
                self.differs(attack, "the second verifier: " + "; ".join(verdict["findings"][:5]), folder, commands)
                sound = False
        else:
            self.differs(attack, f"the second verifier ended with {second.returncode}", folder, commands)
        return sound

    # Runs that are cut off, and go on ------------------------------------------------------------------------------

    # Each takes about a second: what it is to exercise, number of parts, copies, options.
    KILL_JOBS = [
        ("one tray", 6, 352, ["--tray", "156x143x117", "--voxel", "1.5"]),
        ("several trays", 6, 352, ["--tray", "104x91x78", "--voxel", "1.5", "--trays", "all"]),
        ("open height", 6, 264, ["--tray", "117x104", "--voxel", "1.5", "--open-height"]),
        ("least box", 4, 30, ["--tray", "104x104x104", "--voxel", "2", "--minimise", "box"]),
        ("orders", 6, 132, ["--tray", "91x78x65", "--voxel", "2", "--restarts", "4", "--beam", "2"]),
        ("improved", 5, 60, ["--tray", "78x71", "--voxel", "2", "--open-height", "--improve-steps", "8"]),
        ("improved trays", 5, 80, ["--tray", "78x71x52", "--voxel", "2", "--trays", "all", "--improve-steps", "2"]),
        ("improved box", 4, 20, ["--tray", "104x104x104", "--voxel", "2", "--minimise", "box", "--improve-steps", "25"]),
        ("fill", 3, 13, ["--tray", "117x104x78", "--voxel", "2", "--fill"]),
        ("reachable", 6, 264, ["--tray", "117x104x91", "--voxel", "1.5", "--interlock", "place"]),
        ("links", 6, 352, ["--tray", "130x117x104", "--voxel", "1.5", "--links", "allow", "--unpack", "any"]),
        ("grid", 6, 352, ["--tray", "117x104x91", "--voxel", "1", "--no-refine", "--trays", "2"]),
        ("caps", 6, 264, ["--tray", "117x104x91", "--voxel", "1.5", "--max-layer-fill", "0.3"]),
        ("45 degrees", 4, 88, ["--tray", "104x91x65", "--voxel", "2", "--rotations", "45"]),
    ]

    def kill_round(self, folder):
        rng = self.rng
        name, number, copies, options = rng.choice(self.KILL_JOBS)
        # What hangs in each other has to be taken out and put back.
        parts = Parts(rng, number, copies, ["hook", "torus", "channel"] if name == "links" else KINDS)
        parts = parts.write(folder / "parts")
        base = ["pack", parts, *options, "--threads", "2", "--progress", "json"]
        self.kill_and_go_on(folder, base)

    def kill_and_go_on(self, folder, base):
        rng = self.rng
        whole = folder / "whole.json"
        ran = self.program.run([*base, "-o", whole])
        if ran.status != 0:
            if not whole.exists() and ran.status in (5, 6):
                return
            self.differs("undisturbed", f"status {ran.status}: {ran.err[-500:]}", folder,
                         [[self.program.path, *base, "-o", whole]])
            return
        self.rows["undisturbed"]["runs"] += 1
        phases = self.program.phases
        self.judge("undisturbed", whole, folder, [[self.program.path, *base, "-o", whole]])
        wanted = key(whole)
        for attack in rng.sample(["KILL", "KILL", "TERM", "HUP", "INT", "full disk", "address limit"], 3):
            self.disturb(attack, folder, base, phases, wanted)

    def moment(self, phases):
        """A random one in a random phase of a run that went like this."""
        names = sorted({phase for phase, _, _ in phases})
        name = self.rng.choices(names, [0.3 if n == "load" else 1 for n in names])[0]
        times = [ended - began for phase, began, ended in phases if phase == name]
        nth = self.rng.randrange(len(times))
        return name, nth + 1, self.rng.uniform(0, max(0.01, times[nth]))

    def disturb(self, attack, folder, base, phases, wanted):
        rng = self.rng
        row = self.rows[attack]
        work = folder / "disk"
        with full_disk(work, attack == "full disk", rng) as disk:
            file, journal = work / "k.json", work / "k.json.journal"
            args = [*base, "-o", file, "--journal", journal]
            commands, what = [], []
            cuts = rng.choice([1, 2, 3])
            while cuts > 0:
                cuts -= 1
                when = self.moment(phases)
                more = {}
                if attack in ("KILL", "TERM", "HUP", "INT"):
                    more = {"sent": getattr(signal, "SIG" + attack), "when": when}
                elif attack == "address limit":
                    more = {"address": round(math.exp(rng.uniform(math.log(70e6), math.log(300e6))))}
                elif attack == "full disk":
                    more = disk.limit()
                ran = self.program.run(args, **more)
                row["runs"] += 1
                commands.append([self.program.path, *args, f"# {attack} {more}"])
                row["gone_on"] += ran.resumed
                hurt = ran.cut_off or (attack in ("full disk", "address limit") and ran.status != 0)
                row["cut_off"] += hurt
                if hurt:
                    self.phases[ran.phase][attack] += 1
                what.append(f"{attack} in {ran.phase}: status {ran.status}")
                allowed = (0, 130, -more["sent"]) if "sent" in more and (not ran.err or file.exists()) else {"KILL": (0, -9), "TERM": (0, 130), "INT": (0, 130), "HUP": (0, 130, -1),
                           "full disk": (0, 4), "address limit": (0, 4, 127)}[attack]
                # Silent: it had hardly begun; with an output it may have been done. 127: not even loaded.
                if ran.status not in allowed:
                    self.differs(attack, f"status {ran.status}: {ran.err[-800:]}", folder, commands)
                if file.exists() and ran.status in (0, 4, 130):
                    self.judge(attack, file, folder, commands)
                if ran.status == 0 and not ran.cut_off:
                    break
            disk.unlimit()
            done = file.exists() and not journal.exists() and key(file) == wanted
            if not done:
                if file.exists() and not journal.exists() and attack in ("TERM", "HUP", "INT"):
                    what.append("an output of a run that was cut off stands without its journal")
                ran = self.program.run(args)
                row["runs"] += 1
                row["gone_on"] += ran.resumed
                commands.append([self.program.path, *args])
                if ran.status != 0 or not file.exists():
                    self.differs(attack, f"status {ran.status} where it goes on, after {what}: {ran.err[-800:]}", folder,
                                 commands)
                    return
            if key(file) != wanted:
                shutil.copy(file, folder / "other.json")
                self.differs(attack, f"another packing after {what}", folder, commands)
            left = [p.name for p in work.iterdir() if p.name not in ("k.json",)]
            if left and attack != "KILL":
                self.differs(attack, f"files are left after {what}: {left}", folder, commands)
            elif journal.exists():
                self.differs(attack, f"the journal is left after {what}", folder, commands)

    # Random jobs ----------------------------------------------------------------------------------------------------

    def random_job(self, folder):
        rng = self.rng
        attack = "random jobs"
        row = self.rows[attack]
        job = folder / "parts"
        parts = Parts(rng, rng.randrange(1, 6), rng.randrange(1, 40))
        for i, (name, facets, extra) in enumerate(parts.rows):
            for column, values in {"gap": [0, 1, 2], "priority": [-1, 0, 2], "due": ["2026-12-01", "2027-01-01"],
                                   "orientations": ["any", "upright", "fixed", "+z -z"], "scale": [0.5, 1.25],
                                   "unit": ["mm"]}.items():
                if rng.random() < 0.15:
                    extra[column] = rng.choice(values)
        args = ["pack", parts.write(job), *draw_options(rng, job)]
        file = folder / "packing.json"
        extra = rng.choice([[], ["-o", folder / "b.3mf"], ["-o", folder / "b.csv", "--report", folder / "b.html"],
                            ["-o", folder / "b.stl", "-o", folder / "b.png"]])
        ran = self.program.run([*args, "-o", file, *extra])
        commands = [[self.program.path, *args, "-o", file, *extra]]
        row["runs"] += 1
        if ran.status == 2:  # options that do not go together
            row["refused"] += 1
            self.refusals[ran.err.strip().splitlines()[0][:100] if ran.err.strip() else "(nothing is said)"] += 1
            return
        if ran.status not in (0, 4, 5, 6) or (ran.status == 4 and "--memory" not in args):
            self.differs(attack, f"status {ran.status}: {ran.err[-800:]}", folder, commands)
            return
        if not file.exists():
            if ran.status in (0, 5):
                self.differs(attack, f"status {ran.status} and no packing: {ran.err[-500:]}", folder, commands)
            return
        self.judge(attack, file, folder, commands)
        # The same job, killed at some moment; runs under a time limit are not the same twice.
        if "--time-limit" in args or ran.status != 0 or rng.random() < 0.5:
            return
        attack = "random jobs, killed"
        row = self.rows[attack]
        journal = folder / "a.journal"
        args = [*args, "--progress", "json"] if "--progress" not in args else args
        again = [*args, "-o", folder / "again.json", "--journal", journal]
        killed = self.program.run(again, signal.SIGKILL, self.moment(self.program.phases))
        row["runs"] += 2
        row["cut_off"] += killed.cut_off
        if killed.cut_off:
            self.phases[killed.phase]["KILL"] += 1
        after = [*args, "-o", folder / "again.json", "--resume" if journal.exists() and rng.random() < 0.5 else
                 "--journal", journal]
        went_on = self.program.run(after)
        row["gone_on"] += went_on.resumed
        commands += [[self.program.path, *again], [self.program.path, *after]]
        if went_on.status == 3 and "--resume" in after and "before the first decision" in went_on.err:
            after[after.index("--resume")] = "--journal"
            went_on = self.program.run(after)
        if went_on.status != 0:
            self.differs(attack, f"status {went_on.status}: {went_on.err[-800:]}", folder, commands)
        elif key(folder / "again.json") != key(file):
            self.differs(attack, f"another packing, killed in {killed.phase}", folder, commands)

    # Jobs that have to give corresponding packings -------------------------------------------------------------------

    METAMORPHIC = [
        ["--tray", "60x50x40", "--voxel", "2"],
        ["--tray", "50x50x40", "--voxel", "2", "--trays", "2"],
        ["--tray", "60x50x40", "--voxel", "4", "--gap", "0.5", "--unpack", "any"],
        ["--tray", "60x60", "--voxel", "2", "--open-height"],
        ["--tray", "60x50x40", "--voxel", "2", "--no-refine", "--rotations", "none"],
        ["--tray", "60x50x40", "--voxel", "2", "--interlock", "off", "--order", "volume"],
    ]

    def metamorphic(self, folder):
        rng = self.rng
        parts = Parts(rng, rng.randrange(2, 6), rng.randrange(8, 40))
        options = rng.choice(self.METAMORPHIC)
        attack = rng.choice(["renamed", "other unit", "shifted", "reordered", "left out"])
        # Inches, and what is 25.4 times as large in millimetres; or a file that is 1024 times smaller, scaled.
        inches = attack == "other unit" and rng.random() < 0.5
        if inches:
            parts.rows = [(n, scaled(f, 1 / 32), {**e, "scale": 25.4}) for n, f, e in parts.rows]
        other = copy.deepcopy(parts)
        names = {}  # of the other's parts, by those of the first
        shift = {}
        scale = 1.0
        if attack == "left out":
            options = [*options, "--height-penalty", "4"] + ([] if "off" in options else ["--interlock", "off"])
            if "--open-height" in options:
                options.remove("--open-height")
                options[options.index("--tray") + 1] = "60x50x40"
        first = folder / "first.json"
        rows = self.rows[attack]
        before = ["pack", parts.write(folder / "parts"), *options, "-o", first]
        ran = self.program.run(before)
        commands = [[self.program.path, *before]]
        rows["runs"] += 1
        if ran.status == 6:
            return
        if ran.status != 0:
            self.differs(attack, f"status {ran.status}: {ran.err[-500:]}", folder, commands)
            return
        self.judge(attack, first, folder, commands)
        packing = json.loads(first.read_text())
        if attack == "renamed":
            letters = [chr(97 + i) for i in range(len(other.rows))]
            rng.shuffle(letters)
            other.rows = [(letter, f, e) for letter, (_, f, e) in zip(letters, other.rows)]
            names = {a[0]: b[0] for a, b in zip(parts.rows, other.rows)}
        elif inches:
            for _, _, extra in other.rows:
                extra.update({"scale": 1, "unit": "inch"})
        elif attack == "other unit":
            scale = 1 / 1024
            other.rows = [(n, scaled(f, scale), {**e, "scale": 1024}) for n, f, e in other.rows]
        elif attack == "shifted":
            voxel = float(options[options.index("--voxel") + 1])
            shift = {n: [voxel * rng.randrange(-20, 20) for _ in range(3)] for n, _, _ in parts.rows}
            other.rows = [(n, shifted(f, shift[n]), e) for n, f, e in other.rows]
        elif attack == "reordered":
            # Priorities make keys that differ, whatever the order goes by.
            order = list(range(len(parts.rows)))
            rng.shuffle(order)
            for (_, _, a), (_, _, b), p in zip(parts.rows, other.rows, order):
                a["priority"] = b["priority"] = p
            before = ["pack", parts.write(folder / "parts"), *options, "-o", first]
            self.program.run(before)
            packing = json.loads(first.read_text())
            rng.shuffle(other.rows)
        elif attack == "left out":
            lost = collections.Counter(u["part"] for u in packing["unplaced"])
            if not lost or any(u["reason"] != "no_place" for u in packing["unplaced"]):
                return
            for i, (_, _, extra) in enumerate(other.rows):
                extra["count"] -= lost[i]
            other.rows = [row for row in other.rows if row[2]["count"] > 0]
        second = folder / "second.json"
        after = ["pack", other.write(folder / "other"), *options, "-o", second]
        ran = self.program.run(after)
        commands = [[self.program.path, *before], [self.program.path, *after]]
        rows["runs"] += 1
        if ran.status != 0:
            self.differs(attack, f"status {ran.status}: {ran.err[-500:]}", folder, commands)
            return
        self.judge(attack, second, folder, commands)

        def stands(packing, names, shift, scale):
            """Where all stands, by the names of the first: transforms from the first's coordinates."""
            trays = []
            for tray in packing["trays"]:
                placed = []
                for p in tray["placements"]:
                    name = Path(packing["parts"][p["part"]]["mesh"]).stem
                    name = {b: a for a, b in names.items()}.get(name, name)
                    by = shift.get(name, [0, 0, 0])
                    m = p["transform"]
                    rows = [[v * scale for v in r[:3]] + [sum(r[i] * by[i] for i in range(3)) + r[3]] for r in m[:3]]
                    placed.append((name, p["orientation"], [round(v, 7) + 0.0 for r in rows for v in r]))
                # Who is highest, and goes first, may be a matter of rounding: plans are judged, not compared.
                trays.append((placed, tray["disassembly"] and tray["disassembly"]["complete"]))
            return trays

        if not same(stands(packing, {}, {}, 1), stands(json.loads(second.read_text()), names, shift, scale)):
            self.differs(attack, "not the corresponding packing", folder, commands)

    # ----------------------------------------------------------------------------------------------------------------

    def run(self, minutes):
        end = time.time() + 60 * minutes
        shares = {self.kill_round: 0.5, self.random_job: 0.3, self.metamorphic: 0.2}  # of the time
        spent = dict.fromkeys(shares, 0.0)
        while time.time() < end:
            attack = min(shares, key=lambda a: spent[a] / shares[a])
            began = time.time()
            with tempfile.TemporaryDirectory(prefix="attack-") as folder:
                attack(Path(folder))
            spent[attack] += time.time() - began
        self.report()
        return 1 if self.kept else 0

    def report(self):
        total = collections.Counter()
        lines = []
        for attack, row in self.rows.items():
            lines.append([attack] + [row[c] for c in self.COLUMNS[1:]])
            total.update(row)
        lines.append(["total"] + [total[c] for c in self.COLUMNS[1:]])
        with open(self.out / "attack.csv", "w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([self.COLUMNS, *lines])
        attacks = sorted({a for row in self.phases.values() for a in row})
        phases = [[p] + [self.phases[p][a] for a in attacks] for p in
                  ("load", "search", "disassemble", "reinsert", "write") if p in self.phases]
        with open(self.out / "phases.csv", "w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([["cut_off_in", *attacks], *phases])
        for table in ([self.COLUMNS, *lines], [["cut_off_in", *attacks], *phases]):
            widths = [max(len(str(line[i])) for line in table) for i in range(len(table[0]))]
            print()
            for line in table:
                print("  ".join(str(v).ljust(w) if i == 0 else str(v).rjust(w)
                                for i, (v, w) in enumerate(zip(line, widths))))
        for text, count in self.refusals.most_common(12):
            print(f"refused {count}: {text}")


def same(a, b):
    if isinstance(a, float) and isinstance(b, (int, float)) or isinstance(a, int) and isinstance(b, float):
        return abs(a - b) <= 1e-6
    if isinstance(a, (list, tuple)) and isinstance(b, (list, tuple)):
        return len(a) == len(b) and all(same(x, y) for x, y in zip(a, b))
    return a == b


class Disk:
    """A folder whose disk can be full: a small tmpfs where one may be mounted, else files of a limited size."""

    def __init__(self, folder, wanted, rng):
        self.folder, self.rng = folder, rng
        self.mounted = wanted and subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64m", "attack", folder],
                                                 capture_output=True).returncode == 0

    def limit(self):
        size = 4096 * self.rng.randrange(1, 20)
        if not self.mounted:
            return {"file_size": size}
        used = sum(p.stat().st_blocks * 512 for p in self.folder.iterdir())
        self.remount(size + used - used % 4096)
        return {}

    def unlimit(self):
        if self.mounted:
            self.remount(64 << 20)

    def remount(self, size):
        subprocess.run(["mount", "-o", f"remount,size={size}", self.folder], check=True)


@contextlib.contextmanager
def full_disk(folder, wanted, rng):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    disk = Disk(folder, wanted, rng)
    try:
        yield disk
    finally:
        if disk.mounted:
            subprocess.run(["umount", folder], check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--second", required=True, help="the second verifier, second_check")
    parser.add_argument("--schema", required=True, help="docs/job.schema.json")
    parser.add_argument("--minutes", type=float, default=10)
    parser.add_argument("--out", default="out/attack", help="folder for tables and differences")
    parser.add_argument("--seed", type=int, default=None, help="without it, another one each time")
    args = parser.parse_args()
    require_all_options_known(args.schema)
    seed = random.SystemRandom().randrange(2**32) if args.seed is None else args.seed
    print(f"seed {seed}", flush=True)
    return Campaign(args.program, args.second, args.out, seed).run(args.minutes)


if __name__ == "__main__":
    sys.exit(main())
