"""What people see: a line of progress, and a packing in a notebook."""

from __future__ import annotations

import base64
import html
import sys
from typing import TYPE_CHECKING, Any, TextIO

if TYPE_CHECKING:
    from ._core import Packing

PHASES = {
    "load": "reading", "voxelize": "voxels", "search": "placing", "disassemble": "taking apart",
    "reinsert": "putting back", "improve": "improving", "check": "checking",
}


class ProgressLine:
    """One line that is written over; on what is no terminal, a line for each phase."""

    def __init__(self, stream: TextIO | None = None) -> None:
        self.stream = stream or sys.stderr
        self.phase = ""
        self.width = 0

    def __call__(self, progress: dict[str, Any]) -> None:
        name = PHASES.get(progress["phase"], progress["phase"])
        if not self.stream.isatty():
            if name != self.phase:
                print(f"{name} ...", file=self.stream, flush=True)
            self.phase = name
            return
        text = f"{name}: {progress['done']}/{progress['total']}" if progress["total"] else name
        if progress.get("now") is not None:
            text += f", {progress['what']} {progress['before']:.4g} -> {progress['now']:.4g}"
        elif progress["density"]:
            text += f", {100 * progress['density']:.1f} % filled"
        text += f", {progress['seconds']:.0f} s"
        print("\r" + text.ljust(self.width), end="", file=self.stream, flush=True)
        self.width = len(text)

    def end(self) -> None:
        if self.width:
            print(file=self.stream, flush=True)


def rows_of(packing: Packing) -> list[tuple[str, str]]:
    metrics, trays = packing.metrics, packing.trays
    size = " × ".join(f"{side:g}" for side in packing.size)
    rows = [("Placed", f"{metrics['placed']} of {metrics['copies']} copies"), ("Tray", f"{size} mm")]
    if len(trays) > 1:
        rows.append(("Trays", str(len(trays))))
    if packing.options["open_height"] or len(trays) == 1:
        rows.append(("Height", f"{packing.height:.1f} mm"))
    rows.append(("Filled", f"{100 * packing.density:.1f} %"))
    if metrics["min_gap"] is not None:
        rows.append(("Nearest copies", f"{metrics['min_gap']:.2f} mm apart"))
    plans = packing.plans
    if plans:
        apart = all(plan.complete for plan in plans)
        rows.append(("Comes apart", f"yes, in {sum(len(plan.steps) for plan in plans)} steps" if apart else "no"))
    rows.append(("Took", f"{metrics['seconds']['total']:.1f} s"))
    return rows


def html_of(packing: Packing) -> str:
    """A picture and the figures; nothing is loaded from elsewhere."""
    picture = base64.b64encode(packing._png(960, 640, 35.0, 28.0)).decode()
    rows = "".join(
        f"<tr><th style='text-align:left;font-weight:600;padding-right:1.5em'>{html.escape(name)}</th>"
        f"<td style='text-align:left'>{html.escape(value)}</td></tr>"
        for name, value in rows_of(packing)
    )
    return (
        "<div style='display:flex;flex-wrap:wrap;gap:24px;align-items:center'>"
        f"<img alt='packing' width='480' src='data:image/png;base64,{picture}'>"
        f"<table>{rows}</table></div>"
    )
