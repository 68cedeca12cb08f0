/// What all components have in common: they draw into the page itself, so that one set of sheets holds for all, and draw
/// again when a store that they watch changes.

import { LitElement } from "lit";
import type { Store } from "../state/store";

type Watched = Store<object>;

export abstract class Piece extends LitElement {
  private watching: (() => void)[] = [];
  private watchedStores: readonly Watched[] = [];

  /// The stores to watch, asked after every change of a property.
  protected stores(): readonly unknown[] {
    return [];
  }

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.watchStores();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const stop of this.watching) stop();
    this.watching = [];
    this.watchedStores = [];
  }

  protected override willUpdate(): void {
    this.watchStores();
  }

  private watchStores(): void {
    const stores = this.stores() as readonly Watched[];
    const same = stores.length === this.watchedStores.length && stores.every((s, i) => s === this.watchedStores[i]);
    if (same) return;
    for (const stop of this.watching) stop();
    this.watching = stores.map((store) => store.subscribe(() => this.requestUpdate()));
    this.watchedStores = stores;
  }
}
