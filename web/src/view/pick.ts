/// Which copy a ray meets first: the boxes of all copies first, then the triangles of the few whose box it meets. Trees
/// over a mesh's triangles are built when they are first asked for.

import { BufferAttribute, BufferGeometry, DoubleSide, Ray as ThreeRay, Vector3 } from "three";
import { MeshBVH } from "three-mesh-bvh";
import { applyDirection, apply as applyTo, invert } from "./affine";
import { along, type Ray } from "./camera";
import { type Plane, planeOf } from "./section";
import type { MeshData, Section, Size } from "./view";

export interface Hit {
  readonly slot: number;
  readonly point: Size;
  readonly distance: number;
}

/// What there is to meet.
export interface Pickable {
  readonly slots: Iterable<number>;
  /// 6 numbers a slot.
  readonly boxes: ArrayLike<number>;
  /// 12 numbers a slot.
  readonly rows: Float32Array;
  meshOf(slot: number): MeshData | undefined;
}

/// Part of a ray: from `near` to `far` mm.
export interface Reach {
  readonly near: number;
  readonly far: number;
}

const trees = new WeakMap<MeshData, MeshBVH>();

/// A mesh's triangles, in its own coordinates.
export function treeOf(mesh: MeshData): MeshBVH {
  let tree = trees.get(mesh);
  if (!tree) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(mesh.positions, 3));
    geometry.setIndex(new BufferAttribute(mesh.indices, 1));
    // Indirect: the triangles keep their order, because the drawing shares these arrays.
    tree = new MeshBVH(geometry, { indirect: true });
    trees.set(mesh, tree);
  }
  return tree;
}

/// The part of the ray on the kept side of the plane; null where there is none.
export function keptReach(ray: Ray, plane: Plane): Reach | null {
  const at = plane[0] * ray.origin[0] + plane[1] * ray.origin[1] + plane[2] * ray.origin[2] + plane[3];
  const slope = plane[0] * ray.direction[0] + plane[1] * ray.direction[1] + plane[2] * ray.direction[2];
  if (Math.abs(slope) < 1e-12) return at >= 0 ? { near: 0, far: Infinity } : null;
  const meets = -at / slope;
  if (slope > 0) return { near: Math.max(0, meets), far: Infinity };
  return meets <= 0 ? null : { near: 0, far: meets };
}

/// Where the ray goes into the box, within its reach; null where it passes.
export function boxEntry(ray: Ray, boxes: ArrayLike<number>, at: number, reach: Reach): number | null {
  let near = reach.near;
  let far = reach.far;
  for (let axis = 0; axis < 3; ++axis) {
    const origin = ray.origin[axis] as number;
    const direction = ray.direction[axis] as number;
    const low = boxes[at + axis] as number;
    const high = boxes[at + 3 + axis] as number;
    if (Math.abs(direction) < 1e-12) {
      if (origin < low || origin > high) return null;
      continue;
    }
    const a = (low - origin) / direction;
    const b = (high - origin) / direction;
    near = Math.max(near, Math.min(a, b));
    far = Math.min(far, Math.max(a, b));
    if (near > far) return null;
  }
  return near;
}

const localRay = new ThreeRay(new Vector3(), new Vector3());

export function pick(ray: Ray, { slots, boxes, rows, meshOf }: Pickable, section: Section | null): Hit | null {
  const plane = section ? planeOf(section) : null;
  const reach = plane ? keptReach(ray, plane) : { near: 0, far: Infinity };
  if (!reach) return null;
  const met: { slot: number; entry: number }[] = [];
  for (const slot of slots) {
    const entry = boxEntry(ray, boxes, 6 * slot, reach);
    if (entry !== null) met.push({ slot, entry });
  }
  met.sort((a, b) => a.entry - b.entry);

  let best: Hit | null = null;
  for (const { slot, entry } of met) {
    if (best && entry >= best.distance) break;
    const mesh = meshOf(slot);
    const inverse = invert(rows, 12 * slot);
    if (!mesh || !inverse) continue;
    const origin = applyTo(inverse, ray.origin);
    const direction = applyDirection(inverse, ray.direction);
    // A mesh in inches or metres has lengths of its own; the ray's are in mm.
    const scale = Math.hypot(...direction);
    localRay.origin.set(...origin);
    localRay.direction.set(direction[0] / scale, direction[1] / scale, direction[2] / scale);
    const far = Math.min(reach.far, best?.distance ?? Infinity);
    const hit = treeOf(mesh).raycastFirst(localRay, DoubleSide, reach.near * scale, far * scale);
    if (!hit) continue;
    // Met from inside: the ray came in through the cut, so the cut is what the viewer sees there.
    const outwards = hit.face ? hit.face.normal.dot(localRay.direction) > 0 : false;
    const distance = outwards && plane && reach.near > 0 ? reach.near : hit.distance / scale;
    if (best && distance >= best.distance) continue;
    best = { slot, point: along(ray.origin, ray.direction, distance), distance };
  }
  return best;
}
