/// What was left over, why, and what helps.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, property } from "lit/decorators.js";
import { partColour } from "../../view/palette";
import { picture } from "../common/bits";
import { Piece } from "../common/piece";
import { app } from "../state/app_state";
import { leftOverWords, type Remedy } from "../state/left_over";
import type { LeftOver, Packing } from "../state/packing";
import { go } from "../state/route";
import type { Session } from "../state/session";
import { copies } from "../words/numbers";
import { type BuildPart, draftKeyOf } from "./build_parts";

@customElement("sp-left-over")
export class LeftOverList extends Piece {
  @property({ attribute: false }) session!: Session;
  @property({ attribute: false }) parts: readonly BuildPart[] = [];

  protected override stores() {
    const { session } = this;
    return [session.run.state, session.state, session.meshes.state, session.work.state, session.work.move.state, app];
  }

  override render() {
    const { packing } = this.session.run.state.value;
    if (!packing || packing.leftOver.length === 0) return nothing;
    const total = packing.leftOver.reduce((sum, row) => sum + row.copies, 0);
    const remedies = this.shared(packing);
    return html`<section class="left-over" aria-label="Left over">
      <h3>Left over <span class="count">${copies(total)}</span></h3>
      ${packing.leftOver.map((row) => this.row(packing, row, remedies))}
    </section>`;
  }

  /// A remedy that helps several parts at once is offered once, at the first of them.
  private shared(packing: Packing): Map<string, LeftOver> {
    const first = new Map<string, LeftOver>();
    for (const row of packing.leftOver) {
      if (row.byHand) continue;
      const { remedy } = this.words(packing, row);
      if (remedy.draft && !first.has(remedy.text)) first.set(remedy.text, row);
    }
    return first;
  }

  private words(packing: Packing, row: LeftOver) {
    return leftOverWords(row, packing, this.session.draft, draftKeyOf(this.session, packing, row.part));
  }

  private row(packing: Packing, row: LeftOver, remedies: ReadonlyMap<string, LeftOver>): TemplateResult {
    const { text, remedy } = this.words(packing, row);
    if (row.byHand) return this.byHand(packing, row);
    const offered = remedy.draft === null || remedies.get(remedy.text) === row;
    return this.frame(
      packing,
      row,
      text,
      offered
        ? html`<button type="button" class="link small" @click=${() => this.take(packing, row, remedy)}>
            ${remedy.text}
          </button>`
        : nothing,
    );
  }

  private frame(
    packing: Packing,
    row: LeftOver,
    text: string,
    remedies: TemplateResult | typeof nothing,
  ): TemplateResult {
    const part = this.parts.find((own) => own.index === row.part);
    const { meshes } = this.session;
    const shot = part?.mesh ? meshes.picture(part.mesh, partColour(row.part), app.value.theme) : null;
    return html`<div class="left-row">
      ${picture(shot)}
      <div class="grow">
        <div class="row between">
          <span class="cut">${part?.name ?? packing.parts[row.part]?.name ?? ""}</span>
          <span class="dim nw">${row.copies} of ${part?.count ?? row.copies}</span>
        </div>
        <div class="small dim">${text}</div>
        ${remedies}
      </div>
    </div>`;
  }

  /// Taken out by hand: back where it stood, or somewhere else.
  private byHand(packing: Packing, row: LeftOver): TemplateResult {
    const { work } = this.session;
    const which = row.which.map((copy) => ({ part: row.part, copy }));
    const [first] = which;
    const off = this.session.run.packs || work.move.active;
    return this.frame(
      packing,
      row,
      "Taken out by hand.",
      html`<span class="row">
        <button type="button" class="link small" ?disabled=${off} @click=${() => work.putBack(which)}>
          ${which.length > 1 ? `Put all ${which.length} back` : "Put back"}
        </button>
        <button type="button" class="link small" ?disabled=${off} @click=${() => first && work.placeByHand(first)}>
          Place by hand
        </button>
      </span>`,
    );
  }

  private take(packing: Packing, row: LeftOver, remedy: Remedy): void {
    if (remedy.draft) {
      void this.session.packWith(remedy.draft);
      return;
    }
    const key = draftKeyOf(this.session, packing, row.part);
    if (key !== null) this.session.view.set({ current: key });
    go({ page: "job", id: this.session.id, step: "parts" });
  }
}
