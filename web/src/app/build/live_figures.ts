/// Figures of a run, from the boxes and volumes of the copies that stand: what its layers will come to, about.

import type { Mesh } from "../../api/types";
import type { Sides } from "../state/draft";
import { approximateLayers, type Body, type Layers } from "../state/layers";
import type { LiveCopy, LiveRun } from "../state/live_run";
import type { Session } from "../state/session";
import { type Extent, extentOf } from "../state/turns";
import type { BuildPart } from "./build_parts";

export interface LiveFigures {
  readonly standing: number;
  /// Of the tray that is shown.
  readonly density: number;
  readonly height: number;
  readonly layers: Layers | null;
}

/// A copy that moves is another object, so that its box is worked out once.
const extents = new WeakMap<LiveCopy, Extent>();

function extent(session: Session, copy: LiveCopy, mesh: Mesh): Extent {
  const known = extents.get(copy);
  if (known) return known;
  const box = mesh.box.map((corner) => corner.map((value) => value / mesh.unit));
  const positions = session.meshes.mesh(mesh)?.positions ?? null;
  const own = extentOf(copy.transform, box, positions);
  if (positions) extents.set(copy, own);
  return own;
}

/// `size`: of the tray; its height is how high the plot goes.
export function liveFigures(
  session: Session,
  live: LiveRun,
  parts: readonly BuildPart[],
  tray: number,
  size: Sides,
): LiveFigures {
  const byIndex = new Map(parts.map((part) => [part.index, part]));
  const bodies: Body[] = [];
  let height = 0;
  let volume = 0;
  for (const copy of live.trays.get(tray)?.copies.values() ?? []) {
    const part = byIndex.get(copy.part);
    if (!part?.mesh) continue;
    const own = extent(session, copy, part.mesh);
    bodies.push({ extent: own, volume: part.volume });
    height = Math.max(height, own.high[2]);
    volume += part.volume;
  }
  const base = size[0] * size[1];
  const room = base * Math.max(size[2], height);
  return {
    standing: live.standing,
    density: room > 0 ? volume / room : 0,
    height,
    layers: bodies.length > 0 && base > 0 ? approximateLayers(bodies, base, Math.max(size[2], height)) : null,
  };
}
