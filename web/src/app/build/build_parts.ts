/// The parts of a build, live or done, by the index that its copies name.

import type { Mesh } from "../../api/types";
import { meshFinder, nameOf } from "../parts/rows";
import type { PackedTray, Packing } from "../state/packing";
import type { Session } from "../state/session";

export interface BuildPart {
  readonly index: number;
  readonly name: string;
  /// How many were asked for.
  readonly count: number;
  /// mm³ of one copy.
  readonly volume: number;
  readonly mesh: Mesh | null;
}

/// While it packs: those of the draft, which is locked meanwhile. Copies that a job fixes come before them.
export function liveParts(session: Session): BuildPart[] {
  const { draft, parts } = session;
  const meshOf = meshFinder(parts.meshes);
  const fixed = Array.isArray(draft.fixed) ? draft.fixed.length : 0;
  return draft.parts.map((part, i) => {
    const mesh = meshOf(part);
    const by = mesh ? (part.unit && !mesh.unit_known ? unitOf(part.unit) / mesh.unit : 1) * part.scale : 1;
    return {
      index: i + fixed,
      name: nameOf(part, mesh),
      count: part.count,
      volume: (mesh?.volume ?? 0) * by ** 3,
      mesh,
    };
  });
}

const unitOf = (unit: "mm" | "inch" | "m"): number => (unit === "inch" ? 25.4 : unit === "m" ? 1000 : 1);

export function packedParts(session: Session, packing: Packing): BuildPart[] {
  const { meshes } = session.parts;
  const byName = new Map(meshes.map((mesh) => [`${mesh.file}\n${mesh.object ?? ""}`, mesh]));
  const byFile = new Map(meshes.map((mesh) => [mesh.file, mesh]));
  return packing.parts.map((part) => ({
    index: part.index,
    name: part.name,
    count: part.count,
    volume: part.volume,
    mesh: byName.get(`${part.file}\n${part.object ?? ""}`) ?? byFile.get(part.file) ?? null,
  }));
}

/// The draft's part that a packed part came from, where it is still there.
export function draftKeyOf(session: Session, packing: Packing, index: number): string | null {
  const part = packing.parts[index];
  if (!part) return null;
  const same = session.draft.parts.filter((own) => own.file === part.file && (own.object ?? null) === part.object);
  return same[0]?.key ?? session.draft.parts.find((own) => own.file === part.file)?.key ?? null;
}

/// How many copies of each part stand in these trays.
export function placedCounts(trays: readonly PackedTray[]): Map<number, number> {
  const counts = new Map<number, number>();
  for (const tray of trays) {
    for (const { part } of tray.placements) counts.set(part, (counts.get(part) ?? 0) + 1);
  }
  return counts;
}

/// The trays that are looked at: one, or all.
export function shownTrays(packing: Packing, tray: number): readonly PackedTray[] {
  const one = packing.trays[tray - 1];
  return tray > 0 && one ? [one] : packing.trays;
}
