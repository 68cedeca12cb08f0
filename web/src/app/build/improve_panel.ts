/// A packing that is made better: the value and its curve, the time that is left, and stop. And the button that begins it.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, property } from "lit/decorators.js";
import { bar, figure } from "../common/bits";
import { icon, spinner } from "../common/icons";
import "../common/menu";
import { Piece } from "../common/piece";
import { app } from "../state/app_state";
import type { Session } from "../state/session";
import { startImproving } from "../state/start_packing";
import { gainWords, valueName, valueWords } from "../words/improve";
import { thin } from "../words/numbers";
import { phaseText } from "../words/phases";
import { clock } from "../words/times";
import { curveFigure } from "./curve_figure";

const day = 86_400;
/// What comes once it is over.
const ending: ReadonlySet<string> = new Set(["write", "render", "check"]);

@customElement("sp-improve")
export class ImprovePanel extends Piece {
  @property({ attribute: false }) session!: Session;
  private ticking = 0;

  protected override stores() {
    return [this.session.run.state, app];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    // The clock goes on while nothing is said.
    this.ticking = window.setInterval(() => this.requestUpdate(), 1000);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearInterval(this.ticking);
  }

  override render() {
    const { job } = this.session.run.state.value;
    const { curve, progress } = this.session.run.live;
    const ends = progress !== null && curve.isThere && ending.has(progress.phase);
    return html`<div class="head">
        <h2 class="grow">Improving</h2>
        ${ends || job.status === "queued" ? nothing : html`<span class="count">${clock(curve.seconds)} so far</span>`}
      </div>
      <div class="scroll">
        ${job.status === "queued" ? this.queued() : curve.isThere ? this.improving() : this.beginning()}
        ${ends && progress ? html`<section class="sec row">${spinner}<span>${phaseText(progress.phase)}</span></section>` : nothing}
      </div>
      ${this.stop()}`;
  }

  private queued(): TemplateResult {
    const place = this.session.job.queue_place;
    return html`<section class="sec">
      <p><b>${place ? `Place ${place} in the queue.` : "In the queue."}</b> It begins as soon as the jobs before it are done.</p>
    </section>`;
  }

  private beginning(): TemplateResult {
    const { progress } = this.session.run.live;
    return html`<section class="sec">
      <p class="row">${spinner}<span>${progress ? phaseText(progress.phase) : "Getting ready"}</span></p>
      <p class="small faint after">The build that stands is kept until a better one is found.</p>
    </section>`;
  }

  private improving(): TemplateResult {
    const { curve } = this.session.run.live;
    const { what, before, now, left, seconds } = curve;
    const gain = gainWords(what, before, now);
    const endless = left === null || left > day / 2;
    const [value = "", unit = ""] = valueWords(what, now).split(thin);
    const total = seconds + Math.max(0, left ?? 0);
    return html`<section class="sec">
        <div class="fig">
          ${figure(value, unit, `${valueName(what)}, best so far`)}
          ${endless ? figure("–", "", "until it is stopped") : figure(clock(left), "left", `of ${clock(total)}`)}
        </div>
        ${endless ? nothing : bar(total > 0 ? seconds / total : 0, "Time used", "thick")}
      </section>
      <section class="sec">
        <h3>${gain ?? "Nothing better yet"}</h3>
        ${curveFigure(curve)}
        <p class="small faint after">
          Other orders are tried. Each better build takes the place of the one before, and has its own way apart.
        </p>
      </section>`;
  }

  private stop(): TemplateResult {
    const { job, stopping } = this.session.run.state.value;
    const halts = stopping || job.stopping === true;
    return html`<section class="sec bottom">
      <button type="button" class="btn l fill" ?disabled=${halts} @click=${() => this.session.stop()}>
        ${halts ? spinner : icon("stop")}${halts ? "Stopping" : "Stop and keep the best"}
      </button>
      <p class="small faint">
        ${halts ? "The best build is checked." : "Closing this page does not stop it."}
      </p>
    </section>`;
  }
}

const times: readonly (readonly [number, string, string])[] = [
  [60, "For 1 minute", ""],
  [300, "For 5 minutes", ""],
  [900, "For 15 minutes", ""],
  [day, "Until it is stopped", "or for a day"],
];

export function improveMenu(session: Session): TemplateResult | typeof nothing {
  const { job } = session.run.state.value;
  if (job.can_improve !== true) return nothing;
  const held = session.work.unchecked;
  const locked = session.work.state.value.locks.size > 0;
  return html`<div class="improve">
    <sp-menu
      buttonClasses="btn fill"
      hint=${held ? "The change is checked first" : "Looks for a better build; the best is kept"}
      ?disabled=${held}
      .button=${html`${icon("improve")}Keep improving${icon("down")}`}
      .content=${() =>
        html`${times.map(
          ([seconds, text, more]) =>
            html`<button type="button" class="mi plain" role="menuitem" @click=${() => void startImproving(session, seconds)}>
              <span>${text}${more ? html`<span>${more}</span>` : nothing}</span>
            </button>`,
        )}
        ${locked ? html`<p class="menu-head small dim after">Locked copies may move: all orders are tried.</p>` : nothing}`}
    ></sp-menu>
  </div>`;
}
