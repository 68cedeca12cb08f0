import { describe, expect, it } from "vitest";
import { smooth } from "../../src/view/smooth";
import type { MeshData } from "../../src/view/view";
import { boxMesh } from "./meshes";

/// Closed, with flat ends.
function cylinder(sides: number): MeshData {
  const positions = [0, 0, 0, 0, 0, 1];
  const indices: number[] = [];
  for (let i = 0; i < sides; ++i) {
    const angle = (2 * Math.PI * i) / sides;
    positions.push(Math.cos(angle), Math.sin(angle), 0, Math.cos(angle), Math.sin(angle), 1);
    const [a, b] = [2 + 2 * i, 2 + 2 * ((i + 1) % sides)];
    indices.push(a, b, b + 1, a, b + 1, a + 1, 0, b, a, 1, a + 1, b + 1);
  }
  return { id: 0, positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

describe("normals", () => {
  it("split a box into its six faces", () => {
    const mesh = boxMesh(3, 4, 5);
    const { positions, normals, indices } = smooth(mesh);
    expect(positions.length / 3).toBe(24);
    expect(indices.length).toBe(36);
    for (let v = 0; v < 24; ++v) {
      const n = [...normals.subarray(4 * v, 4 * v + 3)];
      expect(n.map(Math.abs).sort()).toEqual([0, 0, 127]);
    }
  });

  it("keep every triangle where it was", () => {
    const mesh = cylinder(24);
    const { positions, indices } = smooth(mesh);
    const places = (p: Float32Array, i: Uint32Array) => [...i].map((v) => [...p.subarray(3 * v, 3 * v + 3)].join());
    expect(places(positions, indices)).toEqual(places(mesh.positions, mesh.indices));
  });

  it("round a cylinder's wall and leave its ends flat", () => {
    const { positions, normals } = smooth(cylinder(24));
    // Two middles, and every vertex of the rims once for the wall and once for the end.
    expect(positions.length / 3).toBe(2 + 4 * 24);
    for (let v = 0; v < positions.length / 3; ++v) {
      const [x, y, z] = [...normals.subarray(4 * v, 4 * v + 3)] as [number, number, number];
      if (Math.abs(z) > 100) continue;
      expect(z).toBe(0);
      const out = (x * (positions[3 * v] as number) + y * (positions[3 * v + 1] as number)) / 127;
      expect(out).toBeGreaterThan(0.98);
    }
  });

  it("leave a hexagon its edges, and open and empty meshes alone", () => {
    expect(smooth(cylinder(6)).positions.length / 3).toBe(2 + 2 * 6 + 2 * 12);
    const wall = { id: 0, positions: boxMesh(1, 1, 1).positions, indices: Uint32Array.of(0, 1, 5) };
    expect(smooth(wall).indices.length).toBe(3);
    expect(smooth({ id: 0, positions: new Float32Array(0), indices: new Uint32Array(0) }).indices.length).toBe(0);
  });

  it("stand a tip with very many triangles", () => {
    const started = performance.now();
    expect(smooth(cylinder(20_000)).positions.length).toBeGreaterThan(0);
    expect(performance.now() - started).toBeLessThan(3000);
  });
});
