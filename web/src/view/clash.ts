/// Whether two copies touch, on the meshes that the page has. They may be simplified: who needs to know exactly asks the
/// server.

import { DoubleSide, Matrix4, Ray, Vector3 } from "three";
import { type Affine, apply, invert, multiply, writeRows } from "./affine";
import { treeOf } from "./pick";
import type { MeshData, Size, Transform } from "./view";

export interface Body {
  readonly mesh: MeshData;
  readonly transform: Transform;
}

/// Surfaces meet, or one lies in the other.
export function touches(a: Body, b: Body): boolean {
  const [toTrayA, toTrayB] = [affineOf(a.transform), affineOf(b.transform)];
  const [fromTrayA, fromTrayB] = [invert(toTrayA), invert(toTrayB)];
  if (!fromTrayA || !fromTrayB) return false;
  const bToA = multiply(fromTrayA, toTrayB);
  if (treeOf(a.mesh).bvhcast(treeOf(b.mesh), matrixOf(bToA), { intersectsTriangles: triangles })) return true;
  return (
    isInside(b, apply(bToA, vertexOf(b.mesh)), a) ||
    isInside(a, apply(multiply(fromTrayB, toTrayA), vertexOf(a.mesh)), b)
  );
}

const triangles = (one: { intersectsTriangle(other: unknown): boolean }, other: unknown): boolean =>
  one.intersectsTriangle(other);

function affineOf(transform: Transform): Affine {
  const rows: number[] = [];
  writeRows(transform, rows);
  return rows;
}

function matrixOf(m: Affine): Matrix4 {
  const v = (i: number) => m[i] ?? 0;
  return new Matrix4().set(v(0), v(1), v(2), v(3), v(4), v(5), v(6), v(7), v(8), v(9), v(10), v(11), 0, 0, 0, 1);
}

function vertexOf(mesh: MeshData): Size {
  return [mesh.positions[0] ?? 0, mesh.positions[1] ?? 0, mesh.positions[2] ?? 0];
}

/// Slanted, so that no ray runs along a wall.
const slant = new Vector3(0.577, 0.211, 0.789).normalize();

/// A vertex of one, in the other's coordinates: a ray from inside goes out once more than it comes in.
function isInside(one: Body, vertex: Size, other: Body): boolean {
  if (one.mesh.positions.length === 0) return false;
  const hits = treeOf(other.mesh).raycast(new Ray(new Vector3(...vertex), slant), DoubleSide);
  const distances = new Set(hits.map((hit) => hit.distance.toFixed(6)));
  return distances.size % 2 === 1;
}
