/// A run as it goes on: figures, what happens now, what was said, and stop.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, property } from "lit/decorators.js";
import { bar, figure } from "../common/bits";
import { icon, spinner } from "../common/icons";
import { Piece } from "../common/piece";
import { app } from "../state/app_state";
import { holdsAllInOne, totalCopies } from "../state/draft";
import { isRunning } from "../state/runner";
import type { Session } from "../state/session";
import { traySize } from "../state/tray_size";
import { gainWords } from "../words/improve";
import { news } from "../words/news";
import { count, counted } from "../words/numbers";
import { phaseRows } from "../words/phases";
import { clock, duration } from "../words/times";
import { curveFigure } from "./curve_figure";
import type { LiveFigures } from "./live_figures";

@customElement("sp-packing")
export class PackingPanel extends Piece {
  @property({ attribute: false }) session!: Session;
  @property({ attribute: false }) figures!: LiveFigures;
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
    const { job, since } = this.session.run.state.value;
    if (job.status === "queued") return this.queued();
    const elapsed = since > 0 ? (Date.now() - since) / 1000 : 0;
    return html`<div class="head">
        <h2 class="grow">Packing</h2>
        <span class="count">${clock(Math.max(elapsed, this.heard()))} so far</span>
      </div>
      <div class="scroll">
        <section class="sec">${this.numbers()}</section>
        <section class="sec">${this.phases()}</section>
        ${this.improving()} ${this.said()}
      </div>
      ${this.stop("Stop and keep the best so far")}`;
  }

  private queued(): TemplateResult {
    const place = this.session.job.queue_place;
    return html`<div class="head"><h2 class="grow">Waiting</h2></div>
      <div class="scroll">
        <section class="sec">
          <p>
            ${place ? html`<b>Place ${place} in the queue.</b>` : html`<b>In the queue.</b>`} It begins as soon as the
            jobs before it are done.
          </p>
        </section>
      </div>
      ${this.stop("Take it out of the queue")}`;
  }

  /// Seconds that the run told of, of a page that came later.
  private heard(): number {
    return Math.max(0, ...this.session.run.live.seconds.values());
  }

  private numbers(): TemplateResult {
    const { draft, info, parts, run } = this.session;
    const { progress } = run.live;
    const total = Math.max(totalCopies(draft), progress?.phase === "search" ? progress.total : 0);
    const { standing, density, height } = this.figures;
    const left = progress?.left ?? null;
    const tray = traySize(draft, info, parts.meshes);
    const several = run.live.trays.size > 1;
    return html`<div class="fig">
        ${figure(count(standing), `of ${count(total)}`, "placed")}
        ${
          left === null
            ? figure("–", "", "time left")
            : figure(clock(left), "left", `of about ${clock(left + (progress?.seconds ?? 0))}`)
        }
        ${figure((density * 100).toFixed(1), "%", several ? "of this tray filled" : "of the tray filled")}
        ${figure(
          height.toFixed(0),
          "mm",
          tray && !draft.openHeight && !holdsAllInOne(draft) ? `height of ${tray[2].toFixed(0)}` : "height",
        )}
      </div>
      ${bar(total > 0 ? standing / total : 0, "Copies placed", "thick")}`;
  }

  private phases(): TemplateResult {
    const { draft, run } = this.session;
    const { live } = run;
    const now = live.progress?.phase ?? null;
    const rows = phaseRows(live.phases, now, draft.parts.length);
    return html`<h3>What happens now</h3>
      <div class="checks">
        ${rows.map((row) => {
          const took = live.seconds.get(row.phase);
          const progress = live.progress;
          if (row.state === "now") {
            return html`<div class="now" aria-current="step">
              <span class="dot"></span><span>${row.text}</span>
              <span>${progress && progress.total > 1 ? count(progress.done) : ""}</span>
            </div>`;
          }
          return html`<div class=${row.state}>
            ${row.state === "done" ? icon("check") : html`<span></span>`}<span>${row.text}</span>
            <span class="faint">${row.state === "done" && took !== undefined && took >= 0.05 ? duration(took) : ""}</span>
          </div>`;
        })}
      </div>
      ${this.orders()}`;
  }

  private orders(): TemplateResult | typeof nothing {
    const progress = this.session.run.live.progress;
    if (!progress?.orders) return nothing;
    return html`<p class="small faint">Order ${progress.order ?? 1} of ${counted(progress.orders, "order")} tried.</p>`;
  }

  private improving(): TemplateResult | typeof nothing {
    const { curve } = this.session.run.live;
    if (!curve.isThere) return nothing;
    return html`<section class="sec">
      <h3>${gainWords(curve.what, curve.before, curve.now) ?? "Nothing better yet"}</h3>
      ${curveFigure(curve)}
    </section>`;
  }

  private said(): TemplateResult | typeof nothing {
    const remarks = news(this.session.run.live.remarks);
    if (remarks.length === 0) return nothing;
    return html`<section class="sec">
      <h3>Set aside and remarked</h3>
      <ul class="said">
        ${remarks.map((text) => html`<li>${text}</li>`)}
      </ul>
    </section>`;
  }

  private stop(text: string): TemplateResult | typeof nothing {
    const { job, stopping: asked } = this.session.run.state.value;
    const stopping = asked || job.stopping === true;
    if (!isRunning(job)) return nothing;
    return html`<section class="sec bottom">
      <button
        type="button"
        class="btn l fill"
        ?disabled=${stopping}
        @click=${() => this.session.stop()}
      >
        ${stopping ? spinner : icon("stop")}${stopping ? "Stopping" : text}
      </button>
      <p class="small faint">
        ${stopping ? "What stands is taken apart and checked." : "Closing this page does not stop the job."}
      </p>
    </section>`;
  }
}
