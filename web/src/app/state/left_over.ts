/// Why copies were left over, and what helps: one remedy each, which changes the draft and packs again, or leads back to
/// the part.

import { count, percent, size as sizeText } from "../words/numbers";
import { sentence } from "../words/sentence";
import { duration } from "../words/times";
import { anyWay, type Draft, holdsAllInOne, type Sides } from "./draft";
import { setOption } from "./draft_edit";
import type { LeftOver, Packing } from "./packing";

export interface Remedy {
  readonly text: string;
  /// Packs again with this; null: leads to the part in the list.
  readonly draft: Draft | null;
}

export interface LeftOverWords {
  readonly text: string;
  readonly remedy: Remedy;
}

const change: Remedy = { text: "Change the part", draft: null };

/// `key`: the part's in the draft, where it is still there.
export function leftOverWords(row: LeftOver, packing: Packing, draft: Draft, key: string | null): LeftOverWords {
  switch (row.reason) {
    case "no_place":
      return { text: row.detail ? sentence(row.detail) : "No free place left.", remedy: oneTrayMore(packing, draft) };
    case "cannot_leave":
      return { text: "Held by other copies, and no other place left.", remedy: oneTrayMore(packing, draft) };
    case "too_large":
      return tooLarge(row.detail, packing, draft, key);
    case "cap":
      return {
        text: capText(row.detail),
        remedy: { text: "Pack again without the cap", draft: withoutCaps(draft) },
      };
    case "not_tried":
      return { text: "The run ended before it was tried.", remedy: moreTime(draft) };
    case "bad_file":
      return {
        text: sentence(row.detail || "The file cannot be used"),
        remedy: { ...change, text: "Replace the file" },
      };
  }
}

function oneTrayMore(packing: Packing, draft: Draft): Remedy {
  if (holdsAllInOne(draft) || draft.trays === "all" || draft.options.fill === true) return change;
  const trays = Math.max(draft.trays, packing.trays.length) + 1;
  return { text: `Pack again with ${count(trays)} trays`, draft: { ...draft, trays } };
}

function moreTime(draft: Draft): Remedy {
  if (draft.timeLimit === null) return { text: "Pack again", draft };
  const longer = Math.max(60, draft.timeLimit * 2);
  return { text: `Pack again with ${duration(longer)}`, draft: { ...draft, timeLimit: longer } };
}

function withoutCaps(draft: Draft): Draft {
  return setOption(setOption(draft, "max-density", undefined), "max-layer-fill", undefined);
}

function capText(detail: string): string {
  const figure = /(\d*\.?\d+)/.exec(detail)?.[1];
  const share = figure === undefined ? Number.NaN : Number(figure);
  return share > 0 && share <= 1
    ? `The tray may be filled to ${percent(share, 0)} only.`
    : "The tray may not be filled more.";
}

/// The program's sentence: "413 x 247 x 28 mm, and there is room for 370 x 274 x 370 mm. It fits with --rotations 45".
function tooLarge(detail: string, packing: Packing, draft: Draft, key: string | null): LeftOverWords {
  const sizes = [...detail.matchAll(/([\d.]+) x ([\d.]+)(?: x ([\d.]+))? mm/g)].map(
    (match): Sides => [Number(match[1]), Number(match[2]), Number(match[3] ?? 0)],
  );
  const [own, room] = sizes;
  const text = own && room ? `${sizeText(own)}; the tray takes ${roomText(room, own)}.` : "Larger than the tray.";
  const rotations = /--rotations (\S+?)\.?$/.exec(detail)?.[1];
  const printer = /It fits into (.+): --printer (\S+?)\.?$/.exec(detail);
  if (detail.includes("as its orientations do") && key !== null) {
    const parts = draft.parts.map((part) => (part.key === key ? { ...part, stands: anyWay } : part));
    return { text, remedy: { text: "Let it stand any way", draft: { ...draft, parts } } };
  }
  if (rotations) {
    const words = /^\d+$/.test(rotations) ? `Turn parts in steps of ${rotations}°` : "Turn parts in finer steps";
    return { text, remedy: { text: words, draft: setOption(draft, "rotations", rotations) } };
  }
  if (printer?.[1] && printer[2]) {
    const tray = { kind: "printer", name: printer[2] } as const;
    return { text, remedy: { text: `Use ${printer[1]}`, draft: { ...draft, tray, gap: null, wallGap: null } } };
  }
  return { text: packing.openHeight ? "Larger than the tray's base." : text, remedy: change };
}

function roomText(room: Sides, own: Sides): string {
  return room[2] === 0 && own[2] !== 0 ? sizeText([room[0], room[1]]) : sizeText(room);
}
