/// How a tray comes apart: the plan, what stands where at a time, the list, and what is in the way.

import { describe, expect, it } from "vitest";
import { barsOf, ticksOf } from "../../src/app/state/apart_bars";
import { candidates, sweptBoxes } from "../../src/app/state/apart_blockers";
import { drawnApart } from "../../src/app/state/apart_explode";
import { leftAfter, nextStep, partingSteps, planOf } from "../../src/app/state/apart_plan";
import { groupSpans, rowOfStep, rowsOf } from "../../src/app/state/apart_rows";
import { alongPath, distanceAt, pathPoints, placeAt } from "../../src/app/state/apart_time";
import type { Sides } from "../../src/app/state/draft";
import type { PackedStep, Placement } from "../../src/app/state/packing";
import type { Extent } from "../../src/app/state/turns";

const step = (placements: number[], ...path: Sides[]): PackedStep => ({ placements, path, throughWalls: false });

function placements(count: number): Placement[] {
  return Array.from({ length: count }, (_, index) => ({ index }) as Placement);
}

function plan(count: number, ...steps: PackedStep[]) {
  return planOf({ placements: placements(count), plan: steps });
}

/// 0 leaves; 1, 2, 3 leave as one; of these 2 and 3 as one again; then each of them; 4 stays.
const nested = plan(
  5,
  step([0], [0, 0, 10]),
  step([1, 2, 3], [0, 0, 50]),
  step([2, 3], [0, 20, 0]),
  step([3], [5, 0, 0]),
  step([2]),
  step([1]),
);

const cube = (x: number, y: number, z: number): Extent => ({ low: [x, y, z], high: [x + 10, y + 10, z + 10] });

describe("a plan", () => {
  it("makes an assembly of each group, in what it stood together with", () => {
    expect(nested.assemblies.map((own) => [own.members, own.madeBy, own.offset])).toEqual([
      [[0, 1, 2, 3, 4], -1, [0, 0, 0]],
      [[1, 2, 3], 1, [0, 0, 50]],
      [[2, 3], 2, [0, 20, 50]],
    ]);
    expect(nested.steps.map((own) => own.from)).toEqual([0, 0, 1, 2, 2, 1]);
  });

  it("knows when copies are out for good, and which stay", () => {
    expect(nested.outAt).toEqual([0, 5, 4, 3, Number.POSITIVE_INFINITY]);
    expect(nested.staying).toEqual([4]);
    expect([-1, 0, 1, 3, 5].map((index) => leftAfter(nested, index))).toEqual([5, 4, 4, 3, 1]);
  });

  it("finds a copy's next step, and the steps that part a group", () => {
    expect(nextStep(nested, 3, 0)?.index).toBe(1);
    expect(nextStep(nested, 3, 1.5)?.index).toBe(1);
    expect(nextStep(nested, 3, 2)?.index).toBe(2);
    expect(nextStep(nested, 3, 4)).toBeNull();
    expect(nextStep(nested, 4, 0)).toBeNull();
    expect(partingSteps(nested, 1).map((own) => own.index)).toEqual([2, 3, 4, 5]);
    expect(partingSteps(nested, 2).map((own) => own.index)).toEqual([3, 4]);
  });
});

describe("time", () => {
  it("moves what a step moves, and takes it away once the step is done", () => {
    expect(placeAt(nested, 0, 0)).toEqual({ kind: "moves", offset: [0, 0, 0] });
    expect(placeAt(nested, 0, 0.5)).toEqual({ kind: "moves", offset: [0, 0, 5] });
    expect(placeAt(nested, 0, 1)).toEqual({ kind: "out" });
    expect(placeAt(nested, 4, 6)).toEqual({ kind: "stands", offset: [0, 0, 0] });
  });

  it("keeps a group outside where it came to, and parts it from there", () => {
    expect(placeAt(nested, 1, 2.5)).toEqual({ kind: "stands", offset: [0, 0, 50] });
    expect(placeAt(nested, 2, 2.5)).toEqual({ kind: "moves", offset: [0, 10, 50] });
    expect(placeAt(nested, 2, 3.5)).toEqual({ kind: "stands", offset: [0, 20, 50] });
    expect(placeAt(nested, 3, 3.5)).toEqual({ kind: "moves", offset: [2.5, 20, 50] });
    expect(placeAt(nested, 2, 4.5)).toEqual({ kind: "moves", offset: [0, 20, 50] });
  });

  it("goes leg by leg; a short one is still seen", () => {
    const [own] = plan(1, step([0], [1, 0, 0], [0, 0, 99])).steps;
    if (!own) throw new Error("a step is missing");
    expect(alongPath(own, 0)).toEqual([0, 0, 0]);
    const early = alongPath(own, 0.05);
    expect(early[0]).toBeGreaterThan(0.4);
    expect(early[2]).toBe(0);
    expect(alongPath(own, 0.5)[0]).toBe(1);
    expect(alongPath(own, 1)).toEqual([1, 0, 99]);
    expect(distanceAt(own, 1)).toBe(100);
  });

  it("draws a path from where what moves stands", () => {
    const own = nested.steps[3];
    if (!own) throw new Error("a step is missing");
    expect(pathPoints(nested, own, [1, 1, 1])).toEqual([
      [1, 21, 51],
      [6, 21, 51],
    ]);
  });
});

describe("the list", () => {
  it("has a group with all that parts it, and what stays", () => {
    expect(rowsOf(nested)).toEqual([
      { kind: "step", step: 0, depth: 0, last: false },
      { kind: "group", step: 1, depth: 0 },
      { kind: "group", step: 2, depth: 1 },
      { kind: "step", step: 3, depth: 2, last: false },
      { kind: "step", step: 4, depth: 2, last: false },
      { kind: "step", step: 5, depth: 1, last: true },
      { kind: "caption", count: 1 },
      { kind: "stays", placement: 4 },
    ]);
    expect(rowOfStep(rowsOf(nested))).toEqual([0, 1, 2, 3, 4, 5]);
    expect(groupSpans(nested)).toEqual([
      { first: 1, last: 5 },
      { first: 2, last: 4 },
    ]);
  });

  it("names copies of a group that are parted later, or never", () => {
    const late = plan(4, step([0, 1], [0, 0, 9]), step([2], [0, 0, 9]), step([0], [9, 0, 0]));
    expect(rowsOf(late)).toEqual([
      { kind: "group", step: 0, depth: 0 },
      { kind: "member", placement: 0, depth: 1, last: false },
      { kind: "member", placement: 1, depth: 1, last: true },
      { kind: "step", step: 1, depth: 0, last: false },
      { kind: "step", step: 2, depth: 0, last: false },
      { kind: "caption", count: 2 },
      { kind: "stays", placement: 1 },
      { kind: "stays", placement: 3 },
    ]);
  });

  it("is drawn as bars, however many steps there are", () => {
    const many = plan(1000, ...Array.from({ length: 1000 }, (_, i) => step([i], [0, 0, i + 1])));
    const bars = barsOf(many, 100);
    expect(bars).toHaveLength(100);
    expect(bars.every((bar, i) => bar.height <= 1 && bar.height >= (bars[i - 1]?.height ?? 0))).toBe(true);
    expect(barsOf(many, 5000)).toHaveLength(1000);
    expect(ticksOf(220, 16)).toEqual([1, 20, 40, 60, 80, 100, 120, 140, 160, 180, 200, 220]);
    expect(ticksOf(1, 16)).toEqual([1]);
  });
});

describe("what is in the way", () => {
  const extents = [cube(0, 0, 20), cube(0, 0, 0), cube(50, 0, 20), cube(0, 0, 40), cube(0, 0, 60)];
  const stack = plan(5, step([3], [0, 0, 99]), step([0], [0, 0, 99]), step([2], [0, 0, 99]), step([1], [0, 0, 99]));

  it("leaves before it and stands where its path leads", () => {
    const own = stack.steps[3];
    if (!own) throw new Error("a step is missing");
    // The copy at the top has no step: it is not said to leave first.
    expect(candidates(stack, own, extents)).toEqual([
      { placement: 0, step: 1 },
      { placement: 3, step: 0 },
    ]);
  });

  it("is looked for among those of the same group only, once it is outside", () => {
    const own = nested.steps[4];
    if (!own) throw new Error("a step is missing");
    const up = { ...own, path: [[0, 0, 99]] as Sides[] };
    expect(candidates(nested, up, [cube(0, 0, 20), cube(0, 0, 40), cube(0, 0, 0), cube(0, 0, 60), null])).toEqual([
      { placement: 3, step: 3 },
    ]);
  });

  it("sweeps a box with every move", () => {
    expect(
      sweptBoxes(cube(0, 0, 0), [
        [5, 0, 0],
        [0, 0, -20],
      ] as Sides[]),
    ).toEqual([
      { low: [0, 0, 0], high: [15, 10, 10] },
      { low: [5, 0, -20], high: [15, 10, 10] },
    ]);
  });
});

describe("all, drawn apart", () => {
  it("keeps groups together, and what lies on the floor there", () => {
    const offsets = drawnApart(
      nested,
      [cube(0, 0, 0), cube(40, 0, 30), cube(60, 0, 30), cube(80, 0, 30), null],
      [100, 100, 100],
    );
    expect(offsets[1]).toEqual(offsets[2]);
    expect(offsets[2]).toEqual(offsets[3]);
    expect(offsets[0]?.[2]).toBe(0);
    expect(offsets[0]?.[0]).toBeLessThan(0);
    expect(offsets[4]).toEqual([0, 0, 0]);
  });
});
