/// A run as its lines tell it (docs/format.md, Progress as JSON): what stands where now, and what it is doing. Applying
/// all lines in order holds what the packing file will hold.

import type { Phase, Progress } from "../../api/types";
import type { CopyKey, Transform, ViewCopy } from "../../view/view";
import { Curve } from "./curve";

export interface LiveCopy extends CopyKey {
  readonly transform: Transform;
  /// When it was placed, from 0 on.
  readonly order: number;
}

export interface LiveTray {
  readonly number: number;
  readonly copies: Map<string, LiveCopy>;
  finished: boolean;
}

export interface Landing {
  readonly tray: number;
  readonly copy: LiveCopy;
}

/// What changed in a tray since it was last asked for.
export interface TrayChanges {
  readonly cleared: boolean;
  readonly placed: ViewCopy[];
  readonly removed: CopyKey[];
}

export const copyId = (copy: CopyKey): string => `${copy.part}/${copy.copy}`;

interface Line {
  readonly event?: string;
  readonly phase?: string;
  readonly warning?: string;
  readonly error?: string;
  readonly tray?: number;
  readonly part?: number;
  readonly copy?: number;
  readonly transform?: Transform;
}

export class LiveRun {
  readonly trays = new Map<number, LiveTray>();
  readonly phases = new Set<Phase>();
  /// Seconds that each phase took, as far as it was heard of.
  readonly seconds = new Map<Phase, number>();
  readonly remarks: string[] = [];
  readonly curve = new Curve();
  progress: Progress | null = null;
  newest: Landing | null = null;
  /// Grows with every line, for who watches.
  version = 0;
  private placed = 0;
  private readonly changes = new Map<number, { cleared: boolean; copies: Map<string, LiveCopy | CopyKey> }>();

  clear(): void {
    for (const tray of this.trays.keys()) this.noteCleared(tray);
    this.trays.clear();
    this.phases.clear();
    this.seconds.clear();
    this.remarks.length = 0;
    this.curve.clear();
    this.progress = null;
    this.newest = null;
    this.placed = 0;
    this.version += 1;
  }

  apply(data: unknown): void {
    if (data === null || typeof data !== "object") return;
    const line = data as Line;
    this.version += 1;
    if (line.event !== undefined) this.applyEvent(line);
    else if (line.phase !== undefined) this.applyProgress(data as Progress);
    else if (line.warning !== undefined) this.remark(line.warning);
    else if (line.error !== undefined) this.remark(line.error);
  }

  /// The copies that stand, in all trays.
  get standing(): number {
    let sum = 0;
    for (const tray of this.trays.values()) sum += tray.copies.size;
    return sum;
  }

  /// How many of each part stand.
  counts(): Map<number, number> {
    const counts = new Map<number, number>();
    for (const tray of this.trays.values()) {
      for (const copy of tray.copies.values()) counts.set(copy.part, (counts.get(copy.part) ?? 0) + 1);
    }
    return counts;
  }

  /// The tray that is being filled, or the last that was.
  get current(): number {
    return this.newest?.tray ?? Math.max(1, ...this.trays.keys());
  }

  /// What changed since the last time; all that stands where the tray is shown for the first time (`whole`).
  drain(tray: number, whole = false): TrayChanges {
    const changes = this.changes.get(tray);
    this.changes.delete(tray);
    if (whole) return { cleared: true, placed: [...(this.trays.get(tray)?.copies.values() ?? [])], removed: [] };
    const placed: ViewCopy[] = [];
    const removed: CopyKey[] = [];
    for (const copy of changes?.copies.values() ?? []) {
      if ("transform" in copy) placed.push(copy);
      else removed.push(copy);
    }
    return { cleared: changes?.cleared ?? false, placed, removed };
  }

  private applyEvent(line: Line): void {
    const number = line.tray ?? 1;
    switch (line.event) {
      case "tray_begun":
        this.trays.set(number, { number, copies: new Map(), finished: false });
        this.noteCleared(number);
        break;
      case "copy_placed":
      case "copy_put_back":
      case "copy_moved":
        this.stand(number, line, line.event === "copy_placed");
        break;
      case "copy_taken_out": {
        const copy = { part: line.part ?? 0, copy: line.copy ?? 0 };
        this.tray(number).copies.delete(copyId(copy));
        this.changesOf(number).copies.set(copyId(copy), copy);
        break;
      }
      case "tray_finished":
        this.tray(number).finished = true;
        break;
    }
  }

  private stand(number: number, line: Line, lands: boolean): void {
    if (!line.transform) return;
    const key = { part: line.part ?? 0, copy: line.copy ?? 0 };
    const id = copyId(key);
    const tray = this.tray(number);
    const order = tray.copies.get(id)?.order ?? this.placed++;
    const copy: LiveCopy = { ...key, transform: line.transform, order };
    tray.copies.set(id, copy);
    this.changesOf(number).copies.set(id, copy);
    if (lands) this.newest = { tray: number, copy };
  }

  private applyProgress(progress: Progress): void {
    this.progress = progress;
    this.curve.add(progress);
    this.phases.add(progress.phase);
    this.seconds.set(progress.phase, progress.seconds);
  }

  private remark(text: string): void {
    if (!this.remarks.includes(text)) this.remarks.push(text);
  }

  private tray(number: number): LiveTray {
    let tray = this.trays.get(number);
    if (!tray) {
      tray = { number, copies: new Map(), finished: false };
      this.trays.set(number, tray);
    }
    return tray;
  }

  private changesOf(number: number) {
    let changes = this.changes.get(number);
    if (!changes) {
      changes = { cleared: false, copies: new Map() };
      this.changes.set(number, changes);
    }
    return changes;
  }

  private noteCleared(number: number): void {
    this.changes.set(number, { cleared: true, copies: new Map() });
  }
}
