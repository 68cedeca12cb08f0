/// Normals for round faces. Triangles that meet at less than the crease angle share a normal at their common vertices;
/// where they meet at more, the vertex is split. Without them copies are drawn facet by facet, which is right, too, but
/// shows every cylinder as a prism.

import type { MeshData } from "./view";

export interface Smooth {
  readonly positions: Float32Array;
  /// 4 a vertex, -127 to 127; the fourth is 0.
  readonly normals: Int8Array;
  readonly indices: Uint32Array;
}

/// A cylinder of twelve sides is round, a hexagon is not.
const creaseDegrees = 35;
/// Round a vertex with more triangles, each is compared with few others: the tips of fans may have thousands.
const mostCompared = 48;

export function smooth({ positions, indices }: MeshData): Smooth {
  const vertices = positions.length / 3;
  const normals = triangleNormals(positions, indices);
  const { starts, corners } = cornersByVertex(vertices, indices);
  const crease = Math.cos((creaseDegrees * Math.PI) / 180);

  const outIndices = new Uint32Array(indices.length);
  const outPositions: number[] = [];
  const outNormals: number[] = [];
  let group: number[] = [];
  for (let v = 0; v < vertices; ++v) {
    const from = starts[v] as number;
    const count = (starts[v + 1] as number) - from;
    group = groups(corners, from, count, normals.units, crease, group);
    for (let i = 0; i < count; ++i) {
      // Each group is named after its first corner.
      if (group[i] !== i) continue;
      let x = 0;
      let y = 0;
      let z = 0;
      const index = outPositions.length / 3;
      for (let j = i; j < count; ++j) {
        if (group[j] !== i) continue;
        const corner = corners[from + j] as number;
        outIndices[corner] = index;
        // By area: a flat face keeps its own shade beside a small fillet.
        const t = 3 * Math.floor(corner / 3);
        x += normals.areas[t] as number;
        y += normals.areas[t + 1] as number;
        z += normals.areas[t + 2] as number;
      }
      const length = Math.hypot(x, y, z) || 1;
      outPositions.push(positions[3 * v] as number, positions[3 * v + 1] as number, positions[3 * v + 2] as number);
      outNormals.push(
        Math.round((127 * x) / length),
        Math.round((127 * y) / length),
        Math.round((127 * z) / length),
        0,
      );
    }
  }
  return {
    positions: Float32Array.from(outPositions),
    normals: Int8Array.from(outNormals),
    indices: outIndices,
  };
}

/// As long as twice the area, and of length 1.
function triangleNormals(p: Float32Array, indices: Uint32Array): { areas: Float32Array; units: Float32Array } {
  const areas = new Float32Array(indices.length);
  const units = new Float32Array(indices.length);
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const a = 3 * (indices[t] as number);
    const b = 3 * (indices[t + 1] as number);
    const c = 3 * (indices[t + 2] as number);
    const ux = (p[b] as number) - (p[a] as number);
    const uy = (p[b + 1] as number) - (p[a + 1] as number);
    const uz = (p[b + 2] as number) - (p[a + 2] as number);
    const vx = (p[c] as number) - (p[a] as number);
    const vy = (p[c + 1] as number) - (p[a + 1] as number);
    const vz = (p[c + 2] as number) - (p[a + 2] as number);
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    const length = Math.sqrt(x * x + y * y + z * z) || 1;
    areas[t] = x;
    areas[t + 1] = y;
    areas[t + 2] = z;
    units[t] = x / length;
    units[t + 1] = y / length;
    units[t + 2] = z / length;
  }
  return { areas, units };
}

/// The corners (positions in `indices`) at vertex v are corners[starts[v]] to corners[starts[v + 1]].
function cornersByVertex(vertices: number, indices: Uint32Array): { starts: Uint32Array; corners: Uint32Array } {
  const starts = new Uint32Array(vertices + 1);
  for (const v of indices) starts[v + 1] = (starts[v + 1] as number) + 1;
  for (let v = 0; v < vertices; ++v) starts[v + 1] = (starts[v + 1] as number) + (starts[v] as number);
  const next = starts.slice();
  const corners = new Uint32Array(indices.length);
  indices.forEach((v, corner) => {
    const at = next[v] as number;
    corners[at] = corner;
    next[v] = at + 1;
  });
  return { starts, corners };
}

/// Which corners at a vertex belong together, through others if need be. Each is given its group's first.
function groups(
  corners: Uint32Array,
  from: number,
  count: number,
  units: Float32Array,
  crease: number,
  group: number[],
): number[] {
  for (let i = 0; i < count; ++i) {
    group[i] = i;
    const a = 3 * Math.floor((corners[from + i] as number) / 3);
    for (let j = Math.max(0, i - mostCompared); j < i; ++j) {
      if (group[j] === group[i]) continue;
      const b = 3 * Math.floor((corners[from + j] as number) / 3);
      const cosine =
        (units[a] as number) * (units[b] as number) +
        (units[a + 1] as number) * (units[b + 1] as number) +
        (units[a + 2] as number) * (units[b + 2] as number);
      if (cosine < crease) continue;
      const [mine, other] = [group[i] as number, group[j] as number];
      if (mine === i) {
        group[i] = other;
        continue;
      }
      // It holds two groups together.
      const [first, second] = [Math.min(mine, other), Math.max(mine, other)];
      for (let k = 0; k <= i; ++k) if (group[k] === second) group[k] = first;
    }
  }
  return group;
}
