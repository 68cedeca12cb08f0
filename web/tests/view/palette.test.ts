import { describe, expect, it } from "vitest";
import { hexOfRgb, mix, oklchOfRgb, rgbOfHex, rgbOfOklch } from "../../src/view/colour";
import { copyRgb, palette, partColour, rampColours, rampRgb } from "../../src/view/palette";

const turned = (from: number, to: number) => ((((to - from + 180) % 360) + 360) % 360) - 180;

describe("colours", () => {
  it("come back through OKLCH", () => {
    for (const hex of [...palette, "#000000", "#ffffff", "#ff0000", "#2a5bd7"]) {
      expect(hexOfRgb(rgbOfOklch(oklchOfRgb(rgbOfHex(hex))))).toBe(hex);
    }
  });

  it("know OKLCH's values of red and white", () => {
    const red = oklchOfRgb(rgbOfHex("#ff0000"));
    expect(red.lightness).toBeCloseTo(0.628, 3);
    expect(red.chroma).toBeCloseTo(0.2577, 3);
    expect(red.hue).toBeCloseTo(29.23, 1);
    expect(oklchOfRgb([1, 1, 1]).lightness).toBeCloseTo(1, 4);
  });

  it("stay on the screen however strong they are asked for", () => {
    const rgb = rgbOfOklch({ lightness: 0.7, chroma: 0.5, hue: 140 });
    for (const v of rgb) expect(v >= 0 && v <= 1).toBe(true);
    const got = oklchOfRgb(rgb);
    expect(got.lightness).toBeCloseTo(0.7, 2);
    expect(Math.abs(turned(got.hue, 140))).toBeLessThan(2);
  });

  it("mix from end to end", () => {
    const a = rgbOfHex("#dbe5fb");
    const b = rgbOfHex("#1f3f96");
    expect(hexOfRgb(mix(a, b, 0))).toBe("#dbe5fb");
    expect(hexOfRgb(mix(a, b, 1))).toBe("#1f3f96");
  });
});

describe("the part palette", () => {
  it("is the design's", () => {
    expect(palette.length).toBe(16);
    expect(partColour(0)).toBe("#69a3cb");
    expect(partColour(4, "dark")).toBe("#826bb3");
    expect(partColour(15)).toBe("#7d8792");
  });

  it("turns by 19 degrees and darkens from the 17th part on", () => {
    for (let i = 0; i < 16; ++i) {
      const first = oklchOfRgb(rgbOfHex(partColour(i)));
      const second = oklchOfRgb(rgbOfHex(partColour(16 + i)));
      expect(second.lightness).toBeLessThan(first.lightness);
      expect(second.lightness).toBeGreaterThan(first.lightness - 0.05);
      // A grey has hardly a hue to turn.
      if (first.chroma > 0.04) expect(Math.abs(turned(first.hue, second.hue) - 19)).toBeLessThan(3);
    }
  });

  it("has a colour for 2,000 parts, none of them black", () => {
    for (let i = 0; i < 2000; ++i) {
      expect(partColour(i)).toMatch(/^#[0-9a-f]{6}$/);
      expect(oklchOfRgb(rgbOfHex(partColour(i))).lightness).toBeGreaterThan(0.35);
    }
  });

  it("lets copies differ within ±0.025 lightness and ±4 degrees", () => {
    for (let part = 0; part < 16; ++part) {
      const base = oklchOfRgb(rgbOfHex(partColour(part)));
      const seen = new Set<string>();
      for (let copy = 0; copy < 200; ++copy) {
        const { lightness, hue, chroma } = oklchOfRgb(copyRgb(part, copy));
        expect(Math.abs(lightness - base.lightness)).toBeLessThan(0.0255);
        if (chroma > 0.02) expect(Math.abs(turned(base.hue, hue))).toBeLessThan(4.3);
        seen.add(hexOfRgb(copyRgb(part, copy)));
      }
      expect(seen.size).toBeGreaterThan(50);
      expect(copyRgb(part, 3)).toEqual(copyRgb(part, 3));
    }
  });
});

describe("the ramps", () => {
  it("run between the design's ends", () => {
    expect(rampColours("one-hue")[0]).toBe("#dbe5fb");
    expect(rampColours("one-hue").at(-1)).toBe("#1f3f96");
    expect(rampColours("height")[0]).toBe("#f3e7c4");
    expect(rampColours("height").at(-1)).toBe("#2f6f6a");
    expect(rampColours("height", 3).length).toBe(3);
  });

  it("get darker all the way", () => {
    for (const ramp of ["one-hue", "height"] as const) {
      const light = Array.from({ length: 21 }, (_, i) => oklchOfRgb(rampRgb(ramp, i / 20)).lightness);
      for (let i = 1; i < light.length; ++i) expect(light[i]).toBeLessThan(light[i - 1] as number);
    }
    expect(rampRgb("height", -1)).toEqual(rampRgb("height", 0));
  });
});
