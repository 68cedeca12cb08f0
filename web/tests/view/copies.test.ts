import { describe, expect, it } from "vitest";
import { identity, invert, multiply, toTransform, turn } from "../../src/view/affine";
import { hexOfRgb } from "../../src/view/colour";
import { Copies } from "../../src/view/copies";
import {
  asMark,
  buildLists,
  crossing,
  faint,
  frustumOf,
  ghost,
  isWhollySeen,
  markBit,
  mayBeSeen,
  outlined,
  solid,
} from "../../src/view/lists";
import { accentOutline, Looks, markOutline, none } from "../../src/view/looks";
import { partColour } from "../../src/view/palette";
import type { ViewCopy } from "../../src/view/view";
import { moved } from "./meshes";

function copyAt(part: number, copy: number, x: number, order = copy): ViewCopy {
  return { part, copy, order, transform: moved(x, 0, 0) };
}

function filled(parts = 2, each = 3): Copies {
  const copies = new Copies();
  for (let part = 0; part < parts; ++part) {
    copies.setPart(part, [0, 0, 0, 1, 2, 3]);
    for (let copy = 0; copy < each; ++copy) copies.place(copyAt(part, copy, 10 * copy), 0, false);
  }
  return copies;
}

describe("Copies", () => {
  it("keep a slot while they stand and move in place", () => {
    const copies = filled();
    const slot = copies.slotOf({ part: 1, copy: 2 }) as number;
    expect(copies.keyOf(slot)).toEqual({ part: 1, copy: 2 });
    expect(copies.boxOf(slot)).toEqual([20, 0, 0, 21, 2, 3]);
    expect(copies.place(copyAt(1, 2, 50), 7, false)).toEqual({ slot, moved: true });
    expect(copies.boxOf(slot)).toEqual([50, 0, 0, 51, 2, 3]);
    expect(copies.movedAt[slot]).toBe(7);
    expect(copies.size).toBe(6);
  });

  it("give slots back", () => {
    const copies = filled();
    const slot = copies.slotOf({ part: 0, copy: 1 });
    expect(copies.remove({ part: 0, copy: 1 })).toBe(true);
    expect(copies.remove({ part: 0, copy: 1 })).toBe(false);
    expect([...copies.ofPart(0)].length).toBe(2);
    expect(copies.place(copyAt(1, 9, 0), 0, false)?.slot).toBe(slot);
    expect(copies.end).toBe(6);
  });

  it("keep all that is known when they become many", () => {
    const copies = filled(1, 1000);
    expect(copies.size).toBe(1000);
    expect(copies.boxOf(copies.slotOf({ part: 0, copy: 999 }) as number)[0]).toBe(9990);
    expect(copies.boxOf(copies.slotOf({ part: 0, copy: 1 }) as number)[0]).toBe(10);
    copies.clear();
    expect(copies.size).toBe(0);
    expect(copies.hasPart(0)).toBe(true);
  });

  it("do not stand without a part, and follow a better mesh", () => {
    const copies = filled();
    expect(copies.place(copyAt(5, 0, 0), 0, false)).toBeNull();
    copies.setPart(0, [0, 0, 0, 2, 2, 2]);
    expect(copies.boxOf(copies.slotOf({ part: 0, copy: 1 }) as number)).toEqual([10, 0, 0, 12, 2, 2]);
  });
});

describe("the lists of what is drawn", () => {
  it("put each shape's copies of a kind side by side", () => {
    const copies = filled();
    const kinds = new Map([
      [0, solid],
      [1, solid | crossing | outlined],
      [2, ghost],
      [3, faint],
      [4, solid | outlined | asMark],
      [5, solid | crossing],
    ]);
    const { list, ranges } = buildLists(copies, [{ parts: [0] }, { parts: [1] }], (slot) => kinds.get(slot) ?? 0);
    const [a, b] = ranges;
    const run = (from = 0, count = 0) => [...list.subarray(from, from + count)];
    expect(run(a?.solids, a?.solidCount)).toEqual([1, 0]);
    expect(a?.cuts).toBe(1);
    expect(run(a?.ghosts, a?.ghostCount)).toEqual([2]);
    expect(run(a?.outlines, a?.outlineCount)).toEqual([1]);
    expect(a?.outlineCuts).toBe(1);
    expect(run(b?.solids, b?.solidCount)).toEqual([5, 4]);
    expect(run(b?.faints, b?.faintCount)).toEqual([3]);
    expect(run(b?.outlines, b?.outlineCount)).toEqual([4 | markBit]);
    expect(b?.outlineCuts).toBe(0);
    expect(list.length).toBe(8);
  });

  it("draw parts of one shape together", () => {
    const { list, ranges } = buildLists(filled(), [{ parts: [0, 1] }], () => solid);
    expect(ranges.length).toBe(1);
    expect([...list].sort()).toEqual([0, 1, 2, 3, 4, 5]);
    expect(ranges[0]?.solidCount).toBe(6);
  });

  it("know what a camera sees", () => {
    // Orthographic, x and y from -1 to 1, z from -10 to 10.
    const frustum = frustumOf([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -0.1, 0, 0, 0, 0, 1]);
    const boxes = [-0.5, -0.5, 0, 0.5, 0.5, 1, 0.9, 0, 0, 2, 1, 1, 1.1, 0, 0, 2, 1, 1];
    expect([0, 6, 12].map((at) => mayBeSeen(frustum, boxes, at))).toEqual([true, true, false]);
    expect([0, 6, 12].map((at) => isWhollySeen(frustum, boxes, at))).toEqual([true, false, false]);
  });
});

describe("Looks", () => {
  const hex = (looks: Looks, copies: Copies, copy: number) => {
    looks.measure(copies);
    return hexOfRgb(looks.colourOf(copies, copies.slotOf({ part: 0, copy }) as number));
  };

  it("colour by part, order, height and way", () => {
    const copies = filled(1, 3);
    const looks = new Looks();
    expect(looks.legend()).toBeNull();
    expect(hex(looks, copies, 0)).not.toBe(hex(looks, copies, 1));
    looks.colouring = "order";
    expect(hex(looks, copies, 0)).toBe("#dbe5fb");
    expect(hex(looks, copies, 2)).toBe("#1f3f96");
    expect(looks.legend()?.values).toEqual([0, 1, 2]);
    looks.colouring = "height";
    copies.place({ part: 0, copy: 2, order: 2, transform: moved(0, 0, 97) }, 0, false);
    expect(hex(looks, copies, 2)).toBe("#2f6f6a");
    expect(looks.legend()?.values).toEqual([1.5, 50, 98.5]);
    looks.colouring = "way";
    expect(hex(looks, copies, 1)).toBe("#b9c0ca");
    expect(looks.legend()).toBeNull();
    copies.place({ part: 0, copy: 1, order: 1, step: 12, transform: moved(0, 0, 0) }, 0, false);
    expect(hex(looks, copies, 1)).toBe("#dbe5fb");
    expect(looks.legend()?.values).toEqual([12, 12, 12]);
  });

  it("put what is pointed at before the colouring", () => {
    const copies = filled(1, 4);
    const looks = new Looks();
    looks.select([{ part: 0, copy: 1 }]);
    expect(hex(looks, copies, 1)).toBe("#2a5bd7");
    looks.leave([{ part: 0, copy: 0 }]);
    expect(hex(looks, copies, 0)).toBe("#2a5bd7");
    expect(hex(looks, copies, 1)).toBe("#8fb0ff");
    looks.markThese([{ part: 0, copy: 2 }], true, "warn");
    expect(hex(looks, copies, 2)).toBe("#e0a030");
    expect(hex(looks, copies, 3)).toBe("#b9c0ca");
    looks.theme = "dark";
    expect(hex(looks, copies, 3)).toBe("#5d6672");
    const outlines = [0, 1, 2, 3].map((copy) => looks.outlineOf(copies, copies.slotOf({ part: 0, copy }) as number));
    expect(outlines).toEqual([none, accentOutline, markOutline, none]);
  });

  it("hide and fade by copy", () => {
    const copies = filled(1, 2);
    const looks = new Looks();
    looks.hidden = ({ copy }) => copy === 1;
    looks.faint = ({ copy }) => copy === 0;
    expect(looks.isHidden(copies, 0)).toBe(false);
    expect(looks.isHidden(copies, 1)).toBe(true);
    expect(looks.isFaint(copies, 0)).toBe(true);
  });

  it("paint copies near their part's colour", () => {
    const copies = filled(1, 1);
    expect(hex(new Looks(), copies, 0)).toBe(partColour(0));
  });
});

describe("transforms", () => {
  it("turn about a point and come back", () => {
    const m = multiply(turn([0, 0, 1], 90, [5, 5, 0]), [2, 0, 0, 1, 0, 2, 0, 2, 0, 0, 2, 3]);
    const back = multiply(invert(m) ?? identity, m);
    back.forEach((v, i) => {
      expect(v).toBeCloseTo(identity[i] as number, 9);
    });
    const [x, y] = toTransform(m);
    expect([...(x ?? [])].map((v) => Math.round(v * 1e6) / 1e6)).toEqual([0, -2, 0, 8]);
    expect([...(y ?? [])].map((v) => Math.round(v * 1e6) / 1e6)).toEqual([2, 0, 0, 1]);
    expect(invert([1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0])).toBeNull();
  });
});
