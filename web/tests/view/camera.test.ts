import { describe, expect, it } from "vitest";
import {
  along,
  basisOf,
  between,
  corners,
  depthRange,
  framed,
  homeAzimuth,
  homeElevation,
  type Lens,
  lensView,
  type Orbit,
  onTargetPlane,
  panned,
  project,
  rayAt,
  turned,
  zoomed,
} from "../../src/view/camera";
import { ease } from "../../src/view/motion";
import type { Size } from "../../src/view/view";

const lens: Lens = { view: lensView, aspect: 1.5 };
const orbit: Orbit = { target: [190, 142, 190], distance: 900, azimuth: homeAzimuth, elevation: homeElevation };

function close(a: Size, b: Size): void {
  a.forEach((v, i) => {
    expect(v).toBeCloseTo(b[i] as number, 6);
  });
}

describe("the camera", () => {
  it("shows x down to the right and y up to the right at first", () => {
    const { right, up } = basisOf(orbit);
    expect(right[0]).toBeGreaterThan(0);
    expect(up[0]).toBeLessThan(0);
    expect(right[1]).toBeGreaterThan(0);
    expect(up[1]).toBeGreaterThan(0);
    expect(up[2]).toBeGreaterThan(0.7);
  });

  it("sends rays to where it draws things", () => {
    for (const p of [
      [0, 0, 0],
      [380, 284, 380],
      [10, 200, 50],
    ] as const) {
      const at = project(orbit, lens, p);
      const ray = rayAt(orbit, lens, at.x, at.y);
      const d = Math.hypot(p[0] - ray.origin[0], p[1] - ray.origin[1], p[2] - ray.origin[2]);
      close(along(ray.origin, ray.direction, d), p);
    }
    expect(project(orbit, lens, along(basisOf(orbit).eye, basisOf(orbit).back, 5)).depth).toBeLessThan(0);
  });

  it("looks straight down without losing its way, and no further", () => {
    const down = turned(orbit, 0, 10);
    const { right, up, back } = basisOf(down);
    close(back, [0, 0, 1]);
    expect(Math.hypot(...right)).toBeCloseTo(1);
    expect(Math.hypot(...up)).toBeCloseTo(1);
    expect(right[2]).toBe(0);
  });

  it("leaves what is under the pointer where it is while zooming", () => {
    const pivot = onTargetPlane(orbit, rayAt(orbit, lens, 0.6, -0.3));
    const nearer = zoomed(orbit, 0.5, pivot, 1, 1e4);
    const at = project(nearer, lens, pivot);
    expect(at.x).toBeCloseTo(0.6);
    expect(at.y).toBeCloseTo(-0.3);
    expect(nearer.distance).toBeCloseTo(450);
    expect(zoomed(orbit, 1e-9, pivot, 1, 1e4).distance).toBe(1);
  });

  it("moves along with the pointer", () => {
    const p = panned(orbit, 30, -12, 600, lens);
    const at = project(p, lens, orbit.target);
    expect((at.x * 900) / 2).toBeCloseTo(30);
    expect((-at.y * 600) / 2).toBeCloseTo(-12);
  });

  it("frames a box: all of it in sight, and its share filled", () => {
    for (const box of [
      [0, 0, 0, 380, 284, 380],
      [0, 0, 0, 900, 20, 20],
      [5, 5, 5, 6, 6, 60],
    ] as const) {
      const to = framed(orbit, lens, [...box], 0.8);
      const places = corners([...box]).map((c) => project(to, lens, c));
      const most = Math.max(...places.map((p) => Math.max(Math.abs(p.x), Math.abs(p.y))));
      expect(most).toBeLessThan(0.86);
      expect(most).toBeGreaterThan(0.74);
      expect(to.azimuth).toBe(orbit.azimuth);
    }
  });

  it("keeps depths before the eye", () => {
    const { near, far } = depthRange(orbit, [0, 0, 0, 380, 284, 380]);
    expect(near).toBeGreaterThan(0);
    for (const c of corners([0, 0, 0, 380, 284, 380])) {
      const { depth } = project(orbit, lens, c);
      expect(depth > near && depth < far).toBe(true);
    }
    const inside = depthRange({ ...orbit, distance: 1 }, [0, 0, 0, 380, 284, 380]);
    expect(inside.near).toBeGreaterThan(0);
  });

  it("flies the short way round", () => {
    const a = { ...orbit, azimuth: 3.1 };
    const b = { ...orbit, azimuth: -3.1, distance: 100 };
    expect(Math.abs(between(a, b, 0.5).azimuth - 3.1)).toBeLessThan(0.1);
    expect(between(a, b, 0.5).distance).toBeCloseTo(300);
    expect(between(a, b, 1).distance).toBeCloseTo(100);
  });

  it("eases as the design says", () => {
    expect(ease(0)).toBe(0);
    expect(ease(1)).toBe(1);
    expect(ease(0.2)).toBeGreaterThan(0.35);
    for (let i = 1; i <= 20; ++i) expect(ease(i / 20)).toBeGreaterThan(ease((i - 1) / 20));
  });
});
