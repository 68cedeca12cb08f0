/// Files that were just read, taken into the draft: meshes become parts, set files say counts, a job file says all.

import type { JsonObject, Mesh, Parts, SetFile } from "../../api/types";
import { type Draft, type DraftPart, freeKey, newPart } from "./draft";
import { addParts } from "./draft_edit";
import { fromJobFile } from "./job_file_read";
import { partsOfCsv, partsOfRows } from "./set_file";

/// Nothing more of them will come: they are meshes, sets, or bad files now.
export function known(parts: Parts): Set<string> {
  return new Set([
    ...parts.meshes.map((mesh) => mesh.file),
    ...parts.bad.map((bad) => bad.file),
    ...parts.sets.map((set) => set.file),
  ]);
}

export const isPlan = (name: string): boolean => /\.(csv|json)$/i.test(name);

/// The texts of set files, by name, as far as they could be had.
export type Texts = ReadonlyMap<string, string>;

export function takeIn(draft: Draft, parts: Parts, fresh: ReadonlySet<string>, texts: Texts): Draft {
  const plans = parts.sets.filter((set) => fresh.has(set.file));
  let next = draft;
  for (const plan of plans) next = takePlan(next, plan, parts.meshes, texts);
  // Where a plan came along, it says what is packed; meshes that it does not name stay left out.
  if (plans.length > 0) return next;
  return addParts(next, newParts(next, parts.meshes, fresh));
}

function newParts(draft: Draft, meshes: readonly Mesh[], fresh: ReadonlySet<string>): DraftPart[] {
  const taken = new Set(draft.parts.map((part) => part.key));
  return leftOut(draft, meshes)
    .filter((mesh) => fresh.has(mesh.file))
    .map((mesh) => partOf(mesh, taken));
}

/// A part for a mesh: as often as its file holds it.
export function partOf(mesh: Mesh, taken: Set<string>): DraftPart {
  const key = freeKey(mesh.file, mesh.object, taken);
  taken.add(key);
  return { ...newPart(mesh.file, mesh.object, key), count: Math.max(1, mesh.instances) };
}

function takePlan(draft: Draft, plan: SetFile, meshes: readonly Mesh[], texts: Texts): Draft {
  if (plan.kind === "job") return plan.job ? fromJobFile(plan.job as JsonObject, meshes) : draft;
  const text = texts.get(plan.file);
  const none = new Set<string>();
  const rows = (text === undefined ? null : partsOfCsv(text, meshes, none)) ?? partsOfRows(plan, meshes, none);
  // Parts that are there already take what the set says of them.
  const said = new Map(rows.map((row) => [row.key, row]));
  const kept = draft.parts.map((part) => said.get(part.key) ?? part);
  const there = new Set(draft.parts.map((part) => part.key));
  return { ...draft, parts: [...kept, ...rows.filter((row) => !there.has(row.key))] };
}

/// Meshes that are on the server and not in the draft, nor used by it as container or keep-out.
export function leftOut(draft: Draft, meshes: readonly Mesh[]): Mesh[] {
  const used = new Set<string>();
  if (draft.tray.kind === "mesh" && draft.tray.file !== null) used.add(draft.tray.file);
  for (const keepOut of draft.keepOut) if ("mesh" in keepOut) used.add(keepOut.mesh);
  const named = new Set(draft.parts.map((part) => `${part.file}\n${part.object ?? ""}`));
  return meshes.filter((mesh) => !used.has(mesh.file) && !named.has(`${mesh.file}\n${mesh.object ?? ""}`));
}
