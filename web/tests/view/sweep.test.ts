/// What a mesh meets while it moves.

import { describe, expect, it } from "vitest";
import { Sweep } from "../../src/view/sweep";
import type { MeshData, Size } from "../../src/view/view";
import { boxMesh, moved } from "./meshes";

const cube = boxMesh(10, 10, 10);

function meets(mesh: MeshData, path: readonly Size[], other: MeshData, x: number, y: number, z: number): boolean {
  return new Sweep({ mesh, transform: moved(0, 0, 0) }, path).meets({ mesh: other, transform: moved(x, y, z) });
}

describe("a sweep", () => {
  it("meets what stands on its way, and nothing beside it", () => {
    expect(meets(cube, [[0, 0, 100]], cube, 0, 0, 50)).toBe(true);
    expect(meets(cube, [[0, 0, 100]], cube, 9, 9, 50)).toBe(true);
    expect(meets(cube, [[0, 0, 100]], cube, 11, 0, 50)).toBe(false);
    expect(meets(cube, [[0, 0, 30]], cube, 0, 0, 50)).toBe(false);
    expect(meets(cube, [[0, 0, -100]], cube, 0, 0, 50)).toBe(false);
  });

  it("goes round corners", () => {
    const path: Size[] = [
      [0, 0, 40],
      [60, 0, 0],
    ];
    expect(meets(cube, path, cube, 50, 0, 40)).toBe(true);
    expect(meets(cube, path, cube, 50, 0, 0)).toBe(false);
  });

  it("meets a bar that crosses a bar, where no corner of either meets the other", () => {
    const along = boxMesh(100, 2, 2, [-50, 0, 0]);
    const across = boxMesh(2, 100, 2, [0, -50, 0]);
    expect(meets(along, [[0, 0, 80]], across, 0, 0, 40)).toBe(true);
    expect(meets(along, [[0, 0, 80]], across, 60, 0, 40)).toBe(false);
  });

  it("meets what is small and wholly inside", () => {
    const plate = boxMesh(100, 100, 2, [-50, -50, 0]);
    const grain = boxMesh(1, 1, 1);
    expect(meets(plate, [[0, 0, 80]], grain, 3, 3, 40)).toBe(true);
    expect(meets(plate, [[0, 0, 80]], grain, 3, 3, 90)).toBe(false);
  });

  it("passes through a hole", () => {
    // Four bars round a square hole of 20 by 20.
    const bars = [boxMesh(40, 10, 5, [-10, -10, 0]), boxMesh(40, 10, 5, [-10, 20, 0])];
    const sides = [boxMesh(10, 20, 5, [-10, 0, 0]), boxMesh(10, 20, 5, [20, 0, 0])];
    const sweep = new Sweep({ mesh: cube, transform: moved(5, 5, 0) }, [[0, 0, 100]]);
    for (const mesh of [...bars, ...sides]) expect(sweep.meets({ mesh, transform: moved(0, 0, 50) })).toBe(false);
    const beside = new Sweep({ mesh: cube, transform: moved(12, 5, 0) }, [[0, 0, 100]]);
    expect(sides.some((mesh) => beside.meets({ mesh, transform: moved(0, 0, 50) }))).toBe(true);
  });

  it("takes meshes in other units", () => {
    const inches = boxMesh(10 / 25.4, 10 / 25.4, 10 / 25.4);
    const large = [
      [25.4, 0, 0, 0],
      [0, 25.4, 0, 0],
      [0, 0, 25.4, 0],
      [0, 0, 0, 1],
    ];
    const sweep = new Sweep({ mesh: inches, transform: large }, [[0, 0, 100]]);
    expect(sweep.meets({ mesh: cube, transform: moved(9, 9, 50) })).toBe(true);
    expect(sweep.meets({ mesh: boxMesh(1, 1, 1), transform: moved(4, 4, 50) })).toBe(true);
    expect(sweep.meets({ mesh: cube, transform: moved(11, 0, 50) })).toBe(false);
  });

  it("does not move along an empty path", () => {
    expect(meets(cube, [], cube, 0, 0, 5)).toBe(false);
  });
});
