/// What is done to a build by hand: copies are removed, moved, put back and locked, the rest is packed again, and all of it
/// can be undone. Components watch `state`; the packing with its changes is the run's (runner.ts).

import { api } from "../../api/client";
import type { CopyKey } from "../../view/view";
import { packedParts } from "../build/build_parts";
import { announce, tell } from "../state/app_state";
import type { Packing } from "../state/packing";
import { isRunning } from "../state/runner";
import type { Session } from "../state/session";
import { Store } from "../state/store";
import { toast } from "../state/toasts";
import { namedCopies } from "../words/named";
import { BuildHistory, type Entry, type Lists, type Locks, type Revision } from "./build_history";
import { applyChanges, type CopyChange, inverseOf, placementOf, type TrayCopy, trayCopyId } from "./change";
import { keepLocks, keptLocks, standing, withLocks } from "./locks";
import { Mover } from "./mover";
import { keepPlaces, placeOf } from "./places";
import { ChangeQueue } from "./queue";
import { type Packs, Repacks } from "./repacks";

export interface WorkState {
  readonly locks: Locks;
  /// Grows with every step that can be undone.
  readonly version: number;
  /// Changes are on their way that the server has not taken yet.
  readonly waits: boolean;
}

export class BuildWork {
  readonly state: Store<WorkState>;
  readonly move: Mover;
  private readonly queue: ChangeQueue;
  private readonly history = new BuildHistory();
  /// The history as it was when the server last took changes, and when some were sent: a refusal goes back there.
  private taken: Lists = this.history.now;
  private sending: Lists = this.history.now;
  private readonly repacks: Repacks;
  private wasRunning = false;

  constructor(private readonly session: Session) {
    this.state = new Store<WorkState>({ locks: keptLocks(session.id), version: 0, waits: false });
    this.queue = new ChangeQueue({
      free: () =>
        !isRunning(session.job) && session.run.state.value.stored !== null && !session.run.state.value.loading,
      send: (changes) => session.run.start("change", () => api.change(session.id, changes)),
      changed: () => {
        this.state.set({ waits: this.queue.unsent.length > 0 });
        session.run.show();
      },
      sending: () => {
        this.sending = this.history.now;
      },
      taken: () => {
        this.taken = this.sending;
      },
      refused: (sentence) => this.refused(sentence),
    });
    this.repacks = new Repacks(session, this.history, {
      locks: () => this.state.value.locks,
      setLocks: (locks) => this.setLocks(locks),
    });
    this.move = new Mover(
      session,
      () => this.queue.unsent,
      (copy, transform) => this.change([{ ...copy, transform }]),
    );
    session.run.overlay = (packing) => applyChanges(packing, this.queue.pending);
    session.run.arrived = (packing) => this.arrived(packing);
    session.run.state.subscribe(() => this.followRun());
  }

  close(): void {
    this.queue.stop();
    this.move.end();
  }

  private get shown(): Packing | null {
    return this.session.run.state.value.packing;
  }

  /// What is shown has not been checked: it is changed, or is about to be.
  get unchecked(): boolean {
    return this.state.value.waits || this.move.moved || this.session.run.checking;
  }

  // Changes by hand ------------------------------------------------------------------------------------------------

  remove(copies: readonly TrayCopy[]): void {
    const { shown } = this;
    const free = copies.filter((copy) => !this.isLocked(copy) && placementOf(shown, copy));
    if (!shown || free.length === 0) {
      if (copies.length > 0) announce("Locked copies stay. Unlock them first.");
      return;
    }
    keepPlaces(this.session.id, shown, free);
    this.change(free.map((copy) => ({ ...copy, transform: null })));
    const gone = new Set(free.map(trayCopyId));
    const { build } = this.session;
    const tray = Math.max(1, build.value.tray);
    build.set({ selected: build.value.selected.filter((copy) => !gone.has(trayCopyId({ tray, ...copy }))) });
    const [first] = free;
    const name = first && free.length === 1 ? this.move.nameOf(first) : `${free.length} copies`;
    const entry = this.history.last;
    toast(`${name} ${free.length === 1 ? "is" : "are"} taken out.`, () => {
      if (this.history.last === entry) void this.undo();
    });
  }

  /// Back where they stood when this browser took them out. One whose place is not known is placed by hand.
  putBack(copies: readonly CopyKey[]): void {
    const back = copies.map((copy) => this.placeOf(copy));
    if (back.every((own) => own?.known)) this.change(back.flatMap((own) => (own ? [own.change] : [])));
    else if (copies[0]) this.placeByHand(copies[0]);
  }

  placeByHand(copy: CopyKey): void {
    const change = this.placeOf(copy)?.change;
    if (!change?.transform) return;
    const { build } = this.session;
    if (build.value.tray !== change.tray) build.set({ tray: change.tray, follow: false });
    this.move.begin(change, change.transform);
  }

  private placeOf(copy: CopyKey) {
    const { shown, session } = this;
    if (!shown) return null;
    const mesh = packedParts(session, shown).find((part) => part.index === copy.part)?.mesh ?? null;
    return placeOf(session.id, shown, copy, mesh);
  }

  private change(changes: readonly CopyChange[]): void {
    const { shown } = this;
    if (!shown || changes.length === 0) return;
    const before = this.state.value.locks;
    const out = changes.filter((change) => change.transform === null);
    const after = withLocks(before, out, false);
    this.history.push({ kind: "changes", does: changes, undoes: inverseOf(shown, changes), before, after });
    this.setLocks(after);
    this.queue.add(changes);
  }

  /// The server does not take them, and says why: back to what it has.
  private refused(sentence: string): void {
    this.move.end();
    this.history.restore(this.taken);
    this.count();
    tell(namedCopies(sentence, this.session.run.state.value.stored));
  }

  // Locks ----------------------------------------------------------------------------------------------------------

  isLocked(copy: TrayCopy): boolean {
    return this.state.value.locks.has(trayCopyId(copy));
  }

  lock(copies: readonly TrayCopy[], on: boolean): void {
    const before = this.state.value.locks;
    const after = withLocks(before, copies, on);
    if (after === before) return;
    this.history.push({ kind: "locks", before, after });
    this.setLocks(after);
  }

  /// Locks all of them, or unlocks them where all are.
  toggleLock(copies: readonly TrayCopy[]): void {
    if (copies.length > 0) this.lock(copies, !copies.every((copy) => this.isLocked(copy)));
  }

  private setLocks(locks: Locks): void {
    keepLocks(this.session.id, locks);
    this.state.set({ locks });
    this.count();
  }

  // Undo and redo --------------------------------------------------------------------------------------------------

  get canUndo(): boolean {
    return this.can(this.history.last, "before");
  }

  get canRedo(): boolean {
    return this.can(this.history.next, "after");
  }

  private can(entry: Entry | null, side: "before" | "after"): boolean {
    if (!entry || this.session.run.packs || this.move.active) return false;
    if (entry.kind !== "pack") return true;
    const number = entry[side]?.number;
    return !this.unchecked && number !== undefined && (this.session.job.revisions ?? []).includes(number);
  }

  async undo(): Promise<void> {
    if (!this.canUndo) return;
    const entry = this.history.undo();
    if (entry?.kind === "changes") this.again(entry.undoes, entry.before);
    else if (entry?.kind === "locks") this.setLocks(entry.before);
    else if (entry) await this.revert(entry.before, () => this.history.redo());
  }

  async redo(): Promise<void> {
    if (!this.canRedo) return;
    const entry = this.history.redo();
    if (entry?.kind === "changes") this.again(entry.does, entry.after);
    else if (entry?.kind === "locks") this.setLocks(entry.after);
    else if (entry?.after) await this.revert(entry.after, () => this.history.undo());
  }

  private async revert(to: Revision, back: () => void): Promise<void> {
    await this.repacks.revert(to, back);
    this.count();
  }

  private again(changes: readonly CopyChange[], locks: Locks): void {
    this.setLocks(locks);
    this.queue.add(changes);
  }

  private count(): void {
    this.state.set({ version: this.state.value.version + 1 });
  }

  // Packing --------------------------------------------------------------------------------------------------------

  /// Before the build is packed again or made better, and once that was started: one step that can be undone.
  packs(how: Packs): void {
    this.move.end();
    this.repacks.begins(how);
  }

  started(done: boolean, how: Packs): void {
    this.repacks.started(done, how);
    this.count();
  }

  private arrived(packing: Packing | null): void {
    const { job } = this.session;
    // A check that could not be done leaves the packing as it was.
    if (job.status === "failed" && this.queue.pending.length > 0) {
      this.queue.drop();
      this.refused(job.error ?? "The change could not be checked.");
    }
    this.queue.loaded();
    this.repacks.arrived(packing);
    if (packing) {
      const locks = standing(this.state.value.locks, applyChanges(packing, this.queue.pending));
      if (locks !== this.state.value.locks) this.setLocks(locks);
    }
    this.taken = this.history.now;
    this.count();
    // After the packing is shown: what waits is sent.
    queueMicrotask(() => void this.queue.next());
  }

  /// Somebody else packs it: what was done by hand is not of that packing.
  private followRun(): void {
    const { run } = this.session;
    const running = run.packs;
    if (running && !this.wasRunning) this.move.end();
    this.wasRunning = running;
    if (!isRunning(run.state.value.job)) void this.queue.next();
  }
}
