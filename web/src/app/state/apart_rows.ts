/// The rows of the list of steps: one a step, groups with what parts them, and at the end what stays.

import { type Plan, partingSteps } from "./apart_plan";

export type Row =
  | { readonly kind: "step"; readonly step: number; readonly depth: number; readonly last: boolean }
  | { readonly kind: "group"; readonly step: number; readonly depth: number }
  /// A copy of a group that leaves it later in the plan, or never.
  | { readonly kind: "member"; readonly placement: number; readonly depth: number; readonly last: boolean }
  | { readonly kind: "caption"; readonly count: number }
  | { readonly kind: "stays"; readonly placement: number };

/// `depth`: how many groups a row lies in; `last`: its outermost group ends with it.
export function rowsOf(plan: Plan): Row[] {
  const rows: Row[] = [];
  for (let at = 0; at < plan.steps.length; ) at = addStep(plan, at, 0, rows);
  if (plan.staying.length > 0) {
    rows.push({ kind: "caption", count: plan.staying.length });
    rows.push(...plan.staying.map((placement): Row => ({ kind: "stays", placement })));
  }
  return rows;
}

/// Adds a step, and where it makes a group the steps that part it right afterwards. Says which step comes next.
function addStep(plan: Plan, at: number, depth: number, rows: Row[]): number {
  const step = plan.steps[at];
  if (!step) return at + 1;
  if (step.makes === null) {
    rows.push({ kind: "step", step: at, depth, last: false });
    return at + 1;
  }
  rows.push({ kind: "group", step: at, depth });
  const follow = followers(plan, step.makes);
  const parted = new Set(follow.flatMap((index) => plan.steps[index]?.placements ?? []));
  let next = at + 1;
  while (next <= at + follow.length) next = addStep(plan, next, depth + 1, rows);
  for (const placement of step.placements) {
    if (!parted.has(placement)) rows.push({ kind: "member", placement, depth: depth + 1, last: false });
  }
  const end = rows[rows.length - 1];
  if (depth === 0 && end && (end.kind === "step" || end.kind === "member"))
    rows[rows.length - 1] = { ...end, last: true };
  return next;
}

/// Its parting steps as long as they follow it without another between them.
function followers(plan: Plan, assembly: number): number[] {
  const made = plan.assemblies[assembly]?.madeBy ?? -1;
  return partingSteps(plan, assembly)
    .map((step) => step.index)
    .filter((index, i) => index === made + 1 + i);
}

/// Where a step stands in the list.
export function rowOfStep(rows: readonly Row[]): number[] {
  const places: number[] = [];
  rows.forEach((row, place) => {
    if (row.kind === "step" || row.kind === "group") places[row.step] = place;
  });
  return places;
}

/// The spans of the timeline's brackets: from the step that makes a group to the last that parts it.
export function groupSpans(plan: Plan): { readonly first: number; readonly last: number }[] {
  return plan.assemblies
    .filter((own) => own.madeBy >= 0)
    .map((own) => ({ first: own.madeBy, last: own.madeBy + followers(plan, own.number).length }));
}
