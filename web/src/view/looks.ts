/// How every copy looks at the moment: its colour, whether it is drawn at all, faint or outlined. What the page sets is
/// kept here by copy, so that it holds for copies that are placed later, too.

import { type Rgb, rgbOfHex } from "./colour";
import { type Copies, keyNumber } from "./copies";
import { copyRgb, type Ramp, rampColours, rampRgb } from "./palette";
import { tokens } from "./tokens";
import type { Colouring, CopyKey, Theme } from "./view";

export const none = 0;
export const accentOutline = 1;
export const markOutline = 2;

type Test = (copy: CopyKey) => boolean;

const rampSteps = 255;
const tables: Record<Ramp, Rgb[]> = { "one-hue": [], height: [] };

function fromRamp(ramp: Ramp, share: number): Rgb {
  const table = tables[ramp];
  if (table.length === 0) for (let i = 0; i <= rampSteps; ++i) table.push(rampRgb(ramp, i / rampSteps));
  return table[Math.round(Math.min(1, Math.max(0, share)) * rampSteps)] ?? [0, 0, 0];
}

function numbersOf(copies: readonly CopyKey[]): Set<number> {
  return new Set(copies.map(keyNumber));
}

function alike(a: ReadonlySet<number>, b: ReadonlySet<number>): boolean {
  return a.size === b.size && [...a].every((v) => b.has(v));
}

export class Looks {
  theme: Theme = "light";
  colouring: Colouring = "part";
  selected: ReadonlySet<number> = new Set();
  leaving: ReadonlySet<number> = new Set();
  /// What leaves is drawn in its part's colour, with an outline.
  leavesInColour = false;
  marked: ReadonlySet<number> = new Set();
  mark: "warn" | "bad" = "warn";
  othersPale = false;
  /// They keep their colour and have an outline in a quiet one, as long as nothing is marked.
  locked: ReadonlySet<number> = new Set();
  hidden: Test | null = null;
  faint: Test | null = null;
  /// The copy that landed last.
  latest: number | null = null;
  /// Paints copies in place of the palette.
  paint: ((copy: CopyKey) => Rgb) | null = null;

  private low = 0;
  private high = 0;
  private bases = new Map<number, Rgb>();

  /// These three say whether anything changed: the page may set the same again and again.
  select(copies: readonly CopyKey[]): boolean {
    const before = this.selected;
    this.selected = numbersOf(copies);
    return !alike(before, this.selected);
  }

  leave(copies: readonly CopyKey[], ownColour = false): boolean {
    const before = this.leaving;
    const same = this.leavesInColour === ownColour;
    this.leaving = numbersOf(copies);
    this.leavesInColour = ownColour;
    return !same || !alike(before, this.leaving);
  }

  markThese(copies: readonly CopyKey[], othersPale: boolean, mark: "warn" | "bad"): boolean {
    const before = this.marked;
    const same = this.othersPale === othersPale && this.mark === mark;
    this.marked = numbersOf(copies);
    this.othersPale = othersPale;
    this.mark = mark;
    return !same || !alike(before, this.marked);
  }

  lock(copies: readonly CopyKey[]): boolean {
    const before = this.locked;
    this.locked = numbersOf(copies);
    return !alike(before, this.locked);
  }

  isHidden(copies: Copies, slot: number): boolean {
    return this.hidden?.(copies.keyOf(slot)) ?? false;
  }

  isFaint(copies: Copies, slot: number): boolean {
    return this.faint?.(copies.keyOf(slot)) ?? false;
  }

  outlineOf(copies: Copies, slot: number): number {
    const key = copies.keyNumberOf(slot);
    if (this.selected.has(key) || this.latest === key) return accentOutline;
    if (this.leavesInColour && this.leaving.has(key)) return accentOutline;
    const marked = this.marked.size > 0 || this.othersPale ? this.marked : this.locked;
    return marked.has(key) ? markOutline : none;
  }

  get outlineColour(): { accent: string; mark: string } {
    const t = tokens(this.theme);
    if (this.marked.size === 0) return { accent: t.accent, mark: t.text };
    return { accent: t.accent, mark: this.mark === "bad" ? t.bad : t.warnMark };
  }

  /// How strongly outlined copies are seen through those before them. What is moved by hand is looked for; that copies are
  /// locked is said of those in sight.
  get through(): { accent: number; mark: number } {
    const moved = this.othersPale && this.mark === "bad" ? 0.45 : 0.1;
    return { accent: moved, mark: this.marked.size === 0 ? 0 : moved };
  }

  /// Least and greatest value of the colouring, from the copies that stand.
  measure(copies: Copies): void {
    this.low = Infinity;
    this.high = -Infinity;
    if (this.colouring === "part") return;
    for (const slot of copies.all()) {
      const value = this.valueOf(copies, slot);
      if (Number.isNaN(value)) continue;
      this.low = Math.min(this.low, value);
      this.high = Math.max(this.high, value);
    }
  }

  /// In linear light. `measure` comes first where copies came or moved.
  colourOf(copies: Copies, slot: number): Rgb {
    const t = tokens(this.theme);
    const key = copies.keyNumberOf(slot);
    if (this.leaving.has(key)) return this.leavesInColour ? this.baseOf(copies, slot, key) : rgbOfHex(t.accent);
    // While something leaves in the accent, what is selected has a lighter blue, so that both can be told apart.
    if (this.selected.has(key)) return rgbOfHex(this.leaving.size > 0 ? t.select : t.accent);
    if (this.marked.has(key)) return rgbOfHex(this.mark === "bad" ? t.bad : t.warnMark);
    if (this.othersPale) return rgbOfHex(t.stay);
    if (this.colouring === "part") return this.baseOf(copies, slot, key);
    const value = this.valueOf(copies, slot);
    if (Number.isNaN(value)) return rgbOfHex(t.stay);
    return fromRamp(this.ramp, (value - this.low) / (this.high - this.low || 1));
  }

  legend(): { readonly colours: readonly string[]; readonly values: readonly number[] } | null {
    if (this.colouring === "part" || !(this.low <= this.high)) return null;
    return { colours: rampColours(this.ramp), values: [this.low, (this.low + this.high) / 2, this.high] };
  }

  private get ramp(): Ramp {
    return this.colouring === "height" ? "height" : "one-hue";
  }

  private baseOf(copies: Copies, slot: number, key: number): Rgb {
    if (this.paint) return this.paint(copies.keyOf(slot));
    let base = this.bases.get(key);
    if (!base) {
      base = copyRgb(copies.part[slot] as number, copies.copy[slot] as number);
      this.bases.set(key, base);
    }
    return base;
  }

  private valueOf(copies: Copies, slot: number): number {
    if (this.colouring === "order") return copies.order[slot] as number;
    if (this.colouring === "way") return copies.step[slot] as number;
    // The middle of its box: a copy that lies flat on others is as high as it looks.
    return ((copies.boxes[6 * slot + 2] as number) + (copies.boxes[6 * slot + 5] as number)) / 2;
  }
}
