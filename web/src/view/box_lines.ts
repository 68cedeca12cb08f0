/// The edges of a box as an instrument draws them: those behind its contents dark, those before them lightly over.

import type { Box } from "./affine";
import { corners } from "./camera";
import type { Line } from "./lines";
import type { Size } from "./view";

/// Pairs of corners (see `corners`), and the two faces that meet there: axis and end of each.
const edges: readonly (readonly [number, number, number, 0 | 1, number, 0 | 1])[] = [
  [0, 1, 1, 0, 2, 0],
  [1, 2, 0, 1, 2, 0],
  [2, 3, 1, 1, 2, 0],
  [3, 0, 0, 0, 2, 0],
  [4, 5, 1, 0, 2, 1],
  [5, 6, 0, 1, 2, 1],
  [6, 7, 1, 1, 2, 1],
  [7, 4, 0, 0, 2, 1],
  [0, 4, 0, 0, 1, 0],
  [1, 5, 0, 1, 1, 0],
  [2, 6, 0, 1, 1, 1],
  [3, 7, 0, 0, 1, 1],
];

const edgeWidth = 1.5;
const nearOpacity = 0.42;
const farOpacity = 0.92;

export interface BoxStyle {
  readonly colour: string;
  /// Without a ceiling: upright edges fade away, and there are none above.
  readonly open: boolean;
}

function faces(box: Readonly<Box>, axis: number, end: 0 | 1, eye: Size): boolean {
  const at = box[axis + 3 * end] as number;
  return end === 0 ? (eye[axis] as number) < at : (eye[axis] as number) > at;
}

export function boxLines(box: Readonly<Box>, eye: Size, { colour, open }: BoxStyle): Line[] {
  const points = corners(box);
  const lines: Line[] = [];
  for (const [from, to, axisA, endA, axisB, endB] of edges) {
    if (open && from >= 4) continue;
    const near = faces(box, axisA, endA, eye) && faces(box, axisB, endB, eye);
    const opacity = near ? nearOpacity : farOpacity;
    lines.push({
      from: points[from] as Size,
      to: points[to] as Size,
      colour,
      width: edgeWidth,
      opacity,
      endOpacity: open && from < 4 && to >= 4 ? 0 : opacity,
    });
  }
  return lines;
}
