/// What is to be packed, and how: the one document that the page edits. It is never changed, only replaced, so that
/// undo is a list of documents. A job file says the same (job_file_write.ts, job_file_read.ts).

import type { Json, Unit } from "../../api/types";

export type AxisName = "+x" | "-x" | "+y" | "-y" | "+z" | "-z";

/// How copies of a part may stand. Matrices come from job files only; the page keeps them and says so.
export type Stands =
  | { readonly kind: "any" | "upright" | "fixed" }
  | { readonly kind: "axes"; readonly axes: readonly AxisName[]; readonly yaw: number | null }
  | { readonly kind: "matrices"; readonly matrices: Json };

export interface DraftPart {
  /// Tells parts apart, also of the same mesh; stays as long as the part.
  readonly key: string;
  readonly file: string;
  /// One of several in a 3MF, as the server names it.
  readonly object: string | null;
  /// Null: the mesh's own.
  readonly name: string | null;
  readonly count: number;
  readonly scale: number;
  /// Null: what the file says, else the job's. "mm" said here also means: it was looked at, and is right.
  readonly unit: Unit | null;
  readonly stands: Stands;
  /// mm; null: the build's.
  readonly gap: number | null;
  readonly priority: number;
  readonly due: string | null;
  readonly order: string | null;
  readonly value: number | null;
}

export type Sides = readonly [number, number, number];

export type TrayChoice =
  | { readonly kind: "printer"; readonly name: string }
  | { readonly kind: "box"; readonly size: Sides }
  | {
      readonly kind: "mesh";
      readonly file: string | null;
      readonly is: "solid" | "vessel" | null;
      readonly unit: Unit | null;
      readonly transform: Json;
    };

export type KeepOut =
  | { readonly box: readonly [Sides, Sides] }
  | { readonly mesh: string; readonly transform: Json; readonly unit: Unit | null };

/// lowest: all copies as low as possible; fill: as much into a tray as goes; box: the least box that holds all.
export type Goal = "lowest" | "fill" | "box";

export interface Draft {
  readonly parts: readonly DraftPart[];
  readonly unit: Unit;
  readonly tray: TrayChoice;
  readonly openHeight: boolean;
  readonly trays: number | "all";
  readonly keepOut: readonly KeepOut[];
  /// Null: the printer's, else the program's.
  readonly gap: number | null;
  readonly wallGap: number | null;
  readonly goal: Goal;
  /// Seconds; null: none.
  readonly timeLimit: number | null;
  readonly material: string;
  /// Walls and keep-outs are really there; of a box or a mesh.
  readonly physical: boolean;
  /// All other options, by name, as a job file holds them.
  readonly options: { readonly [name: string]: Json };
  /// Copies that stand where they are; the page keeps them as they came.
  readonly fixed: Json;
}

export const usualTray: Sides = [480, 245, 200];

export const emptyDraft: Draft = {
  parts: [],
  unit: "mm",
  tray: { kind: "box", size: usualTray },
  openHeight: false,
  trays: 1,
  keepOut: [],
  gap: null,
  wallGap: null,
  goal: "lowest",
  timeLimit: null,
  material: "",
  physical: false,
  options: {},
  fixed: null,
};

export const anyWay: Stands = { kind: "any" };

export function newPart(file: string, object: string | null, key: string): DraftPart {
  return {
    key,
    file,
    object,
    name: null,
    count: 1,
    scale: 1,
    unit: null,
    stands: anyWay,
    gap: null,
    priority: 0,
    due: null,
    order: null,
    value: null,
  };
}

/// A key that none of `taken` has: the mesh's name, and a number where it is there more than once.
export function freeKey(file: string, object: string | null, taken: ReadonlySet<string>): string {
  const base = object === null ? file : `${file}#${object}`;
  if (!taken.has(base)) return base;
  let number = 2;
  while (taken.has(`${base}*${number}`)) number += 1;
  return `${base}*${number}`;
}

/// One tray holds all: without a ceiling, and for the least box.
export function holdsAllInOne(draft: Draft): boolean {
  return draft.openHeight || draft.goal === "box";
}

/// The least box is sought for boxes only, without keep-outs.
export function canSeekBox(draft: Draft): boolean {
  return draft.tray.kind !== "mesh" && draft.keepOut.length === 0;
}

export function totalCopies(draft: Draft): number {
  return draft.parts.reduce((sum, part) => sum + part.count, 0);
}
