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
  const full = { scale: 1, samples: 4 };
  const plain = { scale: 1, samples: 0 };
  const few = 100;

  /// One that has drawn an empty tray, at so many ms a frame.
  const warm = (ms: number) => {
    const pace = new Pace();
    for (let i = 0; i < 4; ++i) pace.drawn(i, i === 0 ? null : ms, false, few);
    return pace;
  };

  it("draws plainly until the machine has shown what it can do", () => {
    const pace = new Pace();
    expect(pace.quality(false, few)).toEqual(plain);
    expect(pace.quality(true, few)).toEqual(plain);
    expect(pace.wantsTime(0, false, few)).toBe(false); // builds the shaders
    pace.drawn(0, null, false, few);
    expect(pace.wantsTime(1, false, few)).toBe(true);
    pace.drawn(1, 5, false, few);
    expect(pace.quality(false, few)).toEqual(full);
    expect(pace.quality(true, few)).toEqual(full);
  });

  it("draws much that is new plainly at first, however quick little was", () => {
    const pace = warm(5);
    const many = 1_000_000;
    expect(pace.quality(true, many)).toEqual(plain);
    expect(pace.wantsTime(1000, false, many)).toBe(true);
    pace.drawn(1000, 1500, false, many);
    expect(pace.isNew(many)).toBe(false);
    expect(pace.quality(true, many).samples).toBe(0);
    pace.drawn(2000, 8, false, many);
    expect(pace.quality(true, many)).toEqual(full);
  });

  it("gets coarser while frames are slow, and full at rest", () => {
    const pace = warm(5);
    const samples = [];
    for (let i = 0; i < 6; ++i) {
      if (pace.wantsTime(i, true, few)) pace.drawn(i, 120, true, few);
      samples.push(pace.quality(true, few).scale);
    }
    expect(samples.at(-1)).toBe(0.5);
    expect(pace.quality(false, few)).toEqual(full);
  });

  it("starts coarse where a full frame is known to be slow, and fine again where it is not", () => {
    const pace = warm(140);
    expect(pace.quality(true, few).samples).toBe(0);
    expect(pace.wantsTime(100, false, few)).toBe(false);
    expect(pace.wantsTime(1000, false, few)).toBe(true);
    pace.drawn(1000, 8, false, few);
    expect(pace.quality(true, few)).toEqual(pace.quality(false, few));
  });

  it("does without smooth edges at rest where they take a second", () => {
    const pace = warm(5);
    for (let i = 0; i < 9; ++i) pace.drawn(i, 2000, false, few);
    expect(pace.quality(false, few)).toEqual(plain);
    pace.drawn(20, 100, false, few);
    expect(pace.quality(false, few)).toEqual(full);
  });
});
