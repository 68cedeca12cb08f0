/// What there is to say about a part of the list, beside it: one sentence each, with at most two things to do about it.

import type { Mesh } from "../../api/types";
import { counted, percent, size as sizeText } from "../words/numbers";
import { sentence } from "../words/sentence";
import type { Draft, DraftPart, Sides } from "./draft";
import { isTooLarge, onlyRightAngles, scaleThatFits } from "./fits";
import { partSize } from "./part_size";

export type RemarkAction =
  | { readonly do: "unit"; readonly unit: "inch" | "m" | "mm"; readonly text: string }
  | { readonly do: "scale"; readonly scale: number; readonly text: string }
  | { readonly do: "leave_out" | "replace" | "repairs"; readonly text: string };

export interface Remark {
  readonly tone: "info" | "warn" | "bad";
  readonly text: string;
  readonly actions: readonly RemarkAction[];
}

export interface RemarkInput {
  readonly part: DraftPart;
  readonly mesh: Mesh | null;
  readonly draft: Draft;
  readonly room: Sides | null;
  /// Files are still sent or read: what is not there may come.
  readonly reading: boolean;
}

const leaveOut = { do: "leave_out", text: "Leave out" } as const;
const replace = { do: "replace", text: "Replace" } as const;

export function remarksOf({ part, mesh, draft, room, reading }: RemarkInput): Remark[] {
  if (!mesh) {
    if (reading) return [];
    const which = part.object === null ? part.file : `Object ${part.object} of ${part.file}`;
    return [{ tone: "bad", text: `${which} is not there.`, actions: [replace, leaveOut] }];
  }
  return [tooLarge(part, mesh, draft, room), unitRemark(part, mesh, draft), faults(mesh), mended(mesh)].filter(
    (remark) => remark !== null,
  );
}

function tooLarge(part: DraftPart, mesh: Mesh, draft: Draft, room: Sides | null): Remark | null {
  if (!room || !onlyRightAngles(draft.options.rotations)) return null;
  const size = partSize(part, mesh, draft);
  if (!isTooLarge(size, part.stands, room)) return null;
  const fits = scaleThatFits(size, part.stands, room, part.scale);
  const any = !isTooLarge(size, { kind: "any" }, room);
  const where = part.stands.kind === "any" ? "in every position" : any ? "as it may stand" : "in every position";
  return {
    tone: "bad",
    text: `${sizeText(size)} is larger than the tray ${where}.`,
    actions: [
      ...(fits === null ? [] : [{ do: "scale" as const, scale: fits, text: `Scale to ${percent(fits, 0)}` }]),
      leaveOut,
    ],
  };
}

function unitRemark(part: DraftPart, mesh: Mesh, draft: Draft): Remark | null {
  if (mesh.unit_hint === null || mesh.unit_known || part.unit !== null || draft.unit !== "mm") return null;
  const longest = Math.max(...partSize(part, mesh, draft));
  if (longest >= 1000) {
    return {
      tone: "warn",
      text: `${(longest / 1000).toFixed(1)} m long: perhaps drawn in another unit.`,
      actions: [
        { do: "scale", scale: 0.001, text: `Scale to ${percent(0.001)}` },
        { do: "unit", unit: "mm", text: "Keep mm" },
      ],
    };
  }
  return {
    tone: "warn",
    text: `Only ${longest.toFixed(longest < 1 ? 2 : 1)} mm long: perhaps drawn in ${longest < 0.2 ? "metres" : "inches"}.`,
    actions: [
      longest < 0.2
        ? { do: "unit", unit: "m", text: "Read as metres" }
        : { do: "unit", unit: "inch", text: "Read as inches" },
      { do: "unit", unit: "mm", text: "Keep mm" },
    ],
  };
}

/// What the reader warns of, except the unit, which has a remark of its own.
function faults(mesh: Mesh): Remark | null {
  const said = mesh.warnings.filter((text) => text !== mesh.unit_hint && !text.includes("--unit"));
  if (said.length === 0) return null;
  return { tone: "warn", text: `${said.map(sentence).join(" ")}`, actions: [] };
}

function mended(mesh: Mesh): Remark | null {
  const told = mesh.repairs.filter((text) => !isRoutine(text));
  if (told.length === 0) return null;
  const first = sentence(told[0] ?? "");
  const rest = told.length > 1 ? ` ${counted(told.length - 1, "more thing")} mended.` : "";
  return { tone: "info", text: first + rest, actions: [{ do: "repairs", text: "See what changed" }] };
}

/// Every STL stores its vertices once a triangle; that they are merged is no news.
function isRoutine(repair: string): boolean {
  return /^(merged|welded) [\d\s]+ vert(ex|ices)/.test(repair);
}
