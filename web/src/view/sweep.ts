/// Whether a mesh that is moved along a path meets another: exactly, without taking samples on the way. What a closed mesh
/// sweeps while it moves by a vector is bounded by its faces at the start, its faces at the end, and the strips that its
/// edges draw; of the edges only those of the outline matter, where one face looks ahead and the other back. The other mesh
/// is met if it crosses one of these, or lies wholly inside.

import { BufferAttribute, BufferGeometry, DoubleSide, Matrix4, Ray, Vector3 } from "three";
import { MeshBVH } from "three-mesh-bvh";
import { apply, applyDirection, invert, writeRows } from "./affine";
import { treeOf } from "./pick";
import type { MeshData, Size, Transform } from "./view";

export interface Body {
  readonly mesh: MeshData;
  readonly transform: Transform;
}

interface Leg {
  readonly tree: MeshBVH;
  /// Of the body before it moves, and by how much it moves.
  readonly start: Size;
  readonly by: Size;
}

export class Sweep {
  private readonly legs: Leg[] = [];
  private readonly rows = new Float64Array(12);

  constructor(
    private readonly body: Body,
    path: readonly Size[],
  ) {
    writeRows(body.transform, this.rows);
    let start: Size = [0, 0, 0];
    for (const by of path) {
      if (Math.hypot(...by) < 1e-9) continue;
      this.legs.push({ tree: new MeshBVH(sweptSurface(body.mesh, this.rows, start, by), {}), start, by });
      start = [start[0] + by[0], start[1] + by[1], start[2] + by[2]];
    }
  }

  meets(other: Body): boolean {
    const tree = treeOf(other.mesh);
    const { geometry } = tree;
    geometry.boundsTree = tree;
    const matrix = matrixOf(other.transform);
    return this.legs.some((leg) => leg.tree.intersectsGeometry(geometry, matrix) || this.holds(leg, other));
  }

  /// What crosses nothing is wholly inside or wholly outside, and one vertex tells: looked back along the move, the body
  /// was there.
  private holds({ start, by }: Leg, other: Body): boolean {
    const inverse = invert(this.rows);
    if (!inverse) return false;
    const rows = new Float64Array(12);
    writeRows(other.transform, rows);
    const [x = 0, y = 0, z = 0] = other.mesh.positions;
    const vertex = apply(rows, [x, y, z]);
    const origin = apply(inverse, [vertex[0] - start[0], vertex[1] - start[1], vertex[2] - start[2]]);
    const back = applyDirection(inverse, [-by[0], -by[1], -by[2]]);
    const reach = Math.hypot(...back);
    const ray = new Ray(new Vector3(...origin), new Vector3(...back).divideScalar(reach));
    return treeOf(this.body.mesh).raycastFirst(ray, DoubleSide, 0, reach) !== null;
  }
}

function matrixOf(transform: Transform): Matrix4 {
  const v = (row: number, column: number) => transform[row]?.[column] ?? (row === column ? 1 : 0);
  const row = (r: number) => [v(r, 0), v(r, 1), v(r, 2), v(r, 3)] as const;
  return new Matrix4().set(...row(0), ...row(1), ...row(2), 0, 0, 0, 1);
}

function sweptSurface(mesh: MeshData, rows: Float64Array, start: Size, by: Size): BufferGeometry {
  const { positions, indices } = mesh;
  const count = positions.length / 3;
  // Every vertex twice: where the move begins, and where it ends.
  const points = new Float32Array(6 * count);
  for (let i = 0; i < count; ++i) {
    const p: Size = [positions[3 * i] ?? 0, positions[3 * i + 1] ?? 0, positions[3 * i + 2] ?? 0];
    const at = apply(rows, p);
    for (let axis = 0; axis < 3; ++axis) {
      const first = (at[axis] ?? 0) + (start[axis] ?? 0);
      points[3 * i + axis] = first;
      points[3 * (count + i) + axis] = first + (by[axis] ?? 0);
    }
  }
  const faces: number[] = [];
  for (const index of indices) faces.push(index);
  for (const index of indices) faces.push(index + count);
  for (const [a, b] of outline(points, indices, by)) faces.push(a, b, b + count, a, b + count, a + count);
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  geometry.setIndex(new BufferAttribute(Uint32Array.from(faces), 1));
  return geometry;
}

/// Edges between a face that looks ahead and one that does not, and those of one face alone.
function outline(points: Float32Array, indices: Uint32Array, by: Size): [number, number][] {
  const edges = new Map<number, { readonly a: number; readonly b: number; ahead: number; faces: number }>();
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const face = [indices[t] ?? 0, indices[t + 1] ?? 0, indices[t + 2] ?? 0] as const;
    const ahead = looksAhead(points, face, by) ? 1 : 0;
    for (let i = 0; i < 3; ++i) {
      const a = Math.min(face[i] ?? 0, face[(i + 1) % 3] ?? 0);
      const b = Math.max(face[i] ?? 0, face[(i + 1) % 3] ?? 0);
      const key = a * 2 ** 26 + b;
      const edge = edges.get(key);
      if (edge) {
        edge.ahead += ahead;
        edge.faces += 1;
      } else edges.set(key, { a, b, ahead, faces: 1 });
    }
  }
  return [...edges.values()]
    .filter(({ ahead, faces }) => faces === 1 || (ahead > 0 && ahead < faces))
    .map(({ a, b }) => [a, b]);
}

function looksAhead(p: Float32Array, [a, b, c]: readonly [number, number, number], by: Size): boolean {
  const v = (i: number, axis: number) => p[3 * i + axis] ?? 0;
  const e = [v(b, 0) - v(a, 0), v(b, 1) - v(a, 1), v(b, 2) - v(a, 2)] as const;
  const f = [v(c, 0) - v(a, 0), v(c, 1) - v(a, 1), v(c, 2) - v(a, 2)] as const;
  const n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]] as const;
  return n[0] * by[0] + n[1] * by[1] + n[2] * by[2] > 0;
}
