/// Changes that are made to a packing by hand: where copies stand from now on. The page shows a packing with them before
/// the server has made and checked them.

import type { CopyKey, Transform } from "../../view/view";
import { copyId } from "../state/live_run";
import { type LeftOver, type PackedTray, type Packing, type Placement, takenOutDetail } from "../state/packing";

export interface TrayCopy extends CopyKey {
  /// From 1 on.
  readonly tray: number;
}

/// As the server takes it. `transform` null: it is taken out.
export interface CopyChange extends TrayCopy {
  readonly transform: Transform | null;
}

export const trayCopyId = (copy: TrayCopy): string => `${copy.tray}/${copy.part}/${copy.copy}`;

export function placementOf(packing: Packing | null, copy: TrayCopy): Placement | null {
  return packing?.trays[copy.tray - 1]?.byId.get(copyId(copy)) ?? null;
}

/// Both, one after the other: of every copy the last word counts.
export function merged(first: readonly CopyChange[], then: readonly CopyChange[]): readonly CopyChange[] {
  if (first.length === 0 || then.length === 0) return first.length === 0 ? then : first;
  const last = new Map<string, CopyChange>();
  for (const change of [...first, ...then]) {
    // What is said last also comes last, so that a place is free before another copy takes it.
    last.delete(copyId(change));
    last.set(copyId(change), change);
  }
  return [...last.values()];
}

/// What takes these changes of this packing back.
export function inverseOf(packing: Packing, changes: readonly CopyChange[]): CopyChange[] {
  return changes.map(({ tray, part, copy }) => ({
    tray,
    part,
    copy,
    transform: placementOf(packing, { tray, part, copy })?.transform ?? null,
  }));
}

/// The packing with the changes. Steps of moved copies, layers and heights are those from before: the server works them
/// out anew.
export function applyChanges(packing: Packing, changes: readonly CopyChange[]): Packing {
  if (changes.length === 0) return packing;
  const trays = packing.trays.map((tray) => {
    const own = changes.filter((change) => change.tray === tray.number);
    return own.length > 0 ? changedTray(packing, tray, own) : tray;
  });
  const placed = trays.reduce((sum, tray) => sum + tray.placements.length, 0);
  const before = packing.trays.reduce((sum, tray) => sum + volumeIn(packing, tray.placements), 0);
  const after = trays.reduce((sum, tray) => sum + volumeIn(packing, tray.placements), 0);
  return {
    ...packing,
    trays,
    placed,
    density: before > 0 ? (packing.density * after) / before : packing.density,
    leftOver: changedLeftOver(packing, changes),
  };
}

function changedTray(packing: Packing, tray: PackedTray, changes: readonly CopyChange[]): PackedTray {
  const byId = new Map(tray.byId);
  for (const change of changes) {
    const id = copyId(change);
    const before = byId.get(id);
    if (change.transform === null) byId.delete(id);
    else byId.set(id, { ...(before ?? newcomer(change, byId.size)), transform: change.transform, ...noWayOut });
  }
  const placements = [...byId.values()];
  const volume = volumeIn(packing, tray.placements);
  const share = volume > 0 ? volumeIn(packing, placements) / volume : 1;
  // The plan to take it apart is made anew, too.
  return { ...tray, placements, byId, density: tray.density * share, steps: 0, complete: false };
}

const noWayOut = { step: null, path: [], together: 0 } as const;

function newcomer({ part, copy }: CopyKey, index: number): Omit<Placement, "transform"> {
  return { part, copy, index, fixed: false, ...noWayOut };
}

function volumeIn(packing: Packing, placements: readonly Placement[]): number {
  return placements.reduce((sum, { part }) => sum + (packing.parts[part]?.volume ?? 0), 0);
}

/// Who is taken out is left over by hand; who is put back is not left over any more.
function changedLeftOver(packing: Packing, changes: readonly CopyChange[]): LeftOver[] {
  let rows = [...packing.leftOver];
  for (const change of changes) {
    const out = change.transform === null;
    if (out && !placementOf(packing, change)) continue;
    rows = out ? withCopy(rows, change) : rows.flatMap((row) => withoutCopy(row, change));
  }
  return rows;
}

function withCopy(rows: readonly LeftOver[], { part, copy }: CopyKey): LeftOver[] {
  const own = rows.find((row) => row.part === part && row.byHand);
  const fresh: LeftOver = own
    ? { ...own, copies: own.copies + 1, which: [...own.which, copy] }
    : { part, reason: "not_tried", copies: 1, detail: takenOutDetail, which: [copy], byHand: true };
  // What was taken out last stands first, where it is seen.
  return [fresh, ...rows.filter((row) => row !== own)];
}

function withoutCopy(row: LeftOver, { part, copy }: CopyKey): LeftOver[] {
  if (row.part !== part || !row.which.includes(copy)) return [row];
  const which = row.which.filter((other) => other !== copy);
  return which.length > 0 ? [{ ...row, which, copies: which.length }] : [];
}
