#!/usr/bin/env python3
"""Checks the direction of every #include: a room may include what lies below it, and itself.

The public headers (include/spectralpack) include each other and the standard library, nothing else. Those that hold
plain values (VALUES) are the ground that all rooms stand on; the others declare what src/api puts together. Also checks
that each third-party library is seen in one room only, and that no two headers give different types one name: the
linker would take the one's functions for the other's and say nothing. Prints each offence; exit status 1 if any.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Public headers that any room may include.
VALUES = ["error", "events", "geometry", "grid", "improvement", "mesh", "mesh_figures", "stop", "typed_text"]
# Those that speak of jobs and packings: for the rooms that know the model.
MODEL_VALUES = ["check", "disassembly", "job", "job_settings", "names", "option_table", "options", "orientations", "packing",
                "printers", "render"]

BASE = ["core", "values"]
MODEL = ["model", "model values"]
# The folders of the fast engine, each of which may include those before it.
CPU = ["search/cpu/tuning.hpp", "search/cpu/tables", "search/cpu/shapes", "search/cpu/scan", "search/cpu/free",
       "search/cpu"]
ALLOWED = {
    "core": ["values"],
    "geometry": BASE,
    "model": BASE + ["geometry", "model values"],
    "formats": BASE + ["geometry"] + MODEL,
    "voxel": BASE + ["geometry"],
    "render": BASE + ["geometry"] + MODEL,
    "verify": BASE + ["geometry"] + MODEL,  # judges the rest, so it shares nothing with it
    "search": BASE + ["geometry", "voxel"],
    "search/reference": BASE + ["geometry", "voxel", "search"],
    **{room: BASE + ["geometry", "voxel", "search"] + CPU[:i] for i, room in enumerate(CPU)},
    "search/cuda": BASE + ["geometry", "voxel", "search"],
    "refine": BASE + ["geometry", *MODEL, "voxel", "search"],
    "disassembly": BASE + ["geometry", *MODEL, "voxel", "search"],
    "packing": BASE + ["geometry", *MODEL, "voxel", "search", "refine", "disassembly"],
    "api": BASE + ["geometry", *MODEL, "formats", "voxel", "render", "verify", "search",
                   "search/reference", *CPU, "search/cuda", "refine", "disassembly", "packing", "spectralpack"],
    # Beside the product: on its public face, and on the rooms that all others stand on.
    "tools": BASE + ["geometry", "formats", "model values", "spectralpack", "tools face"],
    "values": [],
    "model values": ["values"],
    "spectralpack": ["values", "model values"],
    "tools face": ["values", "model values", "spectralpack"],
    "cli": ["values", "model values", "spectralpack", "tools face"],
    "python": ["values", "model values", "spectralpack", "tools face"],
    "server": ["values", "model values", "spectralpack", "tools face"],
    "docs": ["values", "model values", "spectralpack", "cli"],  # apps/docs
}

LIBRARIES = {  # pattern of the header -> the rooms that may see it
    r"tbb/": ["core"],
    r"fftw3": ["search/reference"],
    r"hwy/": CPU,
    r"cuda|cufft": ["search/cuda"],
    r"embree|png\.h|stb": ["render"],
    r"fcl/": ["verify"],
    r"zip\.h|expat\.h|tiny_obj|fast_float": ["formats"],
    r"nlohmann/": ["formats", "server"],
    r"boost/": ["server"],
    r"meshoptimizer": ["tools"],
    r"xxhash": ["api"],
    r"CLI/": ["cli", "docs"],
    r"pybind11/|Python\.h": ["python"],
}

TYPE = re.compile(r"^(?:class|struct|enum class|enum) (\w+)(?: final)?(?: :[^;{]*)? {", re.M)
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)


def room_of(path):
    parts = path.relative_to(ROOT).parts
    if parts[:3] == ("include", "spectralpack", "tools"):
        return "tools face"
    if parts[0] == "include":
        return "values" if path.stem in VALUES else "model values" if path.stem in MODEL_VALUES else "spectralpack"
    if parts[0] == "apps":
        return parts[1]
    if parts[0] == "python":
        return "python"
    if parts[1:3] == ("search", "cpu"):
        return next(room for room in CPU if "/".join(parts[1:]).startswith(room))
    if parts[1] == "search" and parts[2] in ("reference", "cuda"):
        return f"search/{parts[2]}"
    return parts[1]


def target_of(header, here):
    """The room a quoted or <spectralpack/...> header belongs to; None for the room's own neighbours."""
    for base in (ROOT / "src", ROOT / "include", ROOT / "apps", ROOT / "apps" / "server"):
        if (base / header).exists():
            return room_of(base / header)
    return None if (here.parent / header).exists() else "?"


def types_named_twice(files):
    """Types that several headers define in the same namespace."""
    where = {}
    for path in files:
        text = path.read_text()
        if path.suffix not in (".hpp", ".h") or "HWY_NAMESPACE" in text:
            continue
        namespace = re.search(r"^namespace ([\w:]+) {", text, re.M)
        for name in TYPE.findall(text):
            where.setdefault((namespace and namespace.group(1), name), []).append(str(path.relative_to(ROOT)))
    return [f"{name} is defined in {' and in '.join(paths)}" for (_, name), paths in where.items() if len(paths) > 1]


def main():
    offences = []
    files = [p for top in ("src", "include", "apps", "python") for p in sorted((ROOT / top).rglob("*"))
             if p.suffix in (".hpp", ".cpp", ".cu", ".h", ".cuh")]
    for path in files:
        room = room_of(path)
        for style, header in INCLUDE.findall(path.read_text()):
            where = f"{path.relative_to(ROOT)}: #include {header}"
            for pattern, rooms in LIBRARIES.items():
                if style == "<" and re.match(pattern, header) and room not in rooms:
                    offences.append(f"{where}: this library is seen only in {', '.join(rooms)}")
            if style == "<" and not header.startswith("spectralpack/"):
                continue
            target = target_of(header, path)
            if target == "?":
                offences.append(f"{where}: no such file")
            elif target not in (None, room) and target not in ALLOWED[room]:
                offences.append(f"{where}: {room} must not include {target}")
    offences += types_named_twice(files)
    print("\n".join(offences) if offences else f"includes of {len(files)} files point the right way")
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
