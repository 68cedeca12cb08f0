/// What the views need to know of a mesh beyond its triangles: its box, whether it is closed and which way round it is,
/// and points spread over its surface.

import { type Box, emptyBox } from "./affine";
import type { MeshData } from "./view";

export interface MeshFacts {
  readonly box: Readonly<Box>;
  /// Surface, in the mesh's own unit squared.
  readonly area: number;
  /// 0 of a closed mesh; towards 1 the more of it is missing. It is the length of the sum of all triangles' area vectors
  /// in relation to the area: that sum is zero over any closed surface, whatever its shape and however it meets itself.
  readonly openness: number;
  /// The triangles' outer sides look inwards.
  readonly insideOut: boolean;
}

export function meshFacts({ positions, indices }: MeshData): MeshFacts {
  const box = emptyBox();
  for (let i = 0; i + 2 < positions.length; i += 3) {
    for (let axis = 0; axis < 3; ++axis) {
      const v = positions[i + axis] as number;
      if (v < (box[axis] as number)) box[axis] = v;
      if (v > (box[axis + 3] as number)) box[axis + 3] = v;
    }
  }
  // Volumes are taken from the box's corner: far from the origin they would drown in rounding.
  const [ox, oy, oz] = box;
  let area = 0;
  let volume = 0;
  let sx = 0;
  let sy = 0;
  let sz = 0;
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const a = 3 * (indices[t] as number);
    const b = 3 * (indices[t + 1] as number);
    const c = 3 * (indices[t + 2] as number);
    const ax = (positions[a] as number) - ox;
    const ay = (positions[a + 1] as number) - oy;
    const az = (positions[a + 2] as number) - oz;
    const ux = (positions[b] as number) - ox - ax;
    const uy = (positions[b + 1] as number) - oy - ay;
    const uz = (positions[b + 2] as number) - oz - az;
    const vx = (positions[c] as number) - ox - ax;
    const vy = (positions[c + 1] as number) - oy - ay;
    const vz = (positions[c + 2] as number) - oz - az;
    const nx = uy * vz - uz * vy;
    const ny = uz * vx - ux * vz;
    const nz = ux * vy - uy * vx;
    area += Math.sqrt(nx * nx + ny * ny + nz * nz) / 2;
    volume += ax * nx + ay * ny + az * nz;
    sx += nx;
    sy += ny;
    sz += nz;
  }
  const openness = area > 0 ? Math.hypot(sx, sy, sz) / 2 / area : 0;
  return { box, area, openness, insideOut: volume < 0 };
}

/// About `count` points, spread evenly over the surface by area and always the same ones: 3 numbers each.
export function surfacePoints({ positions, indices }: MeshData, area: number, count: number): Float32Array {
  const points: number[] = [];
  const each = area / Math.max(1, count);
  if (!(each > 0)) return new Float32Array(0);
  let owed = each / 2;
  let turn = 0;
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const a = 3 * (indices[t] as number);
    const b = 3 * (indices[t + 1] as number);
    const c = 3 * (indices[t + 2] as number);
    const at = (i: number, k: number) => positions[i + k] as number;
    const ux = at(b, 0) - at(a, 0);
    const uy = at(b, 1) - at(a, 1);
    const uz = at(b, 2) - at(a, 2);
    const vx = at(c, 0) - at(a, 0);
    const vy = at(c, 1) - at(a, 1);
    const vz = at(c, 2) - at(a, 2);
    owed += Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
    while (owed >= each) {
      owed -= each;
      turn += 1;
      let p = (turn * 0.7548776662466927) % 1;
      let q = (turn * 0.5698402909980532) % 1;
      if (p + q > 1) {
        p = 1 - p;
        q = 1 - q;
      }
      points.push(at(a, 0) + p * ux + q * vx, at(a, 1) + p * uy + q * vy, at(a, 2) + p * uz + q * vz);
    }
  }
  return new Float32Array(points);
}
