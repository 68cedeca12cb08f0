/// Packing files as the page reads them.

import { describe, expect, it } from "vitest";
import { readPacking } from "../../src/app/state/packing";

const move = (x: number) => [
  [1, 0, 0, x],
  [0, 1, 0, 0],
  [0, 0, 1, 0],
  [0, 0, 0, 1],
];

const file = {
  container: {
    size: [100, 50, 80],
    open_height: false,
    keep_out: [
      {
        box: [
          [0, 0, 0],
          [5, 5, 80],
        ],
      },
      { mesh: "pin.stl" },
    ],
  },
  options: { "wall-gap": 5 },
  parts: [
    { name: "bracket", mesh: "files/bracket.stl", object: null, count: 3, volume: 1000 },
    { name: "lid", mesh: "files/set.3mf", object: "2", count: 4, volume: 500 },
  ],
  trays: [
    {
      placements: [
        { part: 0, copy: 0, transform: move(0) },
        { part: 1, copy: 0, transform: move(20) },
        { part: 0, copy: 1, transform: move(40), fixed: true },
      ],
      density: 0.2,
      height: 60,
      layers: { thickness: 2, area: [500, 1000] },
      disassembly: {
        complete: true,
        through_walls: [1],
        steps: [
          { placements: [0, 1], path: [[0, 0, 90]] },
          { placements: [1], path: [[0, 60, 0]] },
        ],
      },
    },
  ],
  unplaced: [
    { part: 0, copy: 2, reason: "no_place", detail: "" },
    { part: 1, copy: 1, reason: "no_place", detail: "" },
    { part: 1, copy: 2, reason: "no_place", detail: "" },
    { part: 1, copy: 3, reason: "too_large", detail: "why" },
  ],
  metrics: { copies: 7, placed: 3, density: 0.2, min_gap: null, seconds: { total: 12 }, improvement: null },
};

describe("a packing file", () => {
  const packing = readPacking(file);
  const tray = packing.trays[0];

  it("has its parts by plain names", () => {
    expect(packing.parts.map((part) => [part.file, part.object, part.count])).toEqual([
      ["bracket.stl", null, 3],
      ["set.3mf", "2", 4],
    ]);
    expect(packing.keepOut).toHaveLength(1);
  });

  it("tells when and how copies leave", () => {
    const leaves = tray?.placements.map(({ step, together, path }) => [step, together, path]);
    expect(leaves).toEqual([
      [1, 2, [[0, 0, 90]]],
      [1, 2, [[0, 0, 90]]],
      [null, 0, []],
    ]);
    expect([tray?.steps, tray?.complete, tray?.throughWalls]).toEqual([2, true, 1]);
    expect(tray?.byId.get("1/0")?.index).toBe(1);
  });

  it("has layers as shares of the base", () => {
    expect(tray?.layers).toEqual({ thickness: 2, share: [0.1, 0.2], exact: true });
  });

  it("has a row for each part and reason that was left over", () => {
    expect(packing.leftOver).toEqual([
      { part: 0, reason: "no_place", copies: 1, detail: "", which: [2], byHand: false },
      { part: 1, reason: "no_place", copies: 2, detail: "", which: [1, 2], byHand: false },
      { part: 1, reason: "too_large", copies: 1, detail: "why", which: [3], byHand: false },
    ]);
  });

  it("does without what older files lack", () => {
    const { unplaced: _, options: __, ...old } = file;
    const bare = readPacking({
      ...old,
      container: { size: [1, 1, 1] },
      trays: [{ placements: [], density: 0, height: 0, disassembly: null }],
    });
    expect(bare.leftOver).toEqual([]);
    expect(bare.trays[0]?.layers).toBeNull();
  });
});
