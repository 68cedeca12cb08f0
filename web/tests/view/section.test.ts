import { describe, expect, it } from "vitest";
import { meshFacts, surfacePoints } from "../../src/view/mesh_facts";
import {
  alongLine,
  boxSide,
  crossed,
  cutAway,
  facesCut,
  handleCorner,
  hatchStep,
  isKept,
  kept,
  outline,
  planeOf,
} from "../../src/view/section";
import type { Section } from "../../src/view/view";
import { boxMesh } from "./meshes";

const z50: Section = { axis: "z", at: 50, flipped: false };

describe("a section", () => {
  it("keeps what lies below it, and flipped what lies above", () => {
    expect(isKept(planeOf(z50), [0, 0, 49])).toBe(true);
    expect(isKept(planeOf(z50), [0, 0, 51])).toBe(false);
    expect(isKept(planeOf({ ...z50, flipped: true }), [0, 0, 51])).toBe(true);
    expect(isKept(planeOf({ axis: "x", at: -3, flipped: false }), [-4, 9, 9])).toBe(true);
  });

  it("sorts boxes", () => {
    const boxes = [0, 0, 0, 9, 9, 50, 0, 0, 49, 9, 9, 51, 0, 0, 50, 9, 9, 60];
    expect([0, 6, 12].map((at) => boxSide(z50, boxes, at))).toEqual([kept, crossed, cutAway]);
    expect([0, 6, 12].map((at) => boxSide({ ...z50, flipped: true }, boxes, at))).toEqual([cutAway, crossed, kept]);
    // Rounding does not decide what stands on the plane or hangs under it.
    const near = [0, 0, 0, 9, 9, 50.001, 0, 0, 49.999, 9, 9, 60];
    expect([0, 6].map((at) => boxSide(z50, near, at))).toEqual([kept, cutAway]);
  });

  it("shows its cuts to those who look from the side cut away", () => {
    expect(facesCut(z50, [0, 0, 500])).toBe(true);
    expect(facesCut(z50, [0, 0, -500])).toBe(false);
    expect(facesCut({ ...z50, flipped: true }, [0, 0, -500])).toBe(true);
  });

  it("has an outline round the tray, with the handle at the viewer's corner", () => {
    const tray = [0, 0, 0, 100, 200, 300] as const;
    for (const axis of ["x", "y", "z"] as const) {
      const points = outline({ axis, at: 40, flipped: false }, [...tray]);
      const around = points.reduce((sum, p, i) => {
        const q = points[(i + 1) % 4] ?? p;
        return sum + Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
      }, 0);
      const sides = { x: [200, 300], y: [100, 300], z: [100, 200] }[axis];
      expect(around).toBeCloseTo(2 * ((sides[0] ?? 0) + (sides[1] ?? 0)));
    }
    expect(handleCorner(z50, [...tray], [500, -500, 400])).toEqual([100, 0, 50]);
    expect(outline({ ...z50, at: 900 }, [...tray])[0][2]).toBe(300);
  });

  it("is dragged to where the pointer's ray comes nearest", () => {
    expect(alongLine([100, 0, 0], [0, 0, 1], [100, -500, 70], [0, 1, 0])).toBeCloseTo(70);
    // Past the line at a distance, and with a ray that is not level.
    expect(alongLine([100, 0, 10], [0, 0, 1], [130, -500, 570], [0, Math.SQRT1_2, -Math.SQRT1_2])).toBeCloseTo(60);
    expect(alongLine([0, 0, 0], [0, 0, 1], [1, 0, 9], [0, 0, -1])).toBeNull();
  });

  it("has hatch lines that keep their place while zooming", () => {
    for (const mm of [0.01, 0.3, 1, 12.5]) {
      const step = hatchStep(mm, 7);
      expect(step / mm).toBeGreaterThan(7 / Math.SQRT2 - 1e-6);
      expect(step / mm).toBeLessThan(7 * Math.SQRT2 + 1e-6);
      expect(Number.isInteger(Math.log2(step))).toBe(true);
    }
  });
});

describe("which meshes can be cut", () => {
  it("knows closed ones, wherever they stand", () => {
    const facts = meshFacts(boxMesh(10, 20, 30, [5000, -4000, 3000]));
    expect(facts.openness).toBeLessThan(1e-6);
    expect(facts.insideOut).toBe(false);
    expect(facts.area).toBeCloseTo(2200, 1);
    expect(facts.box).toEqual([5000, -4000, 3000, 5010, -3980, 3030]);
  });

  it("knows ones turned inside out", () => {
    const mesh = boxMesh(1, 1, 1);
    expect(meshFacts({ ...mesh, indices: mesh.indices.slice().reverse() }).insideOut).toBe(true);
  });

  it("takes two shells that run into each other for closed", () => {
    const a = boxMesh(10, 10, 10);
    const b = boxMesh(10, 10, 10, [5, 5, 5]);
    const both = {
      id: 0,
      positions: Float32Array.from([...a.positions, ...b.positions]),
      indices: Uint32Array.from([...a.indices, ...b.indices.map((i) => i + 8)]),
    };
    expect(meshFacts(both).openness).toBeLessThan(1e-6);
  });

  it("measures how much is missing", () => {
    const mesh = boxMesh(1, 1, 1);
    expect(meshFacts({ ...mesh, indices: mesh.indices.slice(6) }).openness).toBeGreaterThan(0.15);
    expect(meshFacts({ id: 0, positions: new Float32Array(0), indices: new Uint32Array(0) }).openness).toBe(0);
  });

  it("spreads points over the surface by area", () => {
    const mesh = boxMesh(10, 10, 0.001);
    const points = surfacePoints(mesh, meshFacts(mesh).area, 400);
    const count = points.length / 3;
    expect(Math.abs(count - 400)).toBeLessThan(3);
    let left = 0;
    for (let i = 0; i < points.length; i += 3) if ((points[i] as number) < 5) left += 1;
    expect(left / count).toBeCloseTo(0.5, 1);
  });
});
