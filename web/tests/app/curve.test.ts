/// How a value becomes better: the curve, and what was gained in words.

import { describe, expect, it } from "vitest";
import type { Progress } from "../../src/api/types";
import { plotOf } from "../../src/app/build/curve_figure";
import { Curve } from "../../src/app/state/curve";
import { LiveRun } from "../../src/app/state/live_run";
import { gainWords, improvedWords, valueWords } from "../../src/app/words/improve";
import { thin } from "../../src/app/words/numbers";

const told = (seconds: number, now: number, what = "height", before = 375): Progress => ({
  phase: "improve",
  done: 0,
  total: 0,
  seconds,
  left: 60 - seconds,
  what,
  before,
  now,
});

describe("the curve", () => {
  it("has a point for each better value", () => {
    const curve = new Curve();
    for (const [seconds, now] of [
      [0, 375],
      [1, 375],
      [4, 370],
      [5, 370],
      [9, 362.7],
      [12, 362.7],
    ] as const)
      curve.add(told(seconds, now));
    expect(curve.points).toEqual([
      { seconds: 0, value: 375 },
      { seconds: 4, value: 370 },
      { seconds: 9, value: 362.7 },
    ]);
    expect([curve.now, curve.seconds, curve.left]).toEqual([362.7, 12, 48]);
  });

  it("is the same when it is told again, and begins anew with another value", () => {
    const run = new LiveRun();
    for (const line of [told(0, 375), told(4, 370)]) run.apply(line);
    run.clear();
    expect(run.curve.isThere).toBe(false);
    for (const line of [told(0, 375), told(4, 370)]) run.apply(line);
    expect(run.curve.points).toHaveLength(2);
    run.apply(told(5, 0.2, "density", 0.1));
    expect([run.curve.what, run.curve.points.length]).toEqual(["density", 2]);
  });

  it("does not mind other phases", () => {
    const curve = new Curve();
    curve.add({ phase: "check", done: 0, total: 1, seconds: 3 });
    expect([curve.isThere, plotOf(curve)]).toEqual([false, null]);
  });

  it("goes up where the value becomes better, whether that is less or more", () => {
    for (const [what, before, now] of [
      ["height", 375, 360],
      ["density", 0.1, 0.2],
    ] as const) {
      const curve = new Curve();
      curve.add(told(0, before, what, before));
      curve.add(told(30, now, what, before));
      const plot = plotOf(curve);
      expect(plot?.nowY).toBeLessThan(plot?.startY ?? 0);
      // Half of the time has gone.
      expect(plot?.nowX).toBeCloseTo(136);
    }
  });
});

describe("what was gained", () => {
  it("is said in the words of its kind", () => {
    expect(gainWords("height", 375, 362.7)).toBe(`12.3${thin}mm lower`);
    expect(gainWords("copies", 220, 221)).toBe("1 copy more");
    expect(gainWords("density", 0.1, 0.1056)).toBe(`0.56${thin}% more filled`);
    expect(gainWords("trays", 2.4, 2.15)).toBe("0.25 trays less");
    expect(gainWords("box", 5e6, 4.5e6)).toBe(`500${thin}cm³ smaller`);
    expect(gainWords("value", 10, 12)).toBe("2 more");
    expect(valueWords("height", 362.71)).toBe(`362.7${thin}mm`);
  });

  it("is nothing where nothing was", () => {
    expect(gainWords("height", 375, 375)).toBeNull();
    expect(improvedWords("height", 375, 375)).toBe("Nothing better was found.");
    expect(improvedWords("height", 375, 362.7)).toBe(
      `Made better: 12.3${thin}mm lower, 362.7${thin}mm instead of 375.0${thin}mm.`,
    );
  });
});
