/// A job as it runs, and what came of it.

import { api } from "../../api/client";
import { watchJob } from "../../api/events";
import type { Job } from "../../api/types";
import { app, messageOf } from "./app_state";
import { keep, kept } from "./kept";
import { LiveRun } from "./live_run";
import { type Packing, readPacking } from "./packing";
import { Store } from "./store";

/// What a run does: it packs, makes a packing better, or checks one that was changed by hand.
export type RunKind = "pack" | "improve" | "change";

export interface RunState {
  readonly job: Job;
  /// As it is shown: with changes by hand that the server does not have yet.
  readonly packing: Packing | null;
  /// As the server has it.
  readonly stored: Packing | null;
  readonly loading: boolean;
  readonly problem: string | null;
  /// Grows as lines come; what they say is in `live`.
  readonly version: number;
  /// When this page saw the run begin, or began to watch it.
  readonly since: number;
  /// It was asked to stop; what stands is still taken apart and checked.
  readonly stopping: boolean;
}

export const isRunning = (job: Job): boolean => job.status === "running" || job.status === "queued";

interface KeptRun {
  readonly kind: RunKind;
  readonly started: string | null;
}

export class Runner {
  readonly state: Store<RunState>;
  readonly live = new LiveRun();
  /// Changes by hand, laid over a packing that came.
  overlay: (packing: Packing) => Packing = (packing) => packing;
  /// A packing came, or none did although the run ended; before it is shown.
  arrived: (packing: Packing | null) => void = () => {};
  private kind: RunKind | null = null;
  private stopWatching: (() => void) | null = null;
  private telling = 0;
  private closed = false;

  constructor(job: Job) {
    this.state = new Store<RunState>({
      job,
      packing: null,
      stored: null,
      loading: false,
      problem: null,
      version: 0,
      since: 0,
      stopping: false,
    });
  }

  get id(): string {
    return this.state.value.job.id;
  }

  begin(): void {
    const { job } = this.state.value;
    const before = kept<KeptRun | null>(`run.${this.id}`, null);
    if (isRunning(job) && before && before.started === (job.started ?? null)) this.kind = before.kind;
    this.take(job);
    // What is improved or checked can be looked at meanwhile.
    if (isRunning(job) && job.has_packing && this.kind !== "pack") void this.load();
  }

  /// What the run does. One that this browser did not begin tells it by what it does first.
  get doing(): RunKind {
    if (this.kind) return this.kind;
    const { job, stored } = this.state.value;
    const phase = this.live.progress?.phase ?? job.progress?.phase;
    if (!job.has_packing || !stored || this.live.phases.has("search")) return "pack";
    if (phase === "improve" || this.live.curve.isThere) return "improve";
    return (phase === "disassemble" || phase === "check") && this.live.standing === 0 ? "change" : "pack";
  }

  /// Changes by hand are being checked.
  get checking(): boolean {
    return isRunning(this.state.value.job) && this.doing === "change";
  }

  /// It packs, or makes a packing better: what stands changes by itself.
  get packs(): boolean {
    return isRunning(this.state.value.job) && this.doing !== "change";
  }

  /// The packing is shown anew, because the changes laid over it are others.
  show(): void {
    const { stored } = this.state.value;
    if (stored) this.state.set({ packing: this.overlay(stored) });
  }

  /// The job as the server has it now.
  take(job: Job): void {
    const before = this.state.value.job;
    this.state.set({ job });
    if (isRunning(job)) {
      if (!this.stopWatching) this.watch();
      return;
    }
    const ended = isRunning(before);
    this.state.set({ stopping: false });
    if (job.has_packing && (ended || !this.state.value.packing)) void this.load();
    else if (ended) this.arrived(null);
  }

  async refresh(): Promise<void> {
    this.take(await api.job(this.id));
  }

  /// `call` starts it on the server.
  async start(kind: RunKind, call: () => Promise<Job>): Promise<void> {
    const job = await call();
    this.unwatch();
    this.kind = kind;
    keep(`run.${this.id}`, { kind, started: job.started ?? null } satisfies KeptRun);
    this.live.clear();
    const anew = kind === "pack" ? { packing: null, stored: null } : {};
    this.state.set({ ...anew, version: this.live.version, stopping: false });
    this.take(job);
    // It was so quick that it is over already.
    if (!isRunning(job) && job.has_packing) await this.load();
  }

  async cancel(): Promise<void> {
    this.state.set({ stopping: true });
    try {
      const job = await api.cancel(this.id);
      // It may have ended before the answer came.
      if (isRunning(this.state.value.job)) this.take(job);
    } catch (error) {
      this.state.set({ stopping: false });
      throw error;
    }
  }

  close(): void {
    this.closed = true;
    this.unwatch();
  }

  private watch(): void {
    this.live.clear();
    this.state.set({ since: Date.now() });
    this.stopWatching = watchJob(this.id, {
      state: (job) => {
        this.take(job);
        if (!isRunning(job)) this.unwatch();
      },
      line: (line) => {
        this.live.apply(line);
        this.tellSoon();
      },
      anew: () => {
        this.live.clear();
        this.tellSoon();
      },
      connected: (there) => app.set({ connected: there }),
    });
  }

  private unwatch(): void {
    this.stopWatching?.();
    this.stopWatching = null;
  }

  /// Once a frame, however many lines come; a page in the background keeps up more slowly.
  private tellSoon(): void {
    if (this.telling) return;
    const tell = () => {
      this.telling = 0;
      this.state.set({ version: this.live.version });
    };
    this.telling = document.hidden ? window.setTimeout(tell, 500) : requestAnimationFrame(tell);
  }

  private async load(): Promise<void> {
    this.state.set({ loading: true, problem: null });
    try {
      const stored = readPacking(await api.packing(this.id));
      if (this.closed) return;
      if (!isRunning(this.state.value.job)) this.arrived(stored);
      this.state.set({ stored, packing: this.overlay(stored), loading: false });
    } catch (error) {
      this.state.set({ loading: false, problem: messageOf(error) });
    }
  }
}
