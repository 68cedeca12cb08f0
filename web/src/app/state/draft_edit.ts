/// Changes of a draft, each a new draft.

import type { Json } from "../../api/types";
import { canSeekBox, type Draft, type DraftPart, type TrayChoice } from "./draft";

export type PartChange = Partial<Omit<DraftPart, "key" | "file" | "object">>;

export function changeParts(draft: Draft, keys: ReadonlySet<string>, change: PartChange): Draft {
  return { ...draft, parts: draft.parts.map((part) => (keys.has(part.key) ? { ...part, ...change } : part)) };
}

export function removeParts(draft: Draft, keys: ReadonlySet<string>): Draft {
  return { ...draft, parts: draft.parts.filter((part) => !keys.has(part.key)) };
}

export function renameFile(draft: Draft, from: string, to: string): Draft {
  if (!draft.parts.some((part) => part.file === from)) return draft;
  return { ...draft, parts: draft.parts.map((part) => (part.file === from ? { ...part, file: to } : part)) };
}

export function addParts(draft: Draft, parts: readonly DraftPart[]): Draft {
  return parts.length === 0 ? draft : { ...draft, parts: [...draft.parts, ...parts] };
}

export function setTray(draft: Draft, tray: TrayChoice): Draft {
  const next = { ...draft, tray };
  if (tray.kind === "mesh") return { ...next, openHeight: false, goal: draft.goal === "box" ? "fill" : draft.goal };
  return next;
}

export function addKeepOut(draft: Draft, keepOut: Draft["keepOut"][number]): Draft {
  const next = { ...draft, keepOut: [...draft.keepOut, keepOut], openHeight: false };
  return canSeekBox(next) || next.goal !== "box" ? next : { ...next, goal: "fill" as const };
}

/// Undefined: back to the default.
export function setOption(draft: Draft, name: string, value: Json | undefined): Draft {
  if (name === "height-at" && value === "top") return { ...without(draft, name), goal: "lowest" };
  const plain = name === "height-at" && draft.goal === "lowest" ? { ...draft, goal: "fill" as const } : draft;
  if (value === undefined) return without(plain, name);
  return { ...plain, options: { ...plain.options, [name]: value } };
}

export function getOption(draft: Draft, name: string): Json | undefined {
  if (name === "height-at" && draft.goal === "lowest") return "top";
  return draft.options[name];
}

function without(draft: Draft, name: string): Draft {
  const { [name]: _, ...options } = draft.options;
  return { ...draft, options };
}
