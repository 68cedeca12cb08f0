/// The list of parts: its head, what is wrong with files, and the table, of which only the rows in sight are drawn.

import { html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { checkBox, iconButton } from "../common/bits";
import { chooseFiles } from "../common/files_button";
import { icon } from "../common/icons";
import { Piece } from "../common/piece";
import { styles } from "../common/styles";
import { app } from "../state/app_state";
import { removeParts } from "../state/draft_edit";
import type { Session } from "../state/session";
import { copies, counted, volume } from "../words/numbers";
import { badFileRows, filesBanner } from "./file_rows";
import { GridKeys } from "./grid_keys";
import { leftOutRows } from "./left_out_rows";
import { partRow } from "./part_row";
import { copiesThere, found, heightOf, type Row, rowsOf, totalVolume } from "./rows";
import { sightOf } from "./sight";
import { uploadBar } from "./upload_bar";

@customElement("sp-parts-list")
export class PartsList extends Piece {
  @property({ attribute: false }) session!: Session;
  @query(".scroll") private readonly scroller!: HTMLElement;
  @query(".find input") private readonly findInput!: HTMLInputElement | null;
  private rows: readonly Row[] = [];
  private top = 0;
  private height = 900;
  private wasFinding = false;
  private readonly grid = new GridKeys(this);
  private readonly sizes = new ResizeObserver(() => {
    this.height = this.scroller.clientHeight;
    this.requestUpdate();
  });

  protected override stores() {
    const { session } = this;
    return [
      session.state,
      session.view,
      session.source.state,
      session.uploads.state,
      session.meshes.state,
      session.run.state,
      app,
    ];
  }

  /// For the keys.
  get shown(): readonly Row[] {
    return this.rows;
  }

  protected override firstUpdated(): void {
    this.sizes.observe(this.scroller);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.sizes.disconnect();
  }

  protected override updated(_changed: PropertyValues): void {
    const finding = this.session.view.value.find !== null;
    if (finding && !this.wasFinding) this.findInput?.focus();
    this.wasFinding = finding;
    this.grid.settle();
  }

  override render() {
    const { session } = this;
    const all = rowsOf(session);
    const { find, chosen } = session.view.value;
    this.rows = found(all, find);
    const sight = sightOf(this.rows.map(heightOf), this.top, this.height);
    const visible = this.rows.slice(sight.first, sight.last);
    const chosenHere = this.rows.filter((row) => chosen.has(row.part.key)).length;
    const allChosen = chosenHere > 0 && chosenHere === this.rows.length;
    return html`${this.head(all)}${uploadBar(session)}${filesBanner(session, all.length)}
      <div class="scroll" @scroll=${this.scrolled}>
        <div
          class="pt"
          role="grid"
          aria-label="Parts"
          aria-multiselectable="true"
          aria-rowcount=${this.rows.length + 1}
          @pointerdown=${{ handleEvent: (event: PointerEvent) => this.grid.pressed(event), capture: true }}
          @pointerup=${(event: PointerEvent) => this.grid.released(event)}
          @keydown=${(event: KeyboardEvent) => this.grid.key(event)}
          @focusin=${(event: FocusEvent) => this.grid.focused(event)}
        >
          <div class="pr ph" role="row" aria-rowindex="1">
            <span role="columnheader" class="c-check">
              ${checkBox("Choose all", allChosen ? true : chosenHere > 0 ? "mixed" : false, (on) =>
                session.view.set({ chosen: new Set(on ? this.rows.map((row) => row.part.key) : []) }),
              )}
            </span>
            <span role="columnheader" class="c-name two">Part</span>
            <span role="columnheader" class="num">Copies</span>
            <span role="columnheader" class="num">Scale</span>
            <span role="columnheader">May stand</span>
            <span role="columnheader" class="num hide-s">Gap</span>
            <span role="columnheader" class="hide-s">Priority</span>
            <span role="columnheader" class="num">Due</span>
          </div>
          ${badFileRows(session)}
          <div role="presentation" ${styles({ height: `${sight.before}px` })}></div>
          ${repeat(
            visible,
            (row) => row.part.key,
            (row, i) => partRow(session, row, sight.first + i, this.grid.cell),
          )}
          <div role="presentation" ${styles({ height: `${sight.after}px` })}></div>
        </div>
        ${all.length === 0 ? this.nothingYet() : nothing}
        ${this.rows.length === 0 && all.length > 0 ? html`<p class="none dim">No part has “${find}” in its name.</p>` : nothing}
        ${leftOutRows(session)}
      </div>`;
  }

  private head(all: readonly Row[]): TemplateResult {
    const { session } = this;
    const { find, chosen } = session.view.value;
    const copiesText = `${copies(copiesThere(all))} · ${volume(totalVolume(all, session))}`;
    return html`<div class="head">
      ${
        chosen.size > 0
          ? html`<h2>${chosen.size} chosen</h2>
              <span class="count grow cut">what you change in one changes in all</span>
              <button type="button" class="btn s" @click=${() => this.leaveOut(chosen)}>Leave out</button>
              ${iconButton("close", "Choose none (Esc)", () => session.view.set({ chosen: new Set() }), "s")}`
          : html`<h2 class="nw">${counted(all.length, "part")}</h2>
              <span class="count grow cut">${all.length > 0 ? copiesText : ""}</span>`
      }
      ${
        find === null
          ? iconButton("find", "Find a part (/)", () => session.view.set({ find: "" }), "s")
          : html`<span class="in s find">
              ${icon("find")}
              <input
                type="search"
                aria-label="Find a part"
                placeholder="Part of the name"
                .value=${find}
                @input=${(event: Event) => session.view.set({ find: (event.target as HTMLInputElement).value })}
                @keydown=${(event: KeyboardEvent) => {
                  if (event.key === "Escape") session.view.set({ find: null });
                }}
              />
            </span>`
      }
      <button type="button" class="btn s" @click=${() => chooseFiles((files) => session.addFiles(files))}>
        ${icon("add")}Add parts
      </button>
    </div>`;
  }

  private nothingYet(): TemplateResult | typeof nothing {
    const { session } = this;
    if (session.parts.reading > 0 || session.uploads.state.value.active) return nothing;
    return html`<div class="none">
      <h2>No parts yet</h2>
      <p class="dim">Drop files or a folder here, or choose them.</p>
      <div class="row">
        <button type="button" class="btn" @click=${() => chooseFiles((files) => session.addFiles(files))}>
          ${icon("file")}Choose files
        </button>
        <button
          type="button"
          class="btn"
          @click=${() => chooseFiles((files) => session.addFiles(files), { folder: true })}
        >
          ${icon("folder")}Choose a folder
        </button>
      </div>
    </div>`;
  }

  private leaveOut(keys: ReadonlySet<string>): void {
    const text = keys.size === 1 ? "1 part is left out." : `${keys.size} parts are left out.`;
    this.session.editWithToast(text, (draft) => removeParts(draft, keys));
  }

  private scrolled(): void {
    this.top = this.scroller.scrollTop;
    this.requestUpdate();
  }

  /// The row comes into sight, and is drawn.
  reveal(place: number): void {
    const heights = this.rows.map(heightOf);
    const y = heights.slice(0, place).reduce((sum, height) => sum + height, 0);
    const head = 32;
    const { scrollTop, clientHeight } = this.scroller;
    if (y < scrollTop) this.scroller.scrollTop = y;
    else if (y + (heights[place] ?? 0) > scrollTop + clientHeight - head) {
      this.scroller.scrollTop = y + (heights[place] ?? 0) - clientHeight + head;
    }
    this.top = this.scroller.scrollTop;
    this.requestUpdate();
  }
}
