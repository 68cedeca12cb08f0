/// What the files of a job hold, asked again while files are sent and read, and handed on once files are ready.

import { api } from "../../api/client";
import type { Parts } from "../../api/types";
import { messageOf } from "./app_state";
import { decodeText } from "./set_file";
import { Store } from "./store";
import { isPlan, known, type Texts } from "./take_in";

export interface SourceState {
  readonly parts: Parts;
  readonly problem: string | null;
}

const none: Parts = { reading: 0, meshes: [], bad: [], sets: [] };
const every = 600;

export class PartSource {
  readonly state = new Store<SourceState>({ parts: none, problem: null });
  /// On the server, and not in the draft yet.
  private readonly fresh = new Set<string>();
  private all = false;
  private timer = 0;
  private asking = false;
  private closed = false;

  constructor(
    private readonly job: string,
    private readonly sending: () => boolean,
    private readonly take: (parts: Parts, fresh: ReadonlySet<string>, texts: Texts) => void,
  ) {}

  add(name: string): void {
    this.fresh.add(name);
    this.soon(150);
  }

  async refresh(): Promise<Parts> {
    const parts = await api.parts(this.job);
    this.state.set({ parts, problem: null });
    return parts;
  }

  /// All that is there is to be taken in, once all of it was read: which files there are is only known then.
  addAll(): void {
    this.all = true;
    this.soon(0);
  }

  soon(after: number): void {
    if (this.closed || this.asking) return;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.ask(), after);
  }

  close(): void {
    this.closed = true;
    clearTimeout(this.timer);
  }

  private async ask(): Promise<void> {
    this.asking = true;
    // What arrives while the answer is on its way may be missing in it.
    const asked = new Set(this.fresh);
    const sending = this.sending();
    try {
      const parts = await this.refresh();
      await this.handOn(parts, asked, sending || this.sending());
    } catch (error) {
      this.state.set({ problem: messageOf(error) });
    } finally {
      this.asking = false;
      if (this.state.value.parts.reading > 0 || this.fresh.size > 0 || this.sending()) this.soon(every);
    }
  }

  /// Files that came with a plan wait for it, and it for them. `asked`: the fresh files that the answer must know.
  private async handOn(parts: Parts, asked: ReadonlySet<string>, sending: boolean): Promise<void> {
    const busy = parts.reading > 0 || sending;
    if (this.all) {
      if (busy) return;
      for (const name of known(parts)) this.fresh.add(name);
      this.all = false;
    }
    if (busy && [...this.fresh].some(isPlan)) return;
    const there = known(parts);
    const ready = new Set([...this.fresh].filter((name) => there.has(name)));
    if (ready.size > 0) {
      const texts = await this.texts(parts, ready);
      for (const name of ready) this.fresh.delete(name);
      this.take(parts, ready, texts);
    }
    // A file that neither is anywhere nor is read any more will not come.
    if (!busy) for (const name of asked) this.fresh.delete(name);
  }

  private async texts(parts: Parts, ready: ReadonlySet<string>): Promise<Texts> {
    const texts = new Map<string, string>();
    for (const set of parts.sets) {
      if (set.kind !== "set" || !ready.has(set.file)) continue;
      try {
        texts.set(set.file, decodeText(await api.fileBytes(this.job, set.file)));
      } catch {
        // The server's rows say the counts at least.
      }
    }
    return texts;
  }
}
