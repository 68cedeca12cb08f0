import { describe, expect, it } from "vitest";
import type { Ray } from "../../src/view/camera";
import { Copies } from "../../src/view/copies";
import { boxEntry, keptReach, pick } from "../../src/view/pick";
import type { Plane } from "../../src/view/section";
import type { Section, Size } from "../../src/view/view";
import { boxMesh, moved } from "./meshes";

const mesh = boxMesh(10, 10, 10);

function row(): Copies {
  const copies = new Copies();
  copies.setPart(0, [0, 0, 0, 10, 10, 10]);
  for (let copy = 0; copy < 3; ++copy) {
    copies.place({ part: 0, copy, order: copy, transform: moved(0, 20 * copy, 0) }, 0, false);
  }
  return copies;
}

function ask(copies: Copies, ray: Ray, section: Section | null = null, slots = copies.all()) {
  return pick(ray, { slots, boxes: copies.boxes, rows: copies.rows, meshOf: () => mesh }, section);
}

const along: Ray = { origin: [5, -100, 5], direction: [0, 1, 0] };

describe("picking", () => {
  it("meets the first of a row, and where", () => {
    const hit = ask(row(), along);
    expect(hit?.slot).toBe(0);
    expect(hit?.distance).toBeCloseTo(100);
    expect(hit?.point[1]).toBeCloseTo(0);
  });

  it("passes copies that are not drawn, and misses beside all", () => {
    const copies = row();
    expect(ask(copies, along, null, [1, 2])?.slot).toBe(1);
    expect(ask(copies, { ...along, origin: [50, -100, 5] })).toBeNull();
    expect(ask(copies, along, null, [])).toBeNull();
  });

  it("counts mm however a mesh is scaled and turned", () => {
    const copies = row();
    const transform = [
      [0, -25.4, 0, 0],
      [25.4, 0, 0, -500],
      [0, 0, 25.4, 0],
      [0, 0, 0, 1],
    ];
    copies.place({ part: 0, copy: 9, order: 9, transform }, 0, false);
    const hit = ask(copies, { origin: [-20, -1000, 20], direction: [0, 1, 0] });
    expect(copies.keyOf(hit?.slot as number).copy).toBe(9);
    expect(hit?.distance).toBeCloseTo(500, 3);
  });

  it("meets nothing that the section cut away", () => {
    const section: Section = { axis: "y", at: 15, flipped: true };
    const hit = ask(row(), along, section);
    expect(hit?.slot).toBe(1);
    expect(hit?.point[1]).toBeCloseTo(20);
  });

  it("meets the cut face where the section goes through a copy", () => {
    const hit = ask(row(), along, { axis: "y", at: 4, flipped: true });
    expect(hit?.slot).toBe(0);
    expect(hit?.point[1]).toBeCloseTo(4, 1);
    // From the other side there is no cut face to meet.
    const back: Ray = { origin: [5, 100, 5], direction: [0, -1, 0] };
    expect(ask(row(), back, { axis: "y", at: 4, flipped: false })?.point[1]).toBeCloseTo(4, 1);
  });

  it("knows which part of a ray is kept", () => {
    const plane: Plane = [0, 0, -1, 10];
    const down: Size = [0, 0, -1];
    expect(keptReach({ origin: [0, 0, 30], direction: down }, plane)).toEqual({ near: 20, far: Infinity });
    expect(keptReach({ origin: [0, 0, 5], direction: [0, 0, 1] }, plane)).toEqual({ near: 0, far: 5 });
    expect(keptReach({ origin: [0, 0, 30], direction: [0, 0, 1] }, plane)).toBeNull();
    expect(keptReach({ origin: [0, 0, 30], direction: [1, 0, 0] }, plane)).toBeNull();
    expect(keptReach({ origin: [0, 0, 5], direction: [1, 0, 0] }, plane)).toEqual({ near: 0, far: Infinity });
  });

  it("enters boxes where they begin, or at once from inside", () => {
    const box = [0, 0, 0, 10, 10, 10];
    const reach = { near: 0, far: Infinity };
    expect(boxEntry(along, box, 0, reach)).toBeCloseTo(100);
    expect(boxEntry({ origin: [5, 5, 5], direction: [0, 1, 0] }, box, 0, reach)).toBe(0);
    expect(boxEntry({ origin: [5, 50, 5], direction: [0, 1, 0] }, box, 0, reach)).toBeNull();
    expect(boxEntry(along, box, 0, { near: 0, far: 50 })).toBeNull();
  });
});
