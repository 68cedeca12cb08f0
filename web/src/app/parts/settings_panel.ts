/// How the parts are to be packed: tray, gap, goal, time, material, and everything else under Advanced.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, property } from "lit/decorators.js";
import { checkBox, segments } from "../common/bits";
import type { ValueEvent } from "../common/number_field";
import "../common/number_field";
import { Piece } from "../common/piece";
import { app } from "../state/app_state";
import { canSeekBox, type Draft, type Goal } from "../state/draft";
import { setOption } from "../state/draft_edit";
import type { Session } from "../state/session";
import { gapOf, printerOf, wallGapOf } from "../state/tray_size";
import { mm } from "../words/numbers";
import "./advanced";
import { keepOuts } from "./keep_outs";
import { trayFields } from "./tray_fields";

const goals: Readonly<Record<Goal, string>> = {
  lowest: "Places every copy as low as it goes, so the print is short.",
  fill: "Fills each tray as densely as it goes before the next; the last is packed low.",
  box: "Seeks the smallest box that holds all copies, on a base up to the tray’s.",
};

@customElement("sp-settings")
export class SettingsPanel extends Piece {
  @property({ attribute: false }) session!: Session;

  protected override stores() {
    return [this.session.state, this.session.source.state, app];
  }

  override render() {
    const { session } = this;
    return html`<div class="head"><h2 class="grow">Build settings</h2></div>
      <div class="scroll">
        <section class="sec stack">
          <h3>Tray</h3>
          ${trayFields(session)} ${keepOuts(session)}
        </section>
        ${this.gaps()}${this.goal()}${this.time()}${this.material()}
        <sp-advanced .session=${session}></sp-advanced>
      </div>`;
  }

  private edit(change: Partial<Draft>, tag = ""): void {
    this.session.edit((draft) => ({ ...draft, ...change }), tag);
  }

  private gaps(): TemplateResult {
    const { draft, info } = this.session;
    const printer = printerOf(draft, info);
    const usual = (own: number | null, printers: number | undefined, back: Partial<Draft>) =>
      own !== null && printers !== undefined && own !== printers
        ? html`<span class="hint"
            >The printer’s usual is ${mm(printers)}.
            <button type="button" class="link" @click=${() => this.edit(back)}>Use it</button></span
          >`
        : nothing;
    return html`<section class="sec stack">
      <h3>Gap</h3>
      <div class="field">
        <span class="dim">Between copies</span>
        <sp-number
          label="Gap between copies"
          unit="mm"
          .value=${gapOf(draft, info)}
          .least=${0}
          .step=${0.5}
          .places=${1}
          @value=${(event: ValueEvent) => this.edit({ gap: event.detail }, "gap")}
        ></sp-number>
        ${usual(draft.gap, printer?.gap, { gap: null })}
      </div>
      <div class="field">
        <span class="dim">To the walls</span>
        <sp-number
          label="Gap to the walls"
          unit="mm"
          .value=${wallGapOf(draft, info)}
          .least=${0}
          .step=${0.5}
          .places=${1}
          @value=${(event: ValueEvent) => this.edit({ wallGap: event.detail }, "wall gap")}
        ></sp-number>
        ${usual(draft.wallGap, printer?.wall_gap, { wallGap: null })}
      </div>
    </section>`;
  }

  private goal(): TemplateResult {
    const { draft } = this.session;
    const box = canSeekBox(draft);
    return html`<section class="sec stack">
      <h3>Goal</h3>
      ${segments<Goal>(
        "Goal",
        [
          { value: "lowest", text: "Lowest" },
          { value: "fill", text: "Fill tray" },
          {
            value: "box",
            text: "Least box",
            disabled: !box,
            ...(box ? {} : { title: "Not with a mesh to fill, nor with keep-out zones" }),
          },
        ],
        draft.goal,
        (goal) => this.edit({ goal }),
      )}
      <p class="faint small">${goals[draft.goal]}</p>
    </section>`;
  }

  private time(): TemplateResult {
    const { draft, info } = this.session;
    const most = info.limits.time_limit;
    const rest = draft.options.improve === "rest";
    return html`<section class="sec stack">
      <div class="field">
        <span class="b">Time limit</span>
        <sp-number
          label="Time limit, minutes"
          unit="min"
          optional
          placeholder="none"
          .value=${draft.timeLimit === null ? null : draft.timeLimit / 60}
          .least=${0}
          above
          .most=${most === null ? Number.POSITIVE_INFINITY : most / 60}
          @value=${(event: ValueEvent) =>
            this.edit({ timeLimit: event.detail === null ? null : event.detail * 60 }, "time limit")}
        ></sp-number>
      </div>
      ${
        draft.timeLimit === null
          ? html`<p class="faint small">Packs until it is done. With a limit, the best packing by then is kept.</p>`
          : html`<label class="row">
                ${checkBox("Use all of the time to pack better", rest, (on) =>
                  this.session.edit((before) => setOption(before, "improve", on ? "rest" : undefined)),
                )}
                <span>Use all of it to pack better</span>
              </label>
              <p class="faint small">The best packing so far is kept.</p>`
      }
    </section>`;
  }

  private material(): TemplateResult {
    const { draft, info } = this.session;
    const density = draft.options["material-density"];
    const dense = info.options.some((option) => option.name === "material-density" && option.here);
    return html`<section class="sec stack">
      <h3>Material</h3>
      <label class="field">
        <span class="dim">Name</span>
        <span class="in n wider"
          ><input
            type="text"
            maxlength="100"
            aria-label="Material"
            placeholder="PA 12"
            .value=${draft.material}
            @change=${(event: Event) => this.edit({ material: (event.target as HTMLInputElement).value.trim() })}
        /></span>
      </label>
      ${
        dense
          ? html`<div class="field">
              <span class="dim">Density</span>
              <sp-number
                label="Density of the material, g/cm³"
                unit="g/cm³"
                classes="n wider"
                optional
                .value=${typeof density === "number" ? density : null}
                .least=${0}
                above
                .step=${0.01}
                .digits=${3}
                @value=${(event: ValueEvent) =>
                  this.session.edit(
                    (before) => setOption(before, "material-density", event.detail ?? undefined),
                    "density",
                  )}
              ></sp-number>
              <span class="hint">The report then has masses.</span>
            </div>`
          : nothing
      }
    </section>`;
  }
}
