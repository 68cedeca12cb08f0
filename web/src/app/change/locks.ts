/// Copies that stay where they are when the rest is packed again. Kept in this browser for each job.

import { keep, kept } from "../state/kept";
import type { Packing, Placement } from "../state/packing";
import type { Locks } from "./build_history";
import { type TrayCopy, trayCopyId } from "./change";

export const keptLocks = (job: string): Locks => new Set(kept<string[]>(`locks.${job}`, []));

export const keepLocks = (job: string, locks: Locks): void => keep(`locks.${job}`, [...locks]);

export function copyOfId(id: string): TrayCopy {
  const [tray = 1, part = 0, copy = 0] = id.split("/").map(Number);
  return { tray, part, copy };
}

export function withLocks(locks: Locks, copies: readonly TrayCopy[], on: boolean): Locks {
  const next = new Set(locks);
  for (const copy of copies) {
    if (on) next.add(trayCopyId(copy));
    else next.delete(trayCopyId(copy));
  }
  return next.size === locks.size ? locks : next;
}

export function lockedIn(locks: Locks, tray: number): TrayCopy[] {
  return [...locks].map(copyOfId).filter((copy) => tray === 0 || copy.tray === tray);
}

/// All copies of a tray, or those of one part of it.
export function copiesOf(packing: Packing, tray: number, part: number | null = null): TrayCopy[] {
  const trays = tray === 0 ? packing.trays : packing.trays.filter((own) => own.number === tray);
  return trays.flatMap((own) =>
    own.placements
      .filter((placement) => part === null || placement.part === part)
      .map((placement) => ({ tray: own.number, part: placement.part, copy: placement.copy })),
  );
}

/// Locks of copies that are not there any more say nothing.
export function standing(locks: Locks, packing: Packing): Locks {
  const still = [...locks].filter((id) => {
    const { tray, part, copy } = copyOfId(id);
    return packing.trays[tray - 1]?.byId.has(`${part}/${copy}`);
  });
  return still.length === locks.size ? locks : new Set(still);
}

/// After the rest was packed again, copies may have other numbers: a locked copy is the one of the same mesh that stands
/// where it stood.
export function followed(locks: Locks, before: Packing, after: Packing): Locks {
  const next = new Set<string>();
  for (const id of locks) {
    const { tray, part, copy } = copyOfId(id);
    const own = before.trays[tray - 1]?.byId.get(`${part}/${copy}`);
    const same = own && after.trays[tray - 1]?.placements.find((other) => sameCopy(before, own, after, other));
    if (same) next.add(trayCopyId({ tray, part: same.part, copy: same.copy }));
  }
  return next;
}

/// mm; transforms are written with more digits than this.
const near = 1e-4;

function sameCopy(before: Packing, one: Placement, after: Packing, other: Placement): boolean {
  const [a, b] = [before.parts[one.part], after.parts[other.part]];
  if (!a || !b || a.file !== b.file || a.object !== b.object) return false;
  return one.transform.every((row, i) =>
    row.every((value, j) => Math.abs(value - (other.transform[i]?.[j] ?? Number.NaN)) < near),
  );
}
