import { describe, expect, it } from "vitest";
import type { Box } from "../../src/view/affine";
import { identity } from "../../src/view/affine";
import { ambientGrid, computeAmbient, type Surface } from "../../src/view/ambient";
import { meshFacts, surfacePoints } from "../../src/view/mesh_facts";
import { boxMesh } from "./meshes";

const tray: Box = [0, 0, 0, 48, 48, 48];

function surface(x: number, y: number, z: number, at: readonly [number, number, number]): Surface {
  const mesh = boxMesh(x, y, z, at);
  const { area } = meshFacts(mesh);
  const points = surfacePoints(mesh, area, 4 * area);
  return { points, rows: identity, at: 0, areaEach: area / (points.length / 3) };
}

describe("the light between copies", () => {
  const grid = ambientGrid(tray);
  const index = (x: number, y: number, z: number) => {
    const [i, j, k] = [x, y, z].map((v, a) => Math.floor((v - (grid.corner[a] ?? 0)) / grid.cell)) as [
      number,
      number,
      number,
    ];
    return 4 * (i + grid.size[0] * (j + grid.size[1] * k));
  };

  it("is full where nothing stands", () => {
    const { texels } = computeAmbient(tray, [], null);
    expect(texels[index(20, 20, 20) + 3]).toBe(255);
    expect(texels[index(20, 20, 20)]).toBe(128);
  });

  it("comes from above over a slab, and hardly reaches into a closed box", () => {
    const slab = computeAmbient(tray, [surface(48, 48, 4, [0, 0, 20])], null).texels;
    const above = index(24, 24, 25);
    const below = index(24, 24, 18);
    expect(slab[above + 2]).toBeGreaterThan(160);
    expect(slab[below + 2]).toBeLessThan(96);
    const closed = computeAmbient(tray, [surface(30, 30, 30, [9, 9, 9])], null).texels;
    expect(closed[index(24, 24, 24) + 3]).toBeLessThan(90);
    expect(closed[index(2, 2, 46) + 3]).toBeGreaterThan(190);
  });

  it("leaves out what a section cut away", () => {
    const keeps = (_x: number, _y: number, z: number) => z < 30;
    const { texels } = computeAmbient(tray, [surface(48, 48, 4, [0, 0, 40])], keeps);
    expect(texels[index(24, 24, 20) + 3]).toBe(255);
  });
});
