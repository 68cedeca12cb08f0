/// Changes on their way to the server: shown at once, sent together as soon as it is free, and gone once its packing has
/// them. One that is refused takes all that wait with it: they may build on it.

import { ApiError } from "../../api/client";
import { type CopyChange, merged } from "./change";

export interface QueueHost {
  /// The server can take changes now.
  free(): boolean;
  send(changes: readonly CopyChange[]): Promise<void>;
  /// What is on its way is another than before.
  changed(): void;
  /// These are about to be sent, were taken, or were refused with this sentence.
  sending(): void;
  taken(): void;
  refused(sentence: string): void;
}

/// ms until a server that was busy or away is asked again.
const again = 1500;
const busyStatus: ReadonlySet<number> = new Set([0, 409, 429, 503]);

export class ChangeQueue {
  private waiting: readonly CopyChange[] = [];
  private sent: readonly CopyChange[] = [];
  private checking: readonly CopyChange[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly host: QueueHost) {}

  /// All that the server's packing does not have yet.
  get pending(): readonly CopyChange[] {
    return merged(merged(this.checking, this.sent), this.waiting);
  }

  /// Those that the server does not know of.
  get unsent(): readonly CopyChange[] {
    return merged(this.sent, this.waiting);
  }

  add(changes: readonly CopyChange[]): void {
    this.waiting = merged(this.waiting, changes);
    this.host.changed();
    void this.next();
  }

  /// The server's packing came, with what was checked.
  loaded(): void {
    this.checking = [];
  }

  /// Sends what waits, if it can be sent.
  async next(): Promise<void> {
    clearTimeout(this.timer);
    if (this.sent.length > 0 || this.waiting.length === 0 || !this.host.free()) return;
    this.sent = this.waiting;
    this.waiting = [];
    this.host.sending();
    try {
      await this.host.send(this.sent);
      this.checking = merged(this.checking, this.sent);
      this.sent = [];
      this.host.taken();
      this.host.changed();
    } catch (error) {
      this.failed(error);
    }
  }

  stop(): void {
    clearTimeout(this.timer);
  }

  /// Back to what the server has.
  drop(): void {
    this.waiting = [];
    this.sent = [];
    this.checking = [];
    this.host.changed();
  }

  private failed(error: unknown): void {
    if (error instanceof ApiError && busyStatus.has(error.status)) {
      this.waiting = merged(this.sent, this.waiting);
      this.sent = [];
      this.timer = setTimeout(() => void this.next(), again);
      return;
    }
    this.waiting = [];
    this.sent = [];
    this.host.refused(error instanceof Error ? error.message : "The change was refused.");
    this.host.changed();
  }
}
