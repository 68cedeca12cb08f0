/// Where copies stood that were taken out, kept in this browser: the server only says that they are out.

import type { Mesh } from "../../api/types";
import type { CopyKey, Transform } from "../../view/view";
import { keep, kept } from "../state/kept";
import { copyId } from "../state/live_run";
import type { Packing } from "../state/packing";
import { type CopyChange, placementOf, type TrayCopy } from "./change";

interface Place {
  readonly tray: number;
  readonly transform: Transform;
  /// The part's name: numbers of parts may mean others once parts were added.
  readonly name: string;
}

type Places = { readonly [copy: string]: Place };

const most = 300;

export function keepPlaces(job: string, packing: Packing, copies: readonly TrayCopy[]): void {
  const entries = Object.entries(kept<Places>(`places.${job}`, {}));
  for (const copy of copies) {
    const transform = placementOf(packing, copy)?.transform;
    const name = packing.parts[copy.part]?.name;
    if (transform && name !== undefined) entries.push([copyId(copy), { tray: copy.tray, transform, name }]);
  }
  keep(`places.${job}`, Object.fromEntries(entries.slice(-most)));
}

/// Where to put it back. `known`: it stood just there; else a place to begin from.
export function placeOf(
  job: string,
  packing: Packing,
  copy: CopyKey,
  mesh: Mesh | null,
): { change: CopyChange; known: boolean } {
  const own = kept<Places>(`places.${job}`, {})[copyId(copy)];
  if (own && own.name === packing.parts[copy.part]?.name && packing.trays[own.tray - 1]) {
    return { change: { tray: own.tray, part: copy.part, copy: copy.copy, transform: own.transform }, known: true };
  }
  const sibling = packing.trays.flatMap((tray) =>
    tray.placements.filter(({ part }) => part === copy.part).map((placement) => ({ tray: tray.number, placement })),
  )[0];
  // How a sibling stands is a way that it may stand.
  const transform = sibling?.placement.transform ?? asDrawn(packing, copy.part, mesh);
  return { change: { tray: sibling?.tray ?? 1, part: copy.part, copy: copy.copy, transform }, known: false };
}

/// As it lies in its file, in the corner of the tray. Its scale is told by its volume.
function asDrawn(packing: Packing, part: number, mesh: Mesh | null): Transform | null {
  const volume = packing.parts[part]?.volume ?? 0;
  if (!mesh || mesh.volume <= 0 || volume <= 0) return null;
  const own = Math.cbrt(volume / mesh.volume);
  const scale = own * mesh.unit;
  const low = (mesh.box[0] ?? []).map((value) => value * own);
  const row = (axis: number) => [0, 1, 2].map((i) => (i === axis ? scale : 0)).concat(-(low[axis] ?? 0));
  return [row(0), row(1), row(2), [0, 0, 0, 1]];
}
