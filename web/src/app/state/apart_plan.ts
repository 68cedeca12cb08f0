/// How a tray comes apart (docs/format.md, "Disassembly plans"). Copies that stand together are an assembly; at first that
/// is the whole tray. A step of one copy takes it out for good. A step of several makes them an assembly of their own,
/// which later steps part outside, with paths from where the copies stand in the packing.

import type { Sides } from "./draft";
import type { PackedTray } from "./packing";

export interface Assembly {
  /// 0 is the tray itself.
  readonly number: number;
  readonly members: readonly number[];
  /// The step that made it; -1: it stood together from the start.
  readonly madeBy: number;
  /// How far it stands from its place in the packing once it is made.
  readonly offset: Sides;
}

export interface PlanStep {
  /// From 0 on; people are told one more.
  readonly index: number;
  readonly placements: readonly number[];
  readonly path: readonly Sides[];
  /// mm, along all moves.
  readonly length: number;
  /// The assembly that it is taken out of.
  readonly from: number;
  /// The assembly that it makes; null where it takes out one copy.
  readonly makes: number | null;
  readonly throughWalls: boolean;
}

export interface Plan {
  readonly steps: readonly PlanStep[];
  readonly assemblies: readonly Assembly[];
  /// By placement: the step that takes it out for good; Infinity: none does.
  readonly outAt: readonly number[];
  /// By placement: all its steps, in order.
  readonly stepsOf: readonly (readonly number[])[];
  /// Placements without a step of their own: fixed ones, and those of an incomplete plan.
  readonly staying: readonly number[];
}

export function planOf(tray: Pick<PackedTray, "plan" | "placements">): Plan {
  const all = tray.placements.map((_, index) => index);
  const assemblies: Assembly[] = [{ number: 0, members: all, madeBy: -1, offset: [0, 0, 0] }];
  const stands = all.map(() => 0);
  const outAt = all.map(() => Number.POSITIVE_INFINITY);
  const stepsOf: number[][] = all.map(() => []);
  const steps = tray.plan.map((raw, index): PlanStep => {
    const { placements, path, throughWalls } = raw;
    const from = stands[placements[0] ?? 0] ?? 0;
    const length = path.reduce((sum, move) => sum + lengthOf(move), 0);
    let makes: number | null = null;
    if (placements.length > 1) {
      makes = assemblies.length;
      const offset = path.reduce<Sides>(plus, assemblies[from]?.offset ?? [0, 0, 0]);
      assemblies.push({ number: makes, members: placements, madeBy: index, offset });
    }
    for (const placement of placements) {
      stepsOf[placement]?.push(index);
      if (makes === null) outAt[placement] = index;
      else stands[placement] = makes;
    }
    return { index, placements, path, length, from, makes, throughWalls };
  });
  const staying = all.filter((placement) => outAt[placement] === Number.POSITIVE_INFINITY);
  return { steps, assemblies, outAt, stepsOf, staying };
}

/// The step at which a placement next moves, at a time or later; null where it does not any more.
export function nextStep(plan: Plan, placement: number, time: number): PlanStep | null {
  const index = plan.stepsOf[placement]?.find((own) => own + 1 > time);
  return index === undefined ? null : (plan.steps[index] ?? null);
}

/// The steps that part an assembly outside, those of the assemblies in it among them.
export function partingSteps(plan: Plan, assembly: number): PlanStep[] {
  const own = plan.assemblies[assembly];
  if (!own) return [];
  const members = new Set(own.members);
  return plan.steps.filter((step) => step.index > own.madeBy && step.placements.some((one) => members.has(one)));
}

/// So many copies are left once a step is done.
export function leftAfter(plan: Plan, step: number): number {
  return plan.outAt.reduce((sum, out) => sum + (out > step ? 1 : 0), 0);
}

export const lengthOf = (move: Sides): number => Math.hypot(move[0], move[1], move[2]);

export const plus = (a: Sides, b: Sides): Sides => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
