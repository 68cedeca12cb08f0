/// The section plane: what it keeps, its outline in the tray, its hatch, and how its handle is dragged.

import type { Box } from "./affine";
import type { Axis, Section, Size } from "./view";

export const axisIndex: Readonly<Record<Axis, 0 | 1 | 2>> = { x: 0, y: 1, z: 2 };

/// n · p + w >= 0 is kept.
export type Plane = readonly [number, number, number, number];

/// mm. Sections are set to round heights, where copies have faces. A face in the plane itself is shown as it is, and a
/// copy that begins there is cut away: without this, rounding would decide for every pixel.
export const slack = 0.02;

export function planeOf({ axis, at, flipped }: Section): Plane {
  const sign = flipped ? 1 : -1;
  const n: [number, number, number] = [0, 0, 0];
  n[axisIndex[axis]] = sign;
  return [n[0], n[1], n[2], -sign * at + slack];
}

/// Where the plane lies with its slack.
export function planeAt({ at, flipped }: Section): number {
  return flipped ? at - slack : at + slack;
}

export function isKept(plane: Plane, [x, y, z]: Size): boolean {
  return plane[0] * x + plane[1] * y + plane[2] * z + plane[3] >= 0;
}

export const kept = 0;
export const crossed = 1;
export const cutAway = 2;

/// `boxes[at..at+6]`: wholly kept, crossed by the plane, or cut away.
export function boxSide(section: Section, boxes: ArrayLike<number>, at: number): number {
  const axis = axisIndex[section.axis];
  const low = boxes[at + axis] as number;
  const high = boxes[at + 3 + axis] as number;
  const { at: plane } = section;
  if (section.flipped) return high <= plane + slack ? cutAway : low >= plane - slack ? kept : crossed;
  return low >= plane - slack ? cutAway : high <= plane + slack ? kept : crossed;
}

/// Whether an eye looks at the cuts: from the side that is cut away.
export function facesCut(section: Section, eye: Size): boolean {
  return !isKept(planeOf(section), eye);
}

/// The four corners of where the plane meets a box, in turn. Outside the box it is drawn at its nearest end.
export function outline(section: Section, box: Readonly<Box>): [Size, Size, Size, Size] {
  const axis = axisIndex[section.axis];
  const u = (axis + 1) % 3;
  const v = (axis + 2) % 3;
  const at = Math.min(box[axis + 3] as number, Math.max(box[axis] as number, section.at));
  const corner = (atU: number | undefined, atV: number | undefined): Size => {
    const p: [number, number, number] = [0, 0, 0];
    p[axis] = at;
    p[u] = atU ?? 0;
    p[v] = atV ?? 0;
    return p;
  };
  return [
    corner(box[u], box[v]),
    corner(box[u + 3], box[v]),
    corner(box[u + 3], box[v + 3]),
    corner(box[u], box[v + 3]),
  ];
}

/// The corner that a viewer has nearest: the handle is there.
export function handleCorner(section: Section, box: Readonly<Box>, eye: Size): Size {
  const corners = outline(section, box);
  let best = corners[0];
  for (const corner of corners) if (squared(corner, eye) < squared(best, eye)) best = corner;
  return best;
}

function squared(a: Size, b: Size): number {
  return (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2;
}

/// How far along a line (through `through`, in direction `along` of length 1) it comes nearest to a ray: where a thing
/// lies that is dragged along it with the pointer. Null where both run nearly alike, so that the place means nothing.
export function alongLine(through: Size, along: Size, origin: Size, direction: Size): number | null {
  const w = [through[0] - origin[0], through[1] - origin[1], through[2] - origin[2]] as const;
  const dot = (a: Size, b: Size) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const b = dot(along, direction);
  const c = dot(direction, direction);
  const spread = c - b * b;
  if (spread < 1e-4 * c) return null;
  return (b * dot(direction, w) - c * dot(along, w)) / spread;
}

/// mm between hatch lines, so that they are about `pixels` apart on screen. A power of two: while zooming, lines stay
/// where they are and others come between them.
export function hatchStep(mmAPixel: number, pixels: number): number {
  return 2 ** Math.round(Math.log2(Math.max(1e-6, mmAPixel * pixels)));
}
