/// What is drawn, in which order: one list of slots in which every shape's copies of each kind lie side by side, so that
/// one call draws them all. Also what the camera does not see.

import type { Copies } from "./copies";

/// Bits that say how a slot is drawn.
export const solid = 1;
/// A solid copy that the section goes through: it gets a cut face.
export const crossing = 2;
/// A copy that fades in: drawn over the solid ones.
export const ghost = 4;
export const outlined = 8;
/// With `outlined`: in the colour of the mark.
export const asMark = 16;
/// Drawn behind all others, wherever it is.
export const faint = 32;

/// In the list, a slot whose outline has the mark's colour carries this bit.
export const markBit = 0x10000000;

/// A mesh that parts have.
export interface OfParts {
  readonly parts: Iterable<number>;
}

export interface Ranges<Shape> {
  readonly shape: Shape;
  /// Solid copies; the first `cuts` of them are crossed by the section.
  readonly solids: number;
  readonly solidCount: number;
  readonly cuts: number;
  readonly ghosts: number;
  readonly ghostCount: number;
  readonly faints: number;
  readonly faintCount: number;
  /// Outlined copies; the first `outlineCuts` are crossed by the section.
  readonly outlines: number;
  readonly outlineCount: number;
  readonly outlineCuts: number;
}

export interface Lists<Shape> {
  readonly list: Uint32Array;
  readonly ranges: readonly Ranges<Shape>[];
}

/// `kindOf` says how a slot is drawn; 0: not at all.
export function buildLists<Shape extends OfParts>(
  copies: Copies,
  shapes: Iterable<Shape>,
  kindOf: (slot: number) => number,
): Lists<Shape> {
  const list: number[] = [];
  const ranges: Ranges<Shape>[] = [];
  const cut: number[] = [];
  const whole: number[] = [];
  const ghosts: number[] = [];
  const faints: number[] = [];
  const cutOutlines: number[] = [];
  const outlines: number[] = [];
  for (const shape of shapes) {
    cut.length = whole.length = ghosts.length = faints.length = cutOutlines.length = outlines.length = 0;
    for (const part of shape.parts) {
      for (const slot of copies.ofPart(part)) {
        const kind = kindOf(slot);
        if (kind & solid) (kind & crossing ? cut : whole).push(slot);
        else if (kind & ghost) ghosts.push(slot);
        else if (kind & faint) faints.push(slot);
        if (kind & outlined) {
          (kind & crossing ? cutOutlines : outlines).push(kind & asMark ? slot | markBit : slot);
        }
      }
    }
    const base = list.length;
    for (const group of [cut, whole, ghosts, faints, cutOutlines, outlines]) for (const slot of group) list.push(slot);
    const solidCount = cut.length + whole.length;
    const ghostsAt = base + solidCount;
    const faintsAt = ghostsAt + ghosts.length;
    const outlinesAt = faintsAt + faints.length;
    ranges.push({
      shape,
      solids: base,
      solidCount,
      cuts: cut.length,
      ghosts: ghostsAt,
      ghostCount: ghosts.length,
      faints: faintsAt,
      faintCount: faints.length,
      outlines: outlinesAt,
      outlineCount: cutOutlines.length + outlines.length,
      outlineCuts: cutOutlines.length,
    });
  }
  return { list: Uint32Array.from(list), ranges };
}

/// Six planes, each a b c d with a x + b y + c z + d >= 0 inside.
export type Frustum = readonly (readonly [number, number, number, number])[];

/// From a view-projection matrix as three.js keeps it, by columns (Gribb and Hartmann 2001).
export function frustumOf(m: ArrayLike<number>): Frustum {
  const row = (i: number) => [m[i] ?? 0, m[i + 4] ?? 0, m[i + 8] ?? 0, m[i + 12] ?? 0] as const;
  const w = row(3);
  const planes: [number, number, number, number][] = [];
  for (let i = 0; i < 3; ++i) {
    const r = row(i);
    planes.push([w[0] + r[0], w[1] + r[1], w[2] + r[2], w[3] + r[3]]);
    planes.push([w[0] - r[0], w[1] - r[1], w[2] - r[2], w[3] - r[3]]);
  }
  return planes;
}

/// Whether a box may be seen. Some that are not are let through, none that are seen are lost.
export function mayBeSeen(frustum: Frustum, boxes: ArrayLike<number>, at: number): boolean {
  for (const [a, b, c, d] of frustum) {
    const x = boxes[a > 0 ? at + 3 : at] as number;
    const y = boxes[b > 0 ? at + 4 : at + 1] as number;
    const z = boxes[c > 0 ? at + 5 : at + 2] as number;
    if (a * x + b * y + c * z + d < 0) return false;
  }
  return true;
}

/// Whether a box lies wholly in sight.
export function isWhollySeen(frustum: Frustum, boxes: ArrayLike<number>, at: number): boolean {
  for (const [a, b, c, d] of frustum) {
    const x = boxes[a > 0 ? at : at + 3] as number;
    const y = boxes[b > 0 ? at + 1 : at + 4] as number;
    const z = boxes[c > 0 ? at + 2 : at + 5] as number;
    if (a * x + b * y + c * z + d < 0) return false;
  }
  return true;
}
