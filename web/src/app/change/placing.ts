/// Where a copy that is moved by hand stands: shifted along the axes, turned by right angles about its own middle.

import type { Mesh } from "../../api/types";
import type { Axis, MeshData, Transform } from "../../view/view";
import type { Sides } from "../state/draft";
import { type Extent, extentOf } from "../state/turns";

/// `mesh`: the part's; `data`: its vertices, where they are there.
export function extentIn(transform: Transform, mesh: Mesh, data: MeshData | null): Extent {
  const box = mesh.box.map((corner) => corner.map((value) => value / mesh.unit));
  return extentOf(transform, box, data?.positions ?? null);
}

export function shifted(transform: Transform, by: Sides): Transform {
  return transform.map((row, i) => (i < 3 ? [...row.slice(0, 3), (row[3] ?? 0) + (by[i] ?? 0)] : row));
}

/// From one place towards another; how it is turned stays.
export function between(from: Transform, to: Transform, share: number): Transform {
  return to.map((row, i) =>
    i < 3 ? [...row.slice(0, 3), (from[i]?.[3] ?? 0) * (1 - share) + (row[3] ?? 0) * share] : row,
  );
}

export function sameTurn(a: Transform, b: Transform): boolean {
  return a.every((row, i) => row.slice(0, 3).every((value, j) => Math.abs(value - (b[i]?.[j] ?? 0)) < 1e-9));
}

export function sameTransform(a: Transform | null, b: Transform | null): boolean {
  if (a === null || b === null) return a === b;
  return sameTurn(a, b) && a.every((row, i) => Math.abs((row[3] ?? 0) - (b[i]?.[3] ?? 0)) < 1e-7);
}

/// mm from one to the other.
export function way(from: Transform, to: Transform): Sides {
  const along = (i: number) => (to[i]?.[3] ?? 0) - (from[i]?.[3] ?? 0);
  return [along(0), along(1), along(2)];
}

const rows: Readonly<Record<Axis, readonly [number, number]>> = { x: [1, 2], y: [2, 0], z: [0, 1] };

/// By 90° about an axis through a point; whole numbers stay whole.
export function quarterTurn(transform: Transform, axis: Axis, about: Sides): Transform {
  const moved = shifted(transform, [-about[0], -about[1], -about[2]]);
  const [i, j] = rows[axis];
  const turned = moved.map((row, k) => {
    if (k === i) return (moved[j] ?? []).map((value) => -value);
    return k === j ? (moved[i] ?? []) : row;
  });
  return shifted(turned, about).map((row) => row.map((value) => (Object.is(value, -0) ? 0 : value)));
}

export function middleOf({ low, high }: Extent): Sides {
  return [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2];
}

/// Two boxes meet, or come nearer than so many mm.
export function boxesMeet(a: Extent, b: Extent, gap = 0): boolean {
  return a.low.every((low, i) => low < (b.high[i] ?? 0) + gap && (b.low[i] ?? 0) < (a.high[i] ?? 0) + gap);
}
