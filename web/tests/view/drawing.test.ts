import { describe, expect, it } from "vitest";
import type { Box } from "../../src/view/affine";
import { boxLines } from "../../src/view/box_lines";
import { Pace } from "../../src/view/pace";

const tray: Box = [0, 0, 0, 100, 80, 60];

describe("the edges of a box", () => {
  const faint = (eye: readonly [number, number, number]) =>
    boxLines(tray, eye, { colour: "#5a6270", open: false }).filter((line) => (line.opacity ?? 1) < 0.6);

  it("are drawn lightly where they lie before the contents", () => {
    // Seen from a corner, three edges lead to the nearest one; seen square, none does.
    expect(faint([300, -200, 200]).length).toBe(3);
    expect(faint([300, -200, 200]).flatMap((l) => [l.from, l.to].map(String))).toContain("100,0,60");
    expect(faint([50, -500, 30]).length).toBe(0);
    expect(faint([50, -500, 300]).length).toBe(1);
  });

  it("fade upwards in a tray without a ceiling", () => {
    const lines = boxLines(tray, [300, -200, 200], { colour: "#5a6270", open: true });
    expect(lines.length).toBe(8);
    expect(lines.filter((line) => line.endOpacity === 0).length).toBe(4);
    expect(lines.every((line) => line.from[2] === 0)).toBe(true);
  });
});

describe("the pace", () => {
  it("gets coarser while frames are slow, and full at rest", () => {
    const pace = new Pace();
    expect(pace.quality(true)).toEqual(pace.quality(false));
    pace.timed(0, 900, false); // builds the shaders
    const samples = [];
    for (let i = 0; i < 6; ++i) {
      if (pace.wantsTime(i, true)) pace.timed(i, 120, true);
      samples.push(pace.quality(true).scale);
    }
    expect(samples.at(-1)).toBe(0.5);
    expect(pace.quality(false)).toEqual({ scale: 1, samples: 4 });
  });

  it("starts coarse where a full frame is known to be slow, and fine again where it is not", () => {
    const pace = new Pace();
    pace.timed(0, 5, false);
    pace.timed(0, 140, false);
    expect(pace.quality(true).samples).toBe(0);
    expect(pace.wantsTime(100, false)).toBe(false);
    expect(pace.wantsTime(1000, false)).toBe(true);
    pace.timed(1000, 8, false);
    expect(pace.quality(true)).toEqual(pace.quality(false));
  });

  it("does without smooth edges at rest only where they take a second", () => {
    const pace = new Pace();
    pace.timed(0, 5000, false);
    expect(pace.quality(false).samples).toBe(4);
    for (let i = 0; i < 9; ++i) pace.timed(i, 2000, false);
    expect(pace.quality(false)).toEqual({ scale: 1, samples: 0 });
    pace.timed(20, 100, false);
    expect(pace.quality(false).samples).toBe(4);
  });
});
