/// What is in a copy's way: copies that stand together with it, leave before it, and that its own path sweeps through.
/// This is the part by boxes; what they leave over is looked at on the meshes (view/sweep.ts).

import { type Plan, type PlanStep, plus } from "./apart_plan";
import type { Sides } from "./draft";
import type { Extent } from "./turns";

export interface Candidate {
  readonly placement: number;
  /// The step that takes it out of the way.
  readonly step: number;
}

/// Copies that stand together with what a step moves until an earlier step takes them out, and whose boxes its path
/// sweeps through.
export function candidates(plan: Plan, step: PlanStep, extents: readonly (Extent | null)[]): Candidate[] {
  const moved = new Set(step.placements);
  const boxes = step.placements.flatMap((placement) => {
    const extent = extents[placement];
    return extent ? sweptBoxes(extent, step.path) : [];
  });
  return (plan.assemblies[step.from]?.members ?? []).flatMap((placement) => {
    if (moved.has(placement)) return [];
    const leaves = leavesAssembly(plan, placement, step.from);
    const extent = extents[placement];
    if (leaves === null || leaves >= step.index || !extent) return [];
    return boxes.some((box) => overlap(box, extent)) ? [{ placement, step: leaves }] : [];
  });
}

/// The step that takes a member out of its assembly; null: it stays in it.
function leavesAssembly(plan: Plan, placement: number, assembly: number): number | null {
  return plan.stepsOf[placement]?.find((index) => plan.steps[index]?.from === assembly) ?? null;
}

/// The box round each move of a path.
export function sweptBoxes(extent: Extent, path: readonly Sides[]): Extent[] {
  let { low, high } = extent;
  return path.map((move) => {
    const nextLow = plus(low, move);
    const nextHigh = plus(high, move);
    const box = { low: each(low, nextLow, Math.min), high: each(high, nextHigh, Math.max) };
    low = nextLow;
    high = nextHigh;
    return box;
  });
}

function each(a: Sides, b: Sides, how: (x: number, y: number) => number): Sides {
  return [how(a[0], b[0]), how(a[1], b[1]), how(a[2], b[2])];
}

export function overlap(a: Extent, b: Extent): boolean {
  return [0, 1, 2].every(
    (axis) => (a.low[axis] ?? 0) < (b.high[axis] ?? 0) && (b.low[axis] ?? 0) < (a.high[axis] ?? 0),
  );
}
