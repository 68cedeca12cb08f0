/// What the parts of the "Take apart" page ask of the open job: its tray, the plan, names, boxes, and ways.

import { type BuildPart, packedParts } from "../build/build_parts";
import type { Plan } from "../state/apart_plan";
import { Ways } from "../state/apart_ways";
import { copyId } from "../state/live_run";
import type { PackedTray, Packing, Placement } from "../state/packing";
import type { Session } from "../state/session";
import { type Extent, extentOf } from "../state/turns";

export interface Apart {
  readonly packing: Packing;
  readonly tray: PackedTray;
  readonly plan: Plan;
  readonly parts: readonly BuildPart[];
  readonly partOf: (placement: number) => BuildPart | null;
  /// "seal-ring-110 4"
  readonly nameOf: (placement: number) => string;
  /// By placement: the box that it takes in the packing; null where its mesh is not there.
  readonly extents: readonly (Extent | null)[];
  readonly ways: Ways;
  /// The meshes are there: boxes and ways say something.
  readonly measured: boolean;
}

/// `plan`: of that tray.
export function apartOf(session: Session, packing: Packing, tray: PackedTray, plan: Plan): Apart {
  const parts = packedParts(session, packing);
  const partOf = (index: number) => {
    const placement = tray.placements[index];
    return placement ? (parts[placement.part] ?? null) : null;
  };
  const extents = tray.placements.map(() => null);
  return {
    packing,
    tray,
    plan,
    parts,
    partOf,
    nameOf: (index) => `${partOf(index)?.name ?? "copy"} ${(tray.placements[index]?.copy ?? 0) + 1}`,
    extents,
    ways: new Ways({ plan, placements: tray.placements, extents, meshOf: () => null }),
    measured: false,
  };
}

/// Once the meshes are there.
export function measured(session: Session, apart: Apart): Apart {
  const { plan, parts } = apart;
  const { placements } = apart.tray;
  const extents = placements.map((placement) => extentIn(session, placement, parts[placement.part] ?? null));
  const meshOf = (part: number) => {
    const mesh = parts[part]?.mesh;
    return mesh ? session.meshes.mesh(mesh) : null;
  };
  return { ...apart, extents, ways: new Ways({ plan, placements, extents, meshOf }), measured: true };
}

function extentIn(session: Session, placement: Placement, part: BuildPart | null): Extent | null {
  const mesh = part?.mesh;
  if (!mesh) return null;
  const box = mesh.box.map((corner) => corner.map((value) => value / mesh.unit));
  return extentOf(placement.transform, box, session.meshes.mesh(mesh)?.positions ?? null);
}

/// The copy that is selected, where it stands in this tray: of several the one that was selected last.
export function selectedIn(session: Session, tray: PackedTray): Placement | null {
  const copy = session.build.value.selected.at(-1);
  return copy ? (tray.byId.get(copyId(copy)) ?? null) : null;
}

export function select(session: Session, placement: Placement | null): void {
  session.build.set({ selected: placement ? [{ part: placement.part, copy: placement.copy }] : [] });
}
