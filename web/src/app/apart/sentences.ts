/// What a step does, in one sentence, and how what it moves goes.

import type { PlanStep } from "../state/apart_plan";
import { leftAfter } from "../state/apart_plan";
import { pathWords } from "../words/moves";
import { copies, count } from "../words/numbers";
import type { Apart } from "./apart";

export function stepName(apart: Apart, step: PlanStep): string {
  return step.makes === null ? apart.nameOf(step.placements[0] ?? -1) : `Group of ${step.placements.length}`;
}

export function moveWords(step: PlanStep): string {
  return pathWords(step.path) ?? "nothing is left around it";
}

/// `step` from 0 on; their number: all are done.
export function stepSentence(apart: Apart, step: number): string {
  const { plan } = apart;
  const own = plan.steps[step];
  if (!own) return endSentence(apart);
  const left = leftAfter(plan, step - 1);
  const what = `${stepName(apart, own)}, ${moveWords(own)}`;
  return `Step ${count(step + 1)} of ${count(plan.steps.length)}: ${what}. ${copies(left)} ${left === 1 ? "is" : "are"} left.`;
}

export function endSentence({ plan }: Apart): string {
  const { length } = plan.staying;
  if (length === 0) return "All copies are out.";
  return `All steps are done. ${copies(length)} ${length === 1 ? "stays" : "stay"} in the tray.`;
}
