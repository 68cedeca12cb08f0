/// What is in a copy's way, looked at on the meshes that the page has. It takes a while for parts of many faces, so the
/// page goes on meanwhile; what was found for a step is kept.

import type { MeshData } from "../../view/view";
import { type Candidate, candidates } from "./apart_blockers";
import type { Plan, PlanStep } from "./apart_plan";
import type { Placement } from "./packing";
import { Store } from "./store";
import type { Extent } from "./turns";

/// ms of work before the page gets a turn.
const stretch = 10;

export interface Ground {
  readonly plan: Plan;
  readonly placements: readonly Placement[];
  readonly extents: readonly (Extent | null)[];
  readonly meshOf: (part: number) => MeshData | null;
}

export interface Asked {
  /// The step that is asked about; null: none.
  readonly step: number | null;
  /// All that has to leave before it, in the order in which it leaves; null: it is still looked for.
  readonly found: readonly Candidate[] | null;
}

export class Ways {
  readonly state = new Store<Asked>({ step: null, found: null });
  private readonly found = new Map<number, Promise<readonly Candidate[]>>();

  constructor(private readonly ground: Ground) {}

  /// What is in the way of this step is wanted from now on.
  ask(step: PlanStep | null): void {
    const index = step?.index ?? null;
    if (index === this.state.value.step) return;
    this.state.set({ step: index, found: null });
    if (!step) return;
    void this.before(step).then((found) => {
      if (this.state.value.step === index) this.state.set({ found });
    });
  }

  before(step: PlanStep): Promise<readonly Candidate[]> {
    let wish = this.found.get(step.index);
    if (!wish) {
      wish = this.look(step);
      this.found.set(step.index, wish);
    }
    return wish;
  }

  private async look(step: PlanStep): Promise<readonly Candidate[]> {
    const { plan, placements, extents } = this.ground;
    const near = candidates(plan, step, extents).sort((a, b) => a.step - b.step);
    if (near.length === 0) return near;
    const { Sweep } = await import("../../view/sweep");
    const bodyOf = (index: number) => {
      const placement = placements[index];
      const mesh = placement ? this.ground.meshOf(placement.part) : null;
      return placement && mesh ? { mesh, transform: placement.transform } : null;
    };
    const sweeps = step.placements.flatMap((index) => {
      const body = bodyOf(index);
      return body ? [new Sweep(body, step.path)] : [];
    });
    const met: Candidate[] = [];
    let until = performance.now() + stretch;
    for (const candidate of near) {
      const body = bodyOf(candidate.placement);
      if (body && sweeps.some((sweep) => sweep.meets(body))) met.push(candidate);
      if (performance.now() < until) continue;
      await new Promise((resolve) => setTimeout(resolve));
      until = performance.now() + stretch;
    }
    return met;
  }
}
