/// Keeps the job file on the server as the draft is, and asks for an estimate of it; both a moment after the last change.

import { api } from "../../api/client";
import type { Estimate } from "../../api/types";
import { messageOf } from "./app_state";
import { type Draft, emptyDraft } from "./draft";
import { toJobFile } from "./job_file_write";
import { Store } from "./store";

export interface SaverState {
  readonly saving: boolean;
  /// Why the server did not take the job file.
  readonly problem: string | null;
  readonly estimate: Estimate | null;
  readonly estimating: boolean;
  /// Why there is no estimate.
  readonly doubt: string | null;
}

const saveAfter = 500;
const estimateAfter = 700;

export class Saver {
  readonly state = new Store<SaverState>({
    saving: false,
    problem: null,
    estimate: null,
    estimating: false,
    doubt: null,
  });
  private saved = "";
  /// The estimate is not of what is saved.
  private stale = true;
  private draft: Draft | null = null;
  private saveTimer = 0;
  private estimateTimer = 0;
  private asking: AbortController | null = null;
  private running: Promise<boolean> = Promise.resolve(true);

  constructor(
    private readonly job: string,
    /// Whether a file is on the server.
    private readonly there: (file: string) => boolean,
  ) {}

  /// The draft as the server has it.
  begin(draft: Draft, onServer: boolean): void {
    this.draft = draft;
    this.saved = onServer ? this.textOf(draft) : "";
    this.state.set({ problem: null, doubt: null });
  }

  /// Somebody looks at the estimate.
  look(): void {
    if (this.stale && this.textOf(this.draft ?? emptyDraft) === this.saved) this.askSoon();
  }

  change(draft: Draft): void {
    this.draft = draft;
    clearTimeout(this.saveTimer);
    if (this.textOf(draft) === this.saved) {
      if (this.stale) this.askSoon();
      return;
    }
    this.stale = true;
    this.asking?.abort();
    this.saveTimer = window.setTimeout(() => void this.flush(), saveAfter);
  }

  private textOf(draft: Draft): string {
    return JSON.stringify(toJobFile(draft, this.there));
  }

  /// Saves what is not saved yet. False where the server does not take it; `state.problem` says why then.
  flush(): Promise<boolean> {
    clearTimeout(this.saveTimer);
    this.running = this.running.then(() => this.save());
    return this.running;
  }

  close(): void {
    clearTimeout(this.estimateTimer);
    this.asking?.abort();
    void this.flush();
  }

  private async save(): Promise<boolean> {
    if (!this.draft) return true;
    const file = toJobFile(this.draft, this.there);
    const text = this.textOf(this.draft);
    if (text === this.saved) {
      this.state.set({ problem: null });
      return true;
    }
    this.state.set({ saving: true });
    try {
      await api.putJobFile(this.job, file);
      this.saved = text;
      this.stale = true;
      this.state.set({ saving: false, problem: null });
      this.askSoon();
      return true;
    } catch (error) {
      this.state.set({ saving: false, problem: messageOf(error), estimate: null, estimating: false });
      return false;
    }
  }

  private askSoon(): void {
    clearTimeout(this.estimateTimer);
    this.asking?.abort();
    if (!this.draft || this.draft.parts.length === 0) {
      this.state.set({ estimate: null, estimating: false, doubt: null });
      return;
    }
    this.state.set({ estimating: true });
    this.estimateTimer = window.setTimeout(() => void this.ask(), estimateAfter);
  }

  private async ask(): Promise<void> {
    const asking = new AbortController();
    this.asking = asking;
    try {
      const estimate = await api.estimate(this.job, asking.signal);
      if (asking.signal.aborted) return;
      this.stale = false;
      this.state.set({ estimate, estimating: false, doubt: null });
    } catch (error) {
      if (asking.signal.aborted) return;
      this.stale = false;
      this.state.set({ estimate: null, estimating: false, doubt: messageOf(error) });
    }
  }
}
