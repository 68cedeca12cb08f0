/// The parts' meshes on the graphics card. Parts of one mesh share a shape, so that one call draws all their copies.

import { BufferAttribute, InstancedBufferGeometry, Sphere } from "three";
import { type MeshFacts, meshFacts, surfacePoints } from "./mesh_facts";
import { smooth } from "./smooth";
import type { MeshData } from "./view";

/// Points on a mesh for the light between the copies: so many on a piece of surface as large as a cell's side.
const pointsACell = 4;
const leastPoints = 16;
const mostPoints = 60_000;
/// Triangles whose normals are worked out at once, and at all: they take time and memory.
const smoothAtOnce = 60_000;
const smoothAtMost = 2_500_000;

export interface Shape {
  readonly number: number;
  readonly mesh: MeshData;
  readonly facts: MeshFacts;
  readonly parts: Set<number>;
  geometry: InstancedBufferGeometry;
  /// A rougher one that is drawn while the picture moves, where the machine is slow.
  lighter: Lighter | null;
  points: Float32Array | null;
  /// A copy of it has been placed as its mirror image: what is outside looks inside.
  mirrored: boolean;
}

interface Lighter {
  readonly geometry: InstancedBufferGeometry;
  readonly triangles: number;
}

export class Shapes {
  /// The lighter ones are drawn.
  light = false;

  private readonly byMesh = new Map<MeshData, Shape>();
  private readonly byPart = new Map<number, Shape>();
  private rough: Shape[] = [];
  private smoothed = 0;
  private made = 0;

  /// `gone`: told the number of a shape that no part has any more.
  constructor(private readonly gone: (shape: number) => void) {}

  of(part: number): Shape | undefined {
    return this.byPart.get(part);
  }

  all(): Iterable<Shape> {
    return this.byMesh.values();
  }

  /// What is drawn of a shape now.
  drawn(shape: Shape): Lighter {
    const { mesh, geometry, lighter } = shape;
    return this.light && lighter ? lighter : { geometry, triangles: mesh.indices.length / 3 };
  }

  /// `keep`: the mesh before is drawn while the picture moves.
  set(part: number, mesh: MeshData, keep = false): Shape {
    const before = this.byPart.get(part);
    if (before?.mesh === mesh) return before;
    let shape = this.byMesh.get(mesh);
    if (!shape) {
      const facts = meshFacts(mesh);
      const geometry = geometryOf(mesh, facts);
      shape = {
        number: this.made++,
        mesh,
        facts,
        parts: new Set(),
        geometry,
        lighter: null,
        points: null,
        mirrored: false,
      };
      this.byMesh.set(mesh, shape);
      if (this.smoothed + mesh.indices.length / 3 <= smoothAtOnce) this.smoothShape(shape);
      else this.rough.push(shape);
    }
    shape.parts.add(part);
    this.byPart.set(part, shape);
    if (before) {
      if (before.mirrored) shape.mirrored = true;
      if (keep) shape.lighter ??= { geometry: before.geometry, triangles: before.mesh.indices.length / 3 };
      this.leave(part, before);
    }
    return shape;
  }

  clear(): void {
    this.release();
    this.byMesh.clear();
    this.byPart.clear();
    this.rough = [];
    this.smoothed = 0;
  }

  /// Lets go of the memory on the graphics card; what is drawn again takes it again.
  release(): void {
    for (const { geometry, lighter } of this.all()) {
      geometry.dispose();
      lighter?.geometry.dispose();
    }
  }

  /// Whether there are meshes that are still drawn facet by facet and need not be.
  get isRough(): boolean {
    return this.rough.length > 0;
  }

  /// Works out normals for about so many ms. Says whether any are new.
  smoothSome(ms: number): boolean {
    const end = performance.now() + ms;
    let any = false;
    while (this.rough.length > 0 && performance.now() < end) {
      const shape = this.rough.shift();
      if (!shape || this.smoothed + shape.mesh.indices.length / 3 > smoothAtMost) continue;
      this.smoothShape(shape);
      any = true;
    }
    return any;
  }

  private leave(part: number, shape: Shape): void {
    shape.parts.delete(part);
    if (shape.parts.size > 0) return;
    this.byMesh.delete(shape.mesh);
    this.rough = this.rough.filter((other) => other !== shape);
    shape.geometry.dispose(); // where it is kept as a lighter one, it is brought to the card again
    shape.lighter?.geometry.dispose();
    this.gone(shape.number);
  }

  private smoothShape(shape: Shape): void {
    this.smoothed += shape.mesh.indices.length / 3;
    shape.geometry.dispose();
    const { positions, normals, indices } = smooth(shape.mesh);
    shape.geometry = geometryOf({ positions, indices }, shape.facts);
    shape.geometry.setAttribute("normal", new BufferAttribute(normals, 4));
  }
}

/// Points on a shape's surface for the light between the copies, as many as copies of `scaleSquared` need in cells of
/// `cell` mm.
export function pointsOn(shape: Shape, scaleSquared: number, cell: number): Float32Array {
  const wanted = Math.min(
    mostPoints,
    Math.max(leastPoints, (pointsACell * shape.facts.area * scaleSquared) / cell ** 2),
  );
  if (!shape.points || shape.points.length < 1.5 * wanted || shape.points.length > 12 * wanted) {
    shape.points = surfacePoints(shape.mesh, shape.facts.area, wanted);
  }
  return shape.points;
}

function geometryOf(mesh: Pick<MeshData, "positions" | "indices">, facts: MeshFacts): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(mesh.positions, 3));
  geometry.setIndex(new BufferAttribute(facts.insideOut ? otherWayRound(mesh.indices) : mesh.indices, 1));
  // Never asked for, but three.js would go through all vertices to find it.
  geometry.boundingSphere = new Sphere();
  return geometry;
}

function otherWayRound(indices: Uint32Array): Uint32Array {
  const turned = indices.slice();
  for (let i = 0; i + 2 < turned.length; i += 3) {
    turned[i + 1] = indices[i + 2] as number;
    turned[i + 2] = indices[i + 1] as number;
  }
  return turned;
}
