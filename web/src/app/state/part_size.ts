/// How large a part of the draft is, in mm.

import type { Mesh, Unit } from "../../api/types";
import type { Draft, DraftPart, Sides } from "./draft";

const millimetres: Readonly<Record<Unit, number>> = { mm: 1, inch: 25.4, m: 1000 };

/// mm that one unit of the mesh file comes to, with the part's scale. Units that the file says itself hold.
export function mmPerUnit(part: DraftPart, mesh: Mesh, draft: Draft): number {
  const unit = mesh.unit_known ? mesh.unit : millimetres[part.unit ?? draft.unit];
  return unit * part.scale;
}

/// The server's figures are in mm by the unit that it read the file with.
function factor(part: DraftPart, mesh: Mesh, draft: Draft): number {
  return mmPerUnit(part, mesh, draft) / mesh.unit;
}

export function partSize(part: DraftPart, mesh: Mesh, draft: Draft): Sides {
  const by = factor(part, mesh, draft);
  const [x = 0, y = 0, z = 0] = mesh.size;
  return [x * by, y * by, z * by];
}

export function partVolume(part: DraftPart, mesh: Mesh, draft: Draft): number {
  return mesh.volume * factor(part, mesh, draft) ** 3;
}
