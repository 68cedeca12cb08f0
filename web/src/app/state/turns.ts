/// Where a copy stands and how it is turned, from its transform.

import type { Transform } from "../../view/view";
import type { Sides } from "./draft";

type Rows = readonly (readonly number[])[];

const at = (m: Rows, row: number, column: number): number => m[row]?.[column] ?? 0;

/// Without scale and translation.
function rotationOf(transform: Transform): number[][] {
  const column = [0, 1, 2].map((c) => Math.hypot(at(transform, 0, c), at(transform, 1, c), at(transform, 2, c)) || 1);
  return [0, 1, 2].map((r) => [0, 1, 2].map((c) => at(transform, r, c) / (column[c] ?? 1)));
}

/// Angles about three axes, made one after the other, whose product is the rotation; `order` "xyz": about X first.
function angles(r: number[][], order: readonly [number, number, number]): [number, number, number] {
  const [i, j, k] = order;
  const sign = (j - i + 3) % 3 === 1 ? 1 : -1;
  const s = Math.max(-1, Math.min(1, -sign * at(r, k, i)));
  const middle = Math.asin(s);
  if (Math.abs(s) > 1 - 1e-9) return [0, middle, Math.atan2(-sign * at(r, i, j), at(r, j, j))];
  return [Math.atan2(sign * at(r, k, j), at(r, k, k)), middle, Math.atan2(sign * at(r, j, i), at(r, i, i))];
}

const orders: readonly (readonly [number, number, number])[] = [
  [0, 1, 2],
  [2, 0, 1],
  [1, 2, 0],
  [0, 2, 1],
  [1, 0, 2],
  [2, 1, 0],
];

/// "as drawn", "turned 90° about X", "turned 90° about X, then 180° about Z": the fewest turns that say it.
export function standsWords(transform: Transform): string {
  const rotation = rotationOf(transform);
  let best: string[] | null = null;
  for (const order of orders) {
    const turns = angles(rotation, order)
      .map((angle, place) => ({ degrees: Math.round((angle * 180) / Math.PI), axis: "XYZ"[order[place] ?? 0] ?? "" }))
      .filter(({ degrees }) => degrees % 360 !== 0)
      .map(({ degrees, axis }) => `${degrees === -180 ? 180 : degrees}° about ${axis}`);
    if (!best || turns.length < best.length) best = turns;
  }
  return best?.length ? `turned ${best.join(", then ").replaceAll("-", "−")}` : "as drawn";
}

export interface Extent {
  readonly low: Sides;
  readonly high: Sides;
}

function apply(m: Transform, x: number, y: number, z: number, row: number): number {
  return at(m, row, 0) * x + at(m, row, 1) * y + at(m, row, 2) * z + at(m, row, 3);
}

/// Every axis goes to an axis: the box of the turned mesh is the turned box.
function rightAngled(transform: Transform): boolean {
  return rotationOf(transform).every((row) => row.every((v) => Math.abs(v) < 1e-9 || Math.abs(v) > 1 - 1e-9));
}

/// The box that a copy takes in its tray. `box`: the mesh's, in the file's own unit. `positions`: its vertices, for turns
/// by other than right angles, where the corners of the box would say too much.
export function extentOf(
  transform: Transform,
  box: readonly (readonly number[])[],
  positions: Float32Array | null,
): Extent {
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  const add = (x: number, y: number, z: number) => {
    for (let row = 0; row < 3; row += 1) {
      const value = apply(transform, x, y, z, row);
      if (value < (low[row] ?? 0)) low[row] = value;
      if (value > (high[row] ?? 0)) high[row] = value;
    }
  };
  if (positions && positions.length > 0 && !rightAngled(transform)) {
    for (let i = 0; i + 2 < positions.length; i += 3) {
      add(positions[i] ?? 0, positions[i + 1] ?? 0, positions[i + 2] ?? 0);
    }
  } else {
    for (let corner = 0; corner < 8; corner += 1) {
      add(at(box, corner & 1, 0), at(box, (corner >> 1) & 1, 1), at(box, (corner >> 2) & 1, 2));
    }
  }
  return { low, high };
}

/// The way a step goes, by its last move: "up", "to the back".
export function wayWords(path: readonly (readonly number[])[]): string {
  const words = path.map(directionWords).filter((word, i, all) => word !== all[i - 1]);
  if (words.length === 0) return "it stands alone by then";
  if (words.length > 3) return `${words.length} moves, last ${words[words.length - 1]}`;
  return words.join(", then ");
}

function directionWords(move: readonly number[]): string {
  const [x = 0, y = 0, z = 0] = move;
  const most = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
  if (Math.abs(z) === most) return z > 0 ? "up" : "down";
  if (Math.abs(x) === most) return x > 0 ? "to the right" : "to the left";
  return y > 0 ? "to the back" : "to the front";
}
