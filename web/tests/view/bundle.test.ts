import { describe, expect, it } from "vitest";
import { readBundle } from "../../src/view/bundle";
import { type PackedMesh, writeBundle } from "./meshes";

const triangle: PackedMesh = {
  id: 7,
  corner: [-1, 2, 0.5],
  step: [0.5, 0.25, 1],
  numbers: [0, 0, 0, 65535, 0, 0, 0, 4, 2],
  indices: [0, 1, 2],
};

describe("readBundle", () => {
  it("reads ids, places and triangles", () => {
    const [mesh, ...rest] = readBundle(writeBundle([triangle]));
    expect(rest).toEqual([]);
    expect(mesh?.id).toBe(7);
    expect([...(mesh?.positions ?? [])]).toEqual([-1, 2, 0.5, 32766.5, 2, 0.5, -1, 3, 2.5]);
    expect([...(mesh?.indices ?? [])]).toEqual([0, 1, 2]);
  });

  it("goes past the padding of a mesh with an odd number of vertices", () => {
    const four: PackedMesh = {
      ...triangle,
      id: 8,
      numbers: [...triangle.numbers, 1, 1, 1],
      indices: [1, 2, 3, 0, 1, 2],
    };
    const meshes = readBundle(writeBundle([triangle, four, triangle]));
    expect(meshes.map((m) => m.id)).toEqual([7, 8, 7]);
    expect([...(meshes[1]?.indices ?? [])]).toEqual([1, 2, 3, 0, 1, 2]);
  });

  it("reads a bundle without meshes, and a mesh without triangles", () => {
    expect(readBundle(writeBundle([]))).toEqual([]);
    const [mesh] = readBundle(writeBundle([{ ...triangle, numbers: [], indices: [] }]));
    expect(mesh?.positions.length).toBe(0);
  });

  it("says what is wrong", () => {
    const good = new Uint8Array(writeBundle([triangle]));
    const changed = (at: number, ...bytes: number[]) => {
      const copy = good.slice();
      copy.set(bytes, at);
      return copy.buffer;
    };
    expect(() => readBundle(new ArrayBuffer(0))).toThrow(/cut short/);
    expect(() => readBundle(changed(0, 0x50))).toThrow(/not a mesh bundle/);
    expect(() => readBundle(changed(4, 2))).toThrow(/version 2/);
    expect(() => readBundle(changed(8, 255, 255, 255, 255))).toThrow(/4294967295 meshes/);
    expect(() => readBundle(changed(8, 2))).toThrow(/cut short|do not fit/);
    // More vertices than there are bytes, and than 32 bits hold when multiplied.
    expect(() => readBundle(changed(16, 255, 255, 255, 255))).toThrow(/Mesh 1 .* cut short/);
    expect(() => readBundle(changed(20, 0, 0, 0, 128))).toThrow(/cut short/);
    expect(() => readBundle(changed(24, 0, 0, 0xc0, 0x7f))).toThrow(/without end/);
    expect(() => readBundle(changed(good.length - 4, 3))).toThrow(/vertex 3 .* 3 vertices/);
    expect(() => readBundle(Uint8Array.from([...good, 0, 0, 0, 0]).buffer)).toThrow(/4 bytes after/);
  });

  it("throws wherever it is cut off", () => {
    const good = writeBundle([triangle, { ...triangle, id: 9 }]);
    for (let length = 0; length < good.byteLength; ++length) {
      expect(() => readBundle(good.slice(0, length)), `${length} bytes`).toThrow(Error);
    }
  });
});
