/// Undo and redo on the Build step: changes by hand and locks, each with what takes it back, and packings, which the
/// server goes back to.

import type { CopyChange } from "./change";

export type Locks = ReadonlySet<string>;

/// A packing as the server numbers it, and what belonged to it in this browser.
export interface Revision {
  readonly number: number;
  readonly locks: Locks;
  /// What it was packed with (session.ts).
  readonly packed: string | null;
}

export type Entry =
  | {
      readonly kind: "changes";
      readonly does: readonly CopyChange[];
      readonly undoes: readonly CopyChange[];
      readonly before: Locks;
      readonly after: Locks;
    }
  | { readonly kind: "locks"; readonly before: Locks; readonly after: Locks }
  /// `after` null: it is not done yet.
  | { readonly kind: "pack"; readonly before: Revision; readonly after: Revision | null };

export interface Lists {
  readonly past: readonly Entry[];
  readonly future: readonly Entry[];
}

const most = 200;

export class BuildHistory {
  private lists: Lists = { past: [], future: [] };

  get now(): Lists {
    return this.lists;
  }

  get last(): Entry | null {
    return this.lists.past[this.lists.past.length - 1] ?? null;
  }

  get next(): Entry | null {
    return this.lists.future[this.lists.future.length - 1] ?? null;
  }

  push(entry: Entry): void {
    this.lists = { past: [...this.lists.past, entry].slice(-most), future: [] };
  }

  /// The entry that is to be taken back.
  undo(): Entry | null {
    const { last } = this;
    if (last) this.lists = { past: this.lists.past.slice(0, -1), future: [...this.lists.future, last] };
    return last;
  }

  /// The entry that is to be done again.
  redo(): Entry | null {
    const { next } = this;
    if (next) this.lists = { past: [...this.lists.past, next], future: this.lists.future.slice(0, -1) };
    return next;
  }

  /// The same entry, known better: wherever it stands.
  replace(entry: Entry, by: Entry | null): void {
    const swap = (list: readonly Entry[]) => list.flatMap((own) => (own === entry ? (by ? [by] : []) : [own]));
    this.lists = { past: swap(this.lists.past), future: swap(this.lists.future) };
  }

  restore(lists: Lists): void {
    this.lists = lists;
  }
}
