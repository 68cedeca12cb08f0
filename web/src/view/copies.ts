/// Which copies stand where. Every copy has a slot, a small number that stays its own while it stands; what belongs to
/// it lies in plain arrays under that number, ready for the graphics card and for loops over thousands.

import { type Box, boxOf, writeRows } from "./affine";
import type { CopyKey, ViewCopy } from "./view";

/// Part and copy in one number: both stay far below 2^26.
export function keyNumber({ part, copy }: CopyKey): number {
  return part * 2 ** 26 + copy;
}

export class Copies {
  /// 12 numbers a slot, see affine.ts.
  rows = new Float32Array(0);
  /// 6 numbers a slot.
  boxes = new Float32Array(0);
  part = new Int32Array(0);
  copy = new Int32Array(0);
  order = new Float64Array(0);
  /// NaN: not known.
  step = new Float64Array(0);
  /// When it landed and when it last moved, in ms of the page's clock; -Infinity: long ago.
  landedAt = new Float64Array(0);
  movedAt = new Float64Array(0);

  private slots = new Map<number, number>();
  private free: number[] = [];
  private used = 0;
  private partSlots = new Map<number, Set<number>>();
  private partBoxes = new Map<number, Readonly<Box>>();

  get size(): number {
    return this.slots.size;
  }

  /// One more than the greatest slot in use.
  get end(): number {
    return this.used;
  }

  /// The box of a part's mesh in its own coordinates; copies of parts without one are not placed.
  setPart(part: number, box: Readonly<Box>): void {
    this.partBoxes.set(part, box);
    for (const slot of this.partSlots.get(part) ?? []) this.updateBox(slot);
  }

  hasPart(part: number): boolean {
    return this.partBoxes.has(part);
  }

  clear(): void {
    this.slots.clear();
    this.partSlots.clear();
    this.free = [];
    this.used = 0;
  }

  clearParts(): void {
    this.clear();
    this.partBoxes.clear();
  }

  slotOf(key: CopyKey): number | undefined {
    return this.slots.get(keyNumber(key));
  }

  keyOf(slot: number): CopyKey {
    return { part: this.part[slot] as number, copy: this.copy[slot] as number };
  }

  keyNumberOf(slot: number): number {
    return keyNumber({ part: this.part[slot] as number, copy: this.copy[slot] as number });
  }

  all(): Iterable<number> {
    return this.slots.values();
  }

  ofPart(part: number): Iterable<number> {
    return this.partSlots.get(part) ?? [];
  }

  /// Says which slot it has and whether it stood before; null for a copy of an unknown part.
  place(copy: ViewCopy, now: number, landing: boolean): { slot: number; moved: boolean } | null {
    if (!this.partBoxes.has(copy.part)) return null;
    const key = keyNumber(copy);
    const before = this.slots.get(key);
    const slot = before ?? this.free.pop() ?? this.used++;
    if (slot >= this.part.length) this.enlarge(Math.max(64, 2 * slot));
    writeRows(copy.transform, this.rows, 12 * slot);
    this.part[slot] = copy.part;
    this.copy[slot] = copy.copy;
    this.order[slot] = copy.order;
    this.step[slot] = copy.step ?? Number.NaN;
    this.landedAt[slot] = landing ? now : -Infinity;
    this.movedAt[slot] = before === undefined ? -Infinity : now;
    this.updateBox(slot);
    if (before === undefined) {
      this.slots.set(key, slot);
      const siblings = this.partSlots.get(copy.part);
      if (siblings) siblings.add(slot);
      else this.partSlots.set(copy.part, new Set([slot]));
    }
    return { slot, moved: before !== undefined };
  }

  remove(key: CopyKey): boolean {
    const slot = this.slots.get(keyNumber(key));
    if (slot === undefined) return false;
    this.slots.delete(keyNumber(key));
    this.partSlots.get(key.part)?.delete(slot);
    this.free.push(slot);
    return true;
  }

  boxOf(slot: number): Box {
    const b = this.boxes;
    const at = 6 * slot;
    return [b[at], b[at + 1], b[at + 2], b[at + 3], b[at + 4], b[at + 5]] as Box;
  }

  private updateBox(slot: number): void {
    const own = this.partBoxes.get(this.part[slot] as number);
    if (own) this.boxes.set(boxOf(this.rows, own, 12 * slot), 6 * slot);
  }

  private enlarge(capacity: number): void {
    const larger = <T extends Float32Array | Float64Array | Int32Array>(old: T, fresh: T): T => {
      fresh.set(old);
      return fresh;
    };
    this.rows = larger(this.rows, new Float32Array(12 * capacity));
    this.boxes = larger(this.boxes, new Float32Array(6 * capacity));
    this.part = larger(this.part, new Int32Array(capacity));
    this.copy = larger(this.copy, new Int32Array(capacity));
    this.order = larger(this.order, new Float64Array(capacity));
    this.step = larger(this.step, new Float64Array(capacity));
    this.landedAt = larger(this.landedAt, new Float64Array(capacity));
    this.movedAt = larger(this.movedAt, new Float64Array(capacity));
  }
}
