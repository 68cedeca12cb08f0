/// The rows of the parts list: what they show, and how high they are.

import type { Mesh } from "../../api/types";
import type { DraftPart } from "../state/draft";
import { partSize, partVolume } from "../state/part_size";
import { type Remark, remarksOf } from "../state/remarks";
import type { Session } from "../state/session";
import { roomOf } from "../state/tray_size";

export interface Row {
  readonly part: DraftPart;
  /// Its place in the draft, which is what its colour comes from.
  readonly index: number;
  readonly mesh: Mesh | null;
  readonly remarks: readonly Remark[];
}

export const rowHeight = 44;
export const remarkHeight = 26;

export const heightOf = (row: Row): number => rowHeight + row.remarks.length * remarkHeight;

export const nameOf = (part: DraftPart, mesh: Mesh | null): string =>
  part.name ?? mesh?.name ?? part.file.replace(/\.[^.]*$/, "");

/// Meshes by file and object, for long lists.
export function meshFinder(meshes: readonly Mesh[]): (part: DraftPart) => Mesh | null {
  const byName = new Map(meshes.map((mesh) => [`${mesh.file}\n${mesh.object ?? ""}`, mesh]));
  return (part) => byName.get(`${part.file}\n${part.object ?? ""}`) ?? null;
}

/// The last rows of a session, and what they were made of: lists of thousands are asked for with every scroll.
const made = new WeakMap<Session, { readonly of: readonly unknown[]; readonly rows: readonly Row[] }>();

export function rowsOf(session: Session): readonly Row[] {
  const of = [session.draft, session.parts, session.uploads.state.value.active];
  const last = made.get(session);
  if (last?.of.every((value, i) => value === of[i])) return last.rows;
  const rows = makeRows(session);
  made.set(session, { of, rows });
  return rows;
}

function makeRows(session: Session): Row[] {
  const { draft, info, parts } = session;
  const room = roomOf(draft, info, parts.meshes);
  const meshOf = meshFinder(parts.meshes);
  const reading = parts.reading > 0 || session.uploads.state.value.active;
  return draft.parts.map((part, index) => {
    const mesh = meshOf(part);
    return { part, index, mesh, remarks: remarksOf({ part, mesh, draft, room, reading }) };
  });
}

export function found(rows: readonly Row[], find: string | null): readonly Row[] {
  const words = (find ?? "").trim().toLowerCase();
  if (words === "") return rows;
  return rows.filter(({ part, mesh }) =>
    `${nameOf(part, mesh)} ${part.file} ${part.order ?? ""}`.toLowerCase().includes(words),
  );
}

/// Copies of parts whose files are there: those that will be packed.
export function copiesThere(rows: readonly Row[]): number {
  return rows.reduce((sum, { part, mesh }) => sum + (mesh ? part.count : 0), 0);
}

export function totalVolume(rows: readonly Row[], session: Session): number {
  return rows.reduce((sum, { part, mesh }) => sum + (mesh ? partVolume(part, mesh, session.draft) * part.count : 0), 0);
}

export function sizeOf(row: Row, session: Session): readonly number[] | null {
  return row.mesh ? partSize(row.part, row.mesh, session.draft) : null;
}
