/// Asks the server how near a copy would stand to others: one question at a time, the newest next, and again where it is
/// busy.

import { ApiError } from "../../api/client";
import type { Clearance } from "../../api/types";
import type { Transform } from "../../view/view";

export interface Asking {
  ask(transform: Transform, signal: AbortSignal): Promise<Clearance>;
  answered(transform: Transform, clearance: Clearance): void;
  /// Why there is no answer yet; null: it is only not there yet.
  waits(why: string | null): void;
}

/// ms that a copy rests before it is measured, and until a busy server is asked again.
const rest = 120;
const again = 600;

export class Asker {
  private wanted: Transform | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private flight: Promise<void> | null = null;
  private stopper = new AbortController();

  constructor(private readonly asking: Asking) {}

  /// Answered once it rests.
  want(transform: Transform): void {
    this.wanted = transform;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.next(), rest);
  }

  /// Answered in its turn; what was wanted before is not asked any more.
  async now(transform: Transform): Promise<Clearance> {
    this.wanted = null;
    clearTimeout(this.timer);
    await this.flight;
    const { signal } = this.stopper;
    for (;;) {
      try {
        return await this.asking.ask(transform, signal);
      } catch (error) {
        if (signal.aborted || !this.isLater(error)) throw error;
        await new Promise((resolve) => setTimeout(resolve, again));
      }
    }
  }

  stop(): void {
    this.wanted = null;
    clearTimeout(this.timer);
    this.stopper.abort();
    this.stopper = new AbortController();
  }

  private async next(): Promise<void> {
    const transform = this.wanted;
    if (this.flight || !transform) return;
    this.wanted = null;
    this.flight = this.once(transform, this.stopper.signal);
    await this.flight;
    this.flight = null;
    if (this.wanted) this.timer = setTimeout(() => void this.next(), this.wanted === transform ? again : 0);
  }

  private async once(transform: Transform, signal: AbortSignal): Promise<void> {
    try {
      const clearance = await this.asking.ask(transform, signal);
      if (!signal.aborted) this.asking.answered(transform, clearance);
    } catch (error) {
      if (signal.aborted) return;
      if (this.isLater(error)) this.wanted ??= transform;
      else this.asking.waits(error instanceof Error ? error.message : "It could not be measured.");
    }
  }

  private isLater(error: unknown): boolean {
    if (!(error instanceof ApiError)) return false;
    if (error.status === 409) this.asking.waits("The change before is checked first; then the gap is measured.");
    return [0, 409, 429, 503].includes(error.status);
  }
}
