#!/usr/bin/env python3
"""scripts/check_commands.py PROGRAM: every command that README.md and docs/guide.md show behind a $ runs as printed.

What it says is compared with the lines below it: `...` stands for any lines, and of a command that improves for so many
seconds, whose figures depend on the machine, numbers are not compared.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def sessions(document):
    """(line number, command, lines expected of it), in order."""
    found, command, expected, start, inside = [], None, [], 0, False
    for number, line in enumerate(document.read_text().splitlines(), 1):
        if line.startswith("```"):
            if inside and command is not None:
                found.append((start, command, expected))
            inside, command = not inside, None
        elif inside and line.startswith("$ "):
            if command is not None:
                found.append((start, command, expected))
            command, expected, start = line[2:], [], number
        elif inside and command is not None and command.endswith("\\"):
            command = command[:-1] + line.strip()
        elif inside and command is not None:
            expected.append(line.rstrip())
    return found


def matches(expected, said):
    """Whether `said` is `expected`, of which `...` is any number of lines."""
    if not expected:
        return not said
    if expected[0].strip() == "...":
        return matches(expected[1:], said) or bool(said) and matches(expected, said[1:])
    return bool(said) and expected[0] == said[0] and matches(expected[1:], said[1:])


def run(document, folder, path):
    faults = 0
    for number, command, expected in sessions(document):
        ran = subprocess.run(command, shell=True, cwd=folder, capture_output=True, text=True, timeout=600,
                             env={**os.environ, "PATH": f"{path}:{os.environ['PATH']}", "XDG_CONFIG_HOME": str(folder)})
        said = [line.rstrip() for line in (ran.stderr + ran.stdout).splitlines()]
        wanted = expected
        if "--improve" in command:
            said, wanted = ([re.sub(r"\d[\d.]*", "#", line) for line in lines] for lines in (said, wanted))
        # Where nothing is shown, only that it works counts.
        if ran.returncode < 126 and (matches(wanted, said) or not expected):
            continue
        faults += 1
        print(f"{document.relative_to(ROOT)}:{number}: $ {command}\nends with {ran.returncode} and says")
        print("\n".join(f"    {line}" for line in said))
    return faults


program = pathlib.Path(sys.argv[1]).resolve()
faults = 0
with tempfile.TemporaryDirectory() as temporary:
    base = pathlib.Path(temporary)
    (base / "bin").mkdir()
    (base / "bin" / "spectralpack").symlink_to(program)
    tour, day = base / "tour", base / "day"
    tour.mkdir()
    (tour / "out").mkdir()
    (tour / "data").symlink_to(ROOT / "data")
    shutil.copytree(ROOT / "data" / "guide", day)
    shutil.copytree(ROOT / "data" / "samples", day / "parts", ignore=shutil.ignore_patterns("*.csv", "*.py"))
    faults += run(ROOT / "README.md", tour, base / "bin")
    faults += run(ROOT / "docs" / "guide.md", day, base / "bin")
print("commands of README and guide run as printed" if not faults else f"{faults} commands do not run as printed")
sys.exit(1 if faults else 0)
