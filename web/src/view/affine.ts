/// Rigid motions with a scale, as twelve numbers: the three rows of the transform, without its last row (0 0 0 1).

import type { Size, Transform } from "./view";

export type Affine = readonly number[] | Float32Array | Float64Array;

/// Lower corner x y z, upper corner x y z.
export type Box = [number, number, number, number, number, number];

export const identity: Affine = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

export function emptyBox(): Box {
  return [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
}

export function isEmpty(box: Readonly<Box>): boolean {
  return !(box[0] <= box[3] && box[1] <= box[4] && box[2] <= box[5]);
}

export function grow(box: Box, other: Readonly<Box>): void {
  for (let i = 0; i < 3; ++i) {
    box[i] = Math.min(box[i] as number, other[i] as number);
    box[i + 3] = Math.max(box[i + 3] as number, other[i + 3] as number);
  }
}

export function growByPoint(box: Box, x: number, y: number, z: number): void {
  grow(box, [x, y, z, x, y, z]);
}

export function middle(box: Readonly<Box>): [number, number, number] {
  return [(box[0] + box[3]) / 2, (box[1] + box[4]) / 2, (box[2] + box[5]) / 2];
}

/// Writes the first three rows to `out[at..at+12]`. Whatever is missing counts as the identity's.
export function writeRows(transform: Transform, out: number[] | Float32Array | Float64Array, at = 0): void {
  for (let row = 0; row < 3; ++row) {
    for (let column = 0; column < 4; ++column) {
      out[at + 4 * row + column] = transform[row]?.[column] ?? (row === column ? 1 : 0);
    }
  }
}

export function toTransform(m: Affine): Transform {
  const row = (i: number) => [m[i] ?? 0, m[i + 1] ?? 0, m[i + 2] ?? 0, m[i + 3] ?? 0];
  return [row(0), row(4), row(8), [0, 0, 0, 1]];
}

export function apply(m: Affine, p: Size, at = 0): [number, number, number] {
  const out: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < 3; ++i) {
    const r = at + 4 * i;
    out[i] = (m[r] ?? 0) * p[0] + (m[r + 1] ?? 0) * p[1] + (m[r + 2] ?? 0) * p[2] + (m[r + 3] ?? 0);
  }
  return out;
}

/// Directions do not move with the translation.
export function applyDirection(m: Affine, d: Size, at = 0): [number, number, number] {
  const out: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < 3; ++i) {
    const r = at + 4 * i;
    out[i] = (m[r] ?? 0) * d[0] + (m[r + 1] ?? 0) * d[1] + (m[r + 2] ?? 0) * d[2];
  }
  return out;
}

/// The box of a turned box: exact for the box, at least as large as that of what is in it (Arvo 1990).
export function boxOf(m: Affine, box: Readonly<Box>, at = 0): Box {
  const out: Box = emptyBox();
  for (let i = 0; i < 3; ++i) {
    const r = at + 4 * i;
    let low = m[r + 3] ?? 0;
    let high = low;
    for (let j = 0; j < 3; ++j) {
      const a = (m[r + j] ?? 0) * (box[j] as number);
      const b = (m[r + j] ?? 0) * (box[j + 3] as number);
      low += Math.min(a, b);
      high += Math.max(a, b);
    }
    out[i] = low;
    out[i + 3] = high;
  }
  return out;
}

/// Below 0 of a mirror image.
export function determinant(m: Affine, at = 0): number {
  const v = (i: number) => m[at + i] ?? 0;
  return v(0) * (v(5) * v(10) - v(6) * v(9)) - v(1) * (v(4) * v(10) - v(6) * v(8)) + v(2) * (v(4) * v(9) - v(5) * v(8));
}

/// Null where the transform flattens.
export function invert(m: Affine, at = 0): Affine | null {
  const v = (i: number) => m[at + i] ?? 0;
  const a = v(0);
  const b = v(1);
  const c = v(2);
  const d = v(4);
  const e = v(5);
  const f = v(6);
  const g = v(8);
  const h = v(9);
  const i = v(10);
  const d3 = determinant(m, at);
  if (!(Math.abs(d3) > 1e-30)) return null;
  const s = 1 / d3;
  const r = [
    (e * i - f * h) * s,
    (c * h - b * i) * s,
    (b * f - c * e) * s,
    (f * g - d * i) * s,
    (a * i - c * g) * s,
    (c * d - a * f) * s,
    (d * h - e * g) * s,
    (b * g - a * h) * s,
    (a * e - b * d) * s,
  ];
  const n = (k: number) => r[k] ?? 0;
  const t = [v(3), v(7), v(11)];
  const move = (k: number) => -(n(k) * (t[0] ?? 0) + n(k + 1) * (t[1] ?? 0) + n(k + 2) * (t[2] ?? 0));
  return [n(0), n(1), n(2), move(0), n(3), n(4), n(5), move(3), n(6), n(7), n(8), move(6)];
}

/// First `b`, then `a`.
export function multiply(a: Affine, b: Affine): Affine {
  const out: number[] = [];
  for (let row = 0; row < 3; ++row) {
    for (let column = 0; column < 4; ++column) {
      let sum = column === 3 ? (a[4 * row + 3] ?? 0) : 0;
      for (let k = 0; k < 3; ++k) sum += (a[4 * row + k] ?? 0) * (b[4 * k + column] ?? 0);
      out.push(sum);
    }
  }
  return out;
}

/// Turned by `degrees` about an axis (of length 1) through `centre`.
export function turn(axis: Size, degrees: number, centre: Size): Affine {
  const [x, y, z] = axis;
  const c = Math.cos((degrees * Math.PI) / 180);
  const s = Math.sin((degrees * Math.PI) / 180);
  const k = 1 - c;
  const r = [
    x * x * k + c,
    x * y * k - z * s,
    x * z * k + y * s,
    0,
    y * x * k + z * s,
    y * y * k + c,
    y * z * k - x * s,
    0,
    z * x * k - y * s,
    z * y * k + x * s,
    z * z * k + c,
    0,
  ];
  const moved = apply(r, centre);
  r[3] = centre[0] - moved[0];
  r[7] = centre[1] - moved[1];
  r[11] = centre[2] - moved[2];
  return r;
}
