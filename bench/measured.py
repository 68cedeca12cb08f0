"""What every row of bench/results says of how it was made, and adding rows. Used by the scripts beside it."""
import csv
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
GENERATED = ["bench/results", "docs/benchmarks.md", "docs/reliability.md", "README.md"]
SOURCES = ["src", "include", "apps", "cmake", "CMakeLists.txt"]


def git(*words):
    return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()


def commit_of(program):
    """The commit that is checked out, "-dirty" where a tracked file other than a result or a generated page has changed.

    Nobody can tell whether PROGRAM was built from it; where it cannot be, this says so on standard error.
    """
    if os.path.getmtime(program) < int(git("log", "-1", "--format=%ct", "--", *SOURCES)):
        print(f"{program} is older than the last commit of its source: build it again?", file=sys.stderr)
    changed = git("status", "--porcelain", "--untracked-files=no", "--", ".", *(f":!{path}" for path in GENERATED))
    return git("rev-parse", "--short", "HEAD") + ("-dirty" if changed else "")


def machine(threads):
    with open("/proc/cpuinfo", encoding="utf-8") as lines:
        name = next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), "unknown processor")
    return f"{name}, {threads} cores"


def rows_of(path):
    if not os.path.exists(path):
        return []
    with open(path, newline="", encoding="utf-8") as text:
        return list(csv.DictReader(text))


def add_row(path, row, fields):
    """Adds a row; a new file begins with the names of `fields`, an old one keeps its own."""
    fresh = not os.path.exists(path)
    if not fresh:
        with open(path, newline="", encoding="utf-8") as text:
            fields = next(csv.reader(text))
    with open(path, "a", newline="", encoding="utf-8") as text:
        writer = csv.DictWriter(text, fields, restval="", lineterminator="\n")
        if fresh:
            writer.writeheader()
        writer.writerow(row)
