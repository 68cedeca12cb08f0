/// What a run does, in the words of the page. A phase that most runs do not have is shown once it has begun.

import type { Phase } from "../../api/types";
import { counted } from "./numbers";

interface PhaseWords {
  readonly phase: Phase;
  readonly text: string;
  readonly always: boolean;
}

const words: readonly PhaseWords[] = [
  { phase: "load", text: "Read the parts", always: true },
  { phase: "voxelize", text: "Prepare shapes", always: false },
  { phase: "search", text: "Place copies, slide them together", always: true },
  { phase: "disassemble", text: "Check that it comes apart", always: true },
  { phase: "reinsert", text: "Put back what was in the way", always: false },
  { phase: "improve", text: "Pack it better", always: false },
  { phase: "write", text: "Write the files", always: false },
  { phase: "check", text: "Measure every gap", always: true },
  { phase: "render", text: "Draw the picture", always: false },
];

/// "Check that it comes apart".
export function phaseText(phase: Phase): string {
  return words.find((entry) => entry.phase === phase)?.text ?? "";
}

export interface PhaseRow {
  readonly phase: Phase;
  readonly text: string;
  readonly state: "done" | "now" | "wait";
}

/// The rows of "What happens now". `seen`: phases that have begun; `now`: the one that runs, null before the first.
export function phaseRows(seen: ReadonlySet<Phase>, now: Phase | null, parts: number): PhaseRow[] {
  const place = words.findIndex((entry) => entry.phase === now);
  return words
    .filter((entry) => entry.always || seen.has(entry.phase))
    .map((entry) => {
      const own = words.indexOf(entry);
      const state = own === place ? "now" : seen.has(entry.phase) || own < place ? "done" : "wait";
      return {
        phase: entry.phase,
        text: entry.phase === "load" ? `Read ${counted(parts, "part")}` : entry.text,
        state,
      };
    });
}
