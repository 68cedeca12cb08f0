/// The tray that a draft asks for, and its gaps, with what the printer and the program fill in.

import type { Info, Mesh, Printer } from "../../api/types";
import type { Draft, Sides } from "./draft";

export function printerOf(draft: Draft, info: Info): Printer | null {
  const tray = draft.tray;
  return tray.kind === "printer" ? (info.printers.find((printer) => printer.name === tray.name) ?? null) : null;
}

/// Null where a mesh is to be filled and is not there.
export function traySize(draft: Draft, info: Info, meshes: readonly Mesh[]): Sides | null {
  const tray = draft.tray;
  if (tray.kind === "box") return tray.size;
  if (tray.kind === "printer") return (printerOf(draft, info)?.size as Sides | undefined) ?? null;
  const mesh = meshes.find((candidate) => candidate.file === tray.file);
  return (mesh?.size as Sides | undefined) ?? null;
}

export function gapOf(draft: Draft, info: Info): number {
  return draft.gap ?? printerOf(draft, info)?.gap ?? 0.2;
}

export function wallGapOf(draft: Draft, info: Info): number {
  return draft.wallGap ?? printerOf(draft, info)?.wall_gap ?? 0;
}

/// What is left between the walls; infinite upwards without a ceiling.
export function roomOf(draft: Draft, info: Info, meshes: readonly Mesh[]): Sides | null {
  const size = traySize(draft, info, meshes);
  if (!size) return null;
  const walls = 2 * wallGapOf(draft, info);
  const height = draft.openHeight ? Number.POSITIVE_INFINITY : size[2] - walls;
  return [size[0] - walls, size[1] - walls, height];
}
