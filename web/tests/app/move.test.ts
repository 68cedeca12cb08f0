/// Copies that are moved by hand: where they stand, the nearest free place, and what is said of it. Locks.

import { describe, expect, it, vi } from "vitest";
import { nearestFree } from "../../src/app/change/free_place";
import { copiesOf, followed, lockedIn, standing, withLocks } from "../../src/app/change/locks";
import { outward } from "../../src/app/change/outward";
import { between, quarterTurn, sameTransform, sameTurn, shifted, way } from "../../src/app/change/placing";
import { judged, movedBy, touched } from "../../src/app/words/move";
import { thin } from "../../src/app/words/numbers";
import { at, packingOf } from "./packing_of";

describe("a transform", () => {
  const start = shifted(at(10), [0, 4, -2]);

  it("is shifted and shifted back", () => {
    expect(shifted(shifted(start, [1, 2, 3]), [-1, -2, -3])).toEqual(start);
    expect(way(start, shifted(start, [1, 2, 3]))).toEqual([1, 2, 3]);
  });

  it("is the same after four quarter turns, and its middle stays", () => {
    for (const axis of ["x", "y", "z"] as const) {
      let turned = start;
      for (let i = 0; i < 4; i += 1) turned = quarterTurn(turned, axis, [5, 5, 5]);
      expect(sameTransform(turned, start)).toBe(true);
    }
    // X goes to Y, counted from above.
    const turned = quarterTurn(at(1), "z", [0, 0, 0]);
    expect(turned.map((row) => row[3])).toEqual([0, 1, 0, 1]);
    expect(sameTurn(turned, at(1))).toBe(false);
  });

  it("goes along a way", () => {
    expect(between(at(0), at(8), 0.25)).toEqual(at(2));
  });
});

describe("the nearest free place", () => {
  it("is found to a tenth of a millimetre, with few questions", async () => {
    const mayStand = vi.fn(async (share: number) => 100 * share <= 63.2);
    const share = await nearestFree({ length: 100, touchesNothing: (own) => 100 * own < 66, mayStand });
    expect(100 * share).toBeLessThanOrEqual(63.2);
    expect(100 * share).toBeGreaterThan(63);
    expect(mayStand.mock.calls.length).toBeLessThan(13);
  });

  it("is where it began, if nothing else is free", async () => {
    expect(await nearestFree({ length: 10, touchesNothing: () => false, mayStand: async () => false })).toBe(0);
  });

  it("lies beside one that was turned", async () => {
    const x = (transform: ReturnType<typeof at>) => transform[0]?.[3] ?? 0;
    const found = await outward(at(50), {
      touchesNothing: (own) => Math.abs(x(own as ReturnType<typeof at>) - 50) > 9,
      mayStand: async (own) => Math.abs(x(own as ReturnType<typeof at>) - 50) > 12,
    });
    expect(Math.abs(x(found as ReturnType<typeof at>) - 50)).toBeGreaterThan(12);
    expect(Math.abs(x(found as ReturnType<typeof at>) - 50)).toBeLessThan(15);
  });
});

describe("what is said of a place", () => {
  const name = ({ part, copy }: { part: number; copy: number }) => `${["bracket", "mug"][part]} ${copy + 1}`;
  const clearance = {
    part: 0,
    copy: 0,
    tray: 1,
    nearest: { part: 1, copy: 1, distance: 0.8, gap: 3 },
    next: null,
    wall: { side: "front" as const, distance: 11, gap: 5 },
    clear: false,
  };

  it("names the copy that is too near, with both gaps", () => {
    expect(judged(clearance, name)).toEqual({
      tone: "bad",
      bold: "Too close to mug 2.",
      text: `The gap is 0.8${thin}mm; 3.0${thin}mm is asked for.`,
    });
    const hair = { ...clearance, nearest: { ...clearance.nearest, distance: 2.98 } };
    expect(judged(hair, name).text).toBe(`The gap is 2.98${thin}mm; 3.00${thin}mm is asked for.`);
    expect(judged({ ...clearance, nearest: { ...clearance.nearest, distance: 0 } }, name).bold).toBe("Touches mug 2.");
  });

  it("names the wall where that lacks more", () => {
    const wall = { side: "front" as const, distance: 1, gap: 5 };
    expect(judged({ ...clearance, wall }, name).bold).toBe("Too close to the front wall.");
    expect(judged({ ...clearance, wall: { ...wall, distance: -2 } }, name)).toMatchObject({
      bold: "Outside the tray.",
      text: `It sticks out at the front wall by 2.0${thin}mm.`,
    });
  });

  it("says that it may stand, or that something else is in its way", () => {
    expect(judged({ ...clearance, clear: true }, name).tone).toBe("ok");
    expect(judged({ ...clearance, nearest: null }, name).bold).toBe("It cannot stand here.");
  });

  it("says at once what it touches", () => {
    const copies = [
      { part: 1, copy: 1 },
      { part: 0, copy: 0 },
      { part: 0, copy: 1 },
    ];
    expect(touched(copies, name, false).bold).toBe("Touches mug 2 and 2 more.");
    expect(touched([], name, true).bold).toBe("Outside the tray.");
  });

  it("has signs", () => {
    expect([18, -9, 0.01].map(movedBy)).toEqual(["+18.0", "−9.0", "0.0"]);
  });
});

describe("locks", () => {
  const packing = packingOf(
    [
      [0, 0, 10],
      [0, 1, 20],
      [1, 0, 30],
    ],
    [[1, 1, 40]],
  );

  it("are set for a part of a tray, or for a tray", () => {
    expect(copiesOf(packing, 1, 0)).toHaveLength(2);
    expect(copiesOf(packing, 2)).toEqual([{ tray: 2, part: 1, copy: 1 }]);
    expect(copiesOf(packing, 0)).toHaveLength(4);
    const locks = withLocks(new Set(), copiesOf(packing, 1, 0), true);
    expect([...locks]).toEqual(["1/0/0", "1/0/1"]);
    expect(withLocks(locks, copiesOf(packing, 1, 0), true)).toBe(locks);
    expect([...withLocks(locks, [{ tray: 1, part: 0, copy: 0 }], false)]).toEqual(["1/0/1"]);
    expect(lockedIn(locks, 2)).toEqual([]);
  });

  it("go with the copies that stand", () => {
    expect([...standing(new Set(["1/0/0", "1/1/7", "3/0/0"]), packing)]).toEqual(["1/0/0"]);
  });

  it("follow copies that have other numbers after the rest was packed again", () => {
    const after = packingOf([
      [1, 3, 30],
      [0, 0, 90],
      [0, 5, 20],
    ]);
    expect([...followed(new Set(["1/0/1", "1/1/0", "1/0/0"]), packing, after)].sort()).toEqual(["1/0/5", "1/1/3"]);
  });
});
