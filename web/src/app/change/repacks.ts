/// Packings as steps that can be undone: what was before one, what came of it, and the way back, which is the server's.

import { api } from "../../api/client";
import { attempt } from "../state/app_state";
import { keep, kept } from "../state/kept";
import type { Packing } from "../state/packing";
import type { Session } from "../state/session";
import type { BuildHistory, Entry, Locks, Revision } from "./build_history";
import { followed } from "./locks";

/// What a run does with the copies that stand: packs them anew, keeps some of them where they are, or makes all of it better.
export type Packs = "anew" | "keeps" | "improves";

export interface LockBox {
  locks(): Locks;
  setLocks(locks: Locks): void;
}

export class Repacks {
  /// What a packing that runs will have changed.
  private running: { readonly entry: Entry; readonly before: Packing; readonly how: Packs } | null = null;
  /// What the server goes back to.
  private goal: Revision | null = null;

  constructor(
    private readonly session: Session,
    private readonly history: BuildHistory,
    private readonly box: LockBox,
  ) {}

  /// Before the build is packed again or made better.
  begins(how: Packs): void {
    const { job } = this.session;
    const before = this.session.run.state.value.stored;
    this.running = null;
    if (!before || (job.revision ?? null) === null) return;
    this.running = { entry: { kind: "pack", before: this.revisionNow(job.revision ?? 0), after: null }, before, how };
  }

  /// It was started: or else nothing happened.
  started(done: boolean, how: Packs): void {
    if (!done) this.running = null;
    else if (this.running) this.history.push(this.running.entry);
    else this.history.restore({ past: [], future: [] });
    if (done && how === "anew") this.box.setLocks(new Set());
  }

  /// The server goes back; `failed` is called where it does not.
  async revert(to: Revision, failed: () => void): Promise<void> {
    const { session } = this;
    this.goal = to;
    const done = await attempt(async () => {
      await session.run.start("change", () => api.revert(session.id, to.number));
      return true;
    });
    if (done) return;
    this.goal = null;
    failed();
  }

  /// A packing came, or none although the run ended.
  arrived(packing: Packing | null): void {
    if (this.running) this.settle(packing);
    if (!this.goal) return;
    if (this.goal.packed !== null) keep(`packed.${this.session.id}`, this.goal.packed);
    this.box.setLocks(this.goal.locks);
    this.goal = null;
  }

  private settle(packing: Packing | null): void {
    const { job } = this.session;
    const own = this.running;
    this.running = null;
    if (own?.entry.kind !== "pack") return;
    const { before } = own.entry;
    if (!packing || job.revision === before.number || job.revision === null) {
      this.history.replace(own.entry, null);
      this.box.setLocks(before.locks);
      return;
    }
    if (own.how === "keeps") this.box.setLocks(followed(before.locks, own.before, packing));
    this.history.replace(own.entry, { ...own.entry, after: this.revisionNow(job.revision) });
  }

  private revisionNow(number: number): Revision {
    return { number, locks: this.box.locks(), packed: kept(`packed.${this.session.id}`, null) };
  }
}
