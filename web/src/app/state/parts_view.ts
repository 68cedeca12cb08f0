/// Which parts of the list are looked at and chosen.

import { Store } from "./store";

export interface PartsView {
  /// The row that the preview shows.
  readonly current: string | null;
  /// Rows that change together; empty: the current one alone.
  readonly chosen: ReadonlySet<string>;
  readonly find: string | null;
  readonly advanced: boolean;
  readonly inch: boolean;
}

export const newPartsView = () =>
  new Store<PartsView>({ current: null, chosen: new Set(), find: null, advanced: false, inch: false });

/// What a change of `key` changes: all that are chosen, where it is one of them.
export function together(view: PartsView, key: string): ReadonlySet<string> {
  return view.chosen.has(key) ? view.chosen : new Set([key]);
}
