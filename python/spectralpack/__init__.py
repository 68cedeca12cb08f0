"""spectralpack: packs 3D objects of any shape densely into a build volume, so that they come apart again.

    import spectralpack as sp

    job = sp.Job(tray=(480, 245, 200), gap=1.0)
    job.add("bracket.stl", count=12)
    job.add(sp.Mesh(vertices, faces), count=3, orientations="upright")
    packing = sp.pack(job, progress=True)      # Ctrl-C returns the best so far
    packing.density, packing.placements        # a structured array: part, copy, tray, transform ...
    packing.check().ok, packing.plan.steps
    packing.save("build.3mf")

Lengths are millimetres. Errors are subclasses of Error, and of the built-in exception that fits.
"""

from __future__ import annotations

import os as _os
from typing import Any, Callable

from ._core import (
    CheckReport,
    Error,
    Finding,
    InputError,
    InternalError,
    Job,
    Mesh,
    Packing,
    Placement,
    Plan,
    Remark,
    ResourceError,
    Shape,
    Step,
    Tray,
    UsageError,
    __version__,
    distance,
    estimate,
    generate,
    options_help,
    orientation_set,
    printers,
    voxelize,
)
from . import _core, _show

__all__ = [
    "CheckReport", "Error", "Finding", "InputError", "InternalError", "Job", "Mesh", "Packing", "Placement", "Plan",
    "Remark", "ResourceError", "Shape", "Step", "Tray", "UsageError", "__version__", "distance", "estimate", "generate",
    "inspect", "load", "options_help", "orientation_set", "pack", "printers", "voxelize",
]



def pack(
    job: Job,
    progress: bool | Callable[[dict[str, Any]], object] = False,
    on_event: Callable[[dict[str, Any]], object] | None = None,
    journal: str | _os.PathLike[str] | None = None,
) -> Packing:
    """Packs a job. The same job gives the same placements on any machine and number of threads.

    progress: True shows a line on stderr; a callable gets a dict (phase, done, total, work, density, seconds), at most
    ten times a second. on_event: gets a dict for each copy that is placed, moved or taken out. journal: a file that a
    run which was killed goes on from.

    Ctrl-C, and the option time_limit, return the best so far; Packing.stopped says so. Inputs that cannot be used are
    remarks (warnings of the class Remark) and stand in Packing.unusable; the others are packed. Raises UsageError for
    options that make no sense, InputError when nothing can be used, ResourceError when memory does not suffice; what was
    done by then is the exception's `packing`, where there is something.
    """
    if not callable(progress):
        line = _show.ProgressLine() if progress else None
        try:
            return _core.pack(job, line, on_event, journal)
        finally:
            if line:
                line.end()
    return _core.pack(job, progress, on_event, journal)


def load(path: str | _os.PathLike[str]) -> Packing:
    """Reads a packing file (.json) and the meshes that it names. Raises InputError."""
    return Packing.load(path)


def inspect(*files: str | _os.PathLike[str], unit: float = 1.0, threads: int = 0) -> list[dict[str, Any]]:
    """What is in mesh files, and what is wrong with it: a dict for each file.

    Its `objects` have name, size (mm), volume, watertight, repairs, warnings and mesh; `unusable` is an InputError, or
    None. `unit`: mm per unit of files that do not say.
    """
    return _core._inspect([_os.fspath(file) for file in files], unit, threads)


setattr(Packing, "_repr_html_", _show.html_of)
