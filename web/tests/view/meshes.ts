/// Meshes and transforms for the tests.

import type { MeshData, Transform } from "../../src/view/view";

/// A closed box, its outer sides outwards.
export function boxMesh(x: number, y: number, z: number, at: readonly [number, number, number] = [0, 0, 0]): MeshData {
  const positions: number[] = [];
  for (const k of [0, 1]) {
    positions.push(at[0], at[1], at[2] + k * z);
    positions.push(at[0] + x, at[1], at[2] + k * z);
    positions.push(at[0] + x, at[1] + y, at[2] + k * z);
    positions.push(at[0], at[1] + y, at[2] + k * z);
  }
  const indices = [
    0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7,
  ];
  return { id: 1, positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

export function moved(x: number, y: number, z: number): Transform {
  return [
    [1, 0, 0, x],
    [0, 1, 0, y],
    [0, 0, 1, z],
    [0, 0, 0, 1],
  ];
}

export interface PackedMesh {
  readonly id: number;
  readonly corner: readonly [number, number, number];
  readonly step: readonly [number, number, number];
  readonly numbers: readonly number[];
  readonly indices: readonly number[];
}

/// A bundle as the server writes it.
export function writeBundle(meshes: readonly PackedMesh[]): ArrayBuffer {
  const bytes: number[] = [];
  const u32 = (v: number) => bytes.push(v & 255, (v >> 8) & 255, (v >> 16) & 255, (v >>> 24) & 255);
  const f32 = (v: number) => bytes.push(...new Uint8Array(Float32Array.of(v).buffer));
  for (const c of "SPMB") bytes.push(c.charCodeAt(0));
  u32(1);
  u32(meshes.length);
  for (const mesh of meshes) {
    u32(mesh.id);
    u32(mesh.numbers.length / 3);
    u32(mesh.indices.length / 3);
    mesh.corner.forEach(f32);
    mesh.step.forEach(f32);
    for (const v of mesh.numbers) bytes.push(v & 255, v >> 8);
    while (bytes.length % 4 !== 0) bytes.push(0);
    mesh.indices.forEach(u32);
  }
  return Uint8Array.from(bytes).buffer;
}
