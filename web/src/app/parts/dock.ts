/// What to expect, and Pack.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { packEntries } from "../build/pack_menu";
import { figure } from "../common/bits";
import { icon, spinner } from "../common/icons";
import "../common/menu";
import { Piece } from "../common/piece";
import { app } from "../state/app_state";
import type { Session } from "../state/session";
import { bytes, copies, counted, thin } from "../words/numbers";
import { duration } from "../words/times";
import { badFiles } from "./file_rows";
import { copiesThere, rowsOf } from "./rows";

@customElement("sp-dock")
export class Dock extends Piece {
  @property({ attribute: false }) session!: Session;
  @state() private starting = false;

  protected override stores() {
    const { session } = this;
    const { saver, source, uploads, run, work } = session;
    return [session.state, saver.state, source.state, uploads.state, run.state, work.state, app];
  }

  override render() {
    const { session } = this;
    const total = copiesThere(rowsOf(session));
    const busy = session.uploads.state.value.active || session.parts.reading > 0;
    return html`<footer class="dock" aria-label="Estimate">
      ${this.figures()}
      <span class="grow"></span>
      ${this.remark(busy)} ${this.packButton(total, session.locked || total === 0 || busy || this.starting)}
    </footer>`;
  }

  /// Where copies are locked, packing may keep them: it is asked which way.
  private packButton(total: number, off: boolean): TemplateResult {
    const { session } = this;
    const text = html`${this.starting ? spinner : nothing}${total > 0 ? `Pack ${copies(total)}` : "Pack"}
      <kbd class="hide-s">Ctrl ↵</kbd>`;
    if (session.work.state.value.locks.size > 0 && session.job.has_packing) {
      return html`<sp-menu
        class="pack-again"
        buttonClasses="btn primary l pack"
        menuClasses="wide"
        ?disabled=${off}
        .button=${html`${text}${icon("down")}`}
        .content=${() => packEntries(session)}
      ></sp-menu>`;
    }
    return html`<button type="button" class="btn primary l pack" ?disabled=${off} @click=${this.pack}>${text}</button>`;
  }

  private figures(): TemplateResult | typeof nothing {
    const { estimate, estimating } = this.session.saver.state.value;
    if (!estimate) return estimating ? html`<span class="dim row">${spinner}Estimating …</span>` : nothing;
    const { volume_ratio: ratio, seconds, memory } = estimate;
    const [time, timeUnit] = seconds === null ? ["", ""] : duration(seconds).split(thin);
    const [size, sizeUnit] = bytes(memory).split(thin);
    return html`<div class="fig ${estimating ? "stale" : ""}">
      ${ratio === undefined ? nothing : this.fill(ratio)}
      ${time ? figure(`≈ ${time}`, timeUnit ?? "", "to pack") : nothing}
      ${figure(`≈ ${size}`, sizeUnit ?? "", "of memory")}
    </div>`;
  }

  /// How much material there is for the trays that may be filled.
  private fill(ratio: number): TemplateResult {
    const { draft } = this.session;
    if (draft.trays === "all" || ratio > 1)
      return figure(`≈ ${ratio.toFixed(ratio < 10 ? 2 : 0)}`, "trays", "of solid material");
    const share = (ratio / draft.trays) * 100;
    return figure(
      `≈ ${share.toFixed(share < 10 ? 1 : 0)}`,
      "%",
      draft.trays > 1 ? "of the trays filled" : "of the tray filled",
    );
  }

  private remark(busy: boolean): TemplateResult | typeof nothing {
    const { session } = this;
    const { problem, doubt, estimate } = session.saver.state.value;
    if (problem ?? doubt)
      return html`<span class="row small bad-text remark-text">${icon("bad")}<span>${problem ?? doubt}</span></span>`;
    if (busy) return html`<span class="row small dim">${spinner}Files are still read</span>`;
    const wrong = rowsOf(session).filter((row) => row.remarks.some((remark) => remark.tone === "bad")).length;
    if (wrong > 0) {
      return html`<span class="row small warn-text"
        >${icon("warn")}<span>Not everything may fit: ${counted(wrong, "part")} ${wrong === 1 ? "needs" : "need"} a look</span></span
      >`;
    }
    const bad = badFiles(session).length;
    if (bad > 0) {
      return html`<span class="row small bad-text">${icon("bad")}<span>${counted(bad, "file")} will be left out</span></span>`;
    }
    const left = estimate?.left_over ?? 0;
    if (left > 0) {
      return html`<span class="row small warn-text">${icon("warn")}<span>${copies(left)} will be left over</span></span>`;
    }
    return nothing;
  }

  private async pack(): Promise<void> {
    this.starting = true;
    await this.session.pack();
    this.starting = false;
  }
}
