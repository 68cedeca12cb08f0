/// How a value becomes better while it is improved: from the progress that a run tells, also when it is told again.

import type { Progress } from "../../api/types";

export interface CurvePoint {
  /// As the run tells them.
  readonly seconds: number;
  readonly value: number;
}

export class Curve {
  /// height, density, copies, value, trays or box; empty before anything was told.
  what = "";
  before = 0;
  /// From the first value on, one for each that is better.
  points: readonly CurvePoint[] = [];
  /// Until when it is known.
  seconds = 0;
  left: number | null = null;

  add({ phase, what, before, now, seconds, left }: Progress): void {
    if (phase !== "improve" || what === undefined || before === undefined || now === undefined) return;
    if (what !== this.what || before !== this.before || seconds < this.seconds) this.begin(what, before, seconds);
    this.seconds = seconds;
    this.left = left ?? null;
    const last = this.points[this.points.length - 1];
    if (last && last.value !== now) this.points = [...this.points, { seconds, value: now }];
  }

  get now(): number {
    return this.points[this.points.length - 1]?.value ?? this.before;
  }

  get isThere(): boolean {
    return this.what !== "";
  }

  clear(): void {
    this.what = "";
    this.points = [];
    this.seconds = 0;
    this.left = null;
  }

  private begin(what: string, before: number, seconds: number): void {
    this.what = what;
    this.before = before;
    this.points = [{ seconds, value: before }];
  }
}
