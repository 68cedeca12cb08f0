/// Where copies stand while a tray comes apart. Time is counted in steps: 4.5 is half way through the fifth.

import { lengthOf, type Plan, type PlanStep, plus } from "./apart_plan";
import type { Sides } from "./draft";

/// A short move among long ones still takes this share of the step, so that it is seen.
const leastShare = 0.12;

export type Place =
  | { readonly kind: "stands"; readonly offset: Sides }
  | { readonly kind: "moves"; readonly offset: Sides }
  | { readonly kind: "out" };

/// How far a copy is from its place in the packing.
export function placeAt(plan: Plan, placement: number, time: number): Place {
  const now = Math.floor(time);
  if ((plan.outAt[placement] ?? 0) < now) return { kind: "out" };
  let offset: Sides = [0, 0, 0];
  for (const index of plan.stepsOf[placement] ?? []) {
    const step = plan.steps[index];
    if (!step || index > now) break;
    if (index === now) return { kind: "moves", offset: plus(startOf(plan, step), alongPath(step, time - now)) };
    if (step.makes !== null) offset = plan.assemblies[step.makes]?.offset ?? offset;
  }
  return { kind: "stands", offset };
}

/// Where what a step moves stands before it, from its place in the packing.
export function startOf(plan: Plan, step: PlanStep): Sides {
  return plan.assemblies[step.from]?.offset ?? [0, 0, 0];
}

/// How far it has gone along the path of its step, move after move.
export function alongPath(step: PlanStep, share: number): Sides {
  return travel(step, share).offset;
}

/// mm that it has gone.
export function distanceAt(step: PlanStep, share: number): number {
  return travel(step, share).distance;
}

function travel(step: PlanStep, share: number): { offset: Sides; distance: number } {
  const lengths = step.path.map(lengthOf);
  const total = lengths.reduce((sum, length) => sum + length, 0);
  const weights = lengths.map((length) => Math.max(length, leastShare * total));
  let left = weights.reduce((sum, weight) => sum + weight, 0) * Math.min(1, Math.max(0, share));
  let offset: Sides = [0, 0, 0];
  let distance = 0;
  step.path.forEach((move, i) => {
    const weight = weights[i] ?? 0;
    const part = weight > 0 ? Math.min(1, Math.max(0, left / weight)) : 1;
    left -= weight;
    offset = plus(offset, [move[0] * part, move[1] * part, move[2] * part]);
    distance += (lengths[i] ?? 0) * part;
  });
  return { offset, distance };
}

/// The corners of a step's path, from where it starts.
export function pathPoints(plan: Plan, step: PlanStep, centre: Sides): Sides[] {
  const points = [plus(centre, startOf(plan, step))];
  for (const move of step.path) points.push(plus(points[points.length - 1] ?? centre, move));
  return points;
}
