/// A packing file as the page needs it (docs/format.md).

import type { CopyKey, Transform } from "../../view/view";
import type { Sides } from "./draft";
import { baseName } from "./job_file_read";
import type { Layers } from "./layers";
import { copyId } from "./live_run";

export interface PackedPart {
  readonly index: number;
  readonly name: string;
  readonly file: string;
  readonly object: string | null;
  readonly count: number;
  readonly volume: number;
  readonly stands: string;
}

export interface Placement extends CopyKey {
  /// Index into the tray's placements, and the order that they were placed in.
  readonly index: number;
  readonly transform: Transform;
  readonly fixed: boolean;
  /// The step of the way out that it leaves at, from 1 on; null where it has none.
  readonly step: number | null;
  readonly path: readonly Sides[];
  /// How many leave together at that step.
  readonly together: number;
}

/// A step of a way out, as the file has it: which placements move as one, and along which moves, one after the other.
export interface PackedStep {
  readonly placements: readonly number[];
  readonly path: readonly Sides[];
  /// It leads through the container's walls or its keep-outs.
  readonly throughWalls: boolean;
}

export interface PackedTray {
  readonly number: number;
  readonly placements: readonly Placement[];
  readonly byId: ReadonlyMap<string, Placement>;
  readonly density: number;
  readonly height: number;
  readonly layers: Layers | null;
  readonly steps: number;
  readonly plan: readonly PackedStep[];
  readonly complete: boolean;
  readonly throughWalls: number;
}

/// What the server says of a copy that was taken out.
export const takenOutDetail = "taken out by hand";

export type Reason = "no_place" | "too_large" | "cannot_leave" | "cap" | "not_tried" | "bad_file";

export interface LeftOver {
  readonly part: number;
  readonly reason: Reason;
  readonly copies: number;
  readonly detail: string;
  /// Their numbers.
  readonly which: readonly number[];
  /// Taken out by hand: they can be put back.
  readonly byHand: boolean;
}

export interface Packing {
  readonly size: Sides;
  readonly openHeight: boolean;
  readonly keepOut: readonly (readonly [Sides, Sides])[];
  readonly parts: readonly PackedPart[];
  readonly trays: readonly PackedTray[];
  readonly leftOver: readonly LeftOver[];
  readonly options: { readonly [name: string]: unknown };
  readonly copies: number;
  readonly placed: number;
  readonly density: number;
  readonly minGap: number | null;
  readonly seconds: number;
  /// What improving did, in words' raw material; null where it was not asked for.
  readonly improvement: { readonly what: string; readonly before: number; readonly now: number } | null;
}

/// The file as it is sent: only the keys that are read.
interface Raw {
  container: {
    size: number[];
    open_height?: boolean;
    keep_out?: { box?: number[][] }[];
  };
  options?: { [name: string]: unknown };
  parts: {
    name: string;
    mesh: string;
    object?: string | null;
    count: number;
    volume: number;
    orientations?: unknown;
  }[];
  trays: RawTray[];
  unplaced?: RawLeftOver[];
  metrics: {
    copies: number;
    placed: number;
    density: number;
    min_gap: number | null;
    seconds?: { total?: number };
    improvement?: { what: string; before: number; now: number } | null;
  };
}

interface RawLeftOver {
  part: number;
  copy: number;
  reason: Reason;
  detail?: string;
}

interface RawTray {
  placements: { part: number; copy: number; fixed?: boolean; transform: number[][] }[];
  density: number;
  height: number;
  layers?: { thickness: number; area: number[] } | null;
  disassembly?: {
    complete: boolean;
    steps: { placements: number[]; path: number[][] }[];
    through_walls?: number[];
  } | null;
}

export function readPacking(file: unknown): Packing {
  const raw = file as Raw;
  const size = sides(raw.container.size);
  return {
    size,
    openHeight: raw.container.open_height === true,
    keepOut: (raw.container.keep_out ?? []).flatMap(({ box }) =>
      box ? [[sides(box[0] ?? []), sides(box[1] ?? [])] as const] : [],
    ),
    parts: raw.parts.map((part, index) => ({
      index,
      name: part.name,
      file: baseName(part.mesh),
      object: part.object ?? null,
      count: part.count,
      volume: part.volume,
      stands: typeof part.orientations === "string" ? part.orientations : "",
    })),
    trays: raw.trays.map((tray, index) => readTray(tray, index + 1, size[0] * size[1])),
    leftOver: leftOverOf(raw.unplaced ?? []),
    options: raw.options ?? {},
    copies: raw.metrics.copies,
    placed: raw.metrics.placed,
    density: raw.metrics.density,
    minGap: raw.metrics.min_gap,
    seconds: raw.metrics.seconds?.total ?? 0,
    improvement: raw.metrics.improvement ?? null,
  };
}

function readTray(raw: RawTray, number: number, base: number): PackedTray {
  const steps = raw.disassembly?.steps ?? [];
  const leaves = new Map<number, number>();
  steps.forEach((step, index) => {
    for (const placement of step.placements) if (!leaves.has(placement)) leaves.set(placement, index);
  });
  const placements = raw.placements.map((placement, index): Placement => {
    const step = leaves.get(index);
    const taken = step === undefined ? undefined : steps[step];
    return {
      index,
      part: placement.part,
      copy: placement.copy,
      transform: placement.transform,
      fixed: placement.fixed === true,
      step: step === undefined ? null : step + 1,
      path: (taken?.path ?? []).map(sides),
      together: taken?.placements.length ?? 0,
    };
  });
  return {
    number,
    placements,
    byId: new Map(placements.map((placement) => [copyId(placement), placement])),
    density: raw.density,
    height: raw.height,
    layers: raw.layers
      ? { thickness: raw.layers.thickness, share: raw.layers.area.map((area) => area / base), exact: true }
      : null,
    steps: steps.length,
    plan: steps.map((step, index) => ({
      placements: step.placements,
      path: step.path.map(sides),
      throughWalls: raw.disassembly?.through_walls?.includes(index) ?? false,
    })),
    complete: raw.disassembly?.complete === true,
    throughWalls: raw.disassembly?.through_walls?.length ?? 0,
  };
}

/// Copies of a part that were left over for the same reason are one row.
function leftOverOf(unplaced: readonly RawLeftOver[]): LeftOver[] {
  const rows = new Map<string, LeftOver>();
  for (const { part, copy, reason, detail = "" } of unplaced) {
    const byHand = detail === takenOutDetail;
    const key = `${part}/${reason}/${byHand}`;
    const which = [...(rows.get(key)?.which ?? []), copy];
    rows.set(key, { part, reason, copies: which.length, detail: rows.get(key)?.detail || detail, which, byHand });
  }
  return [...rows.values()];
}

function sides(values: readonly number[]): Sides {
  return [values[0] ?? 0, values[1] ?? 0, values[2] ?? 0];
}
