/// What came of it: what stays true about the run, figures, the selected copy, and what was checked.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, property } from "lit/decorators.js";
import { figure } from "../common/bits";
import { icon } from "../common/icons";
import { Piece } from "../common/piece";
import { app } from "../state/app_state";
import type { Packing } from "../state/packing";
import { go } from "../state/route";
import type { Session } from "../state/session";
import { improvedWords } from "../words/improve";
import { count } from "../words/numbers";
import { duration } from "../words/times";
import type { BuildPart } from "./build_parts";
import { checkedList, uncheckedNote } from "./checked";
import { curveFigure } from "./curve_figure";
import { improveMenu } from "./improve_panel";
import { packAgainMenu } from "./pack_menu";
import { notes } from "./result_notes";
import "./selected_copy";

@customElement("sp-result")
export class ResultPanel extends Piece {
  @property({ attribute: false }) session!: Session;
  @property({ attribute: false }) packing!: Packing;
  @property({ attribute: false }) parts: readonly BuildPart[] = [];
  /// 0: all side by side.
  @property({ type: Number }) tray = 1;

  protected override stores() {
    const { session } = this;
    return [session.run.state, session.state, session.build, session.work.state, app];
  }

  override render() {
    const { session, packing, tray } = this;
    const title = packing.trays.length < 2 ? "Build" : tray === 0 ? "All trays" : `Tray ${tray}`;
    return html`<div class="head">
        <h2 class="grow nw">${title}</h2>
        <button
          type="button"
          class="btn s ghost"
          @click=${() => go({ page: "job", id: session.id, step: "parts" })}
        >
          ${icon("add")}Add parts
        </button>
        ${packAgainMenu(session)}
      </div>
      <div class="scroll">
        ${notes(session, packing, tray)}
        <section class="sec">${this.figures()}</section>
        ${
          session.build.value.selected.length > 0 && tray > 0
            ? html`<sp-selected .session=${session} .packing=${packing} .parts=${this.parts} .tray=${tray}></sp-selected>`
            : nothing
        }
        ${session.work.unchecked ? uncheckedNote(session) : checkedList(session.job, packing)} ${this.how()}
      </div>`;
  }

  private figures(): TemplateResult {
    const { packing, session, tray } = this;
    const own = packing.trays[tray - 1];
    const gap = session.job.verdict?.min_gap ?? packing.minGap;
    const placed = own && packing.trays.length > 1 ? own.placements.length : packing.placed;
    const height = own ? own.height : Math.max(0, ...packing.trays.map((one) => one.height));
    const density = own ? own.density : packing.density;
    const filled = own ? "of the tray filled" : `filled, of ${packing.trays.length} trays`;
    return html`<div class="fig">
      ${figure((density * 100).toFixed(1), "%", filled)}
      ${figure(
        height.toFixed(1),
        "mm",
        packing.openHeight ? "height reached" : own ? `height of ${count(packing.size[2])}` : "greatest height",
      )}
      ${figure(count(placed), `of ${count(packing.copies)}`, own && packing.trays.length > 1 ? "copies in this tray" : "copies placed")}
      ${gap === null ? figure("–", "", "least gap") : figure(gap.toFixed(2), "mm", "least gap, measured")}
    </div>`;
  }

  private how(): TemplateResult {
    const { packing } = this;
    const better = packing.improvement;
    return html`<section class="sec">
      <h3>How it went</h3>
      <p class="dim">Packed in ${duration(packing.seconds)}.</p>
      ${better ? html`<p class="dim">${improvedWords(better.what, better.before, better.now)}</p>` : nothing}
      ${curveFigure(this.session.run.live.curve, true)} ${improveMenu(this.session)}
    </section>`;
  }
}
