/// All trays side by side: what each looks like and holds, and where each part went.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { resultUrl } from "../../api/client";
import { partColour } from "../../view/palette";
import { bar, picture } from "../common/bits";
import { icon } from "../common/icons";
import { Piece } from "../common/piece";
import { styles } from "../common/styles";
import { app } from "../state/app_state";
import type { PackedTray, Packing } from "../state/packing";
import type { Session } from "../state/session";
import { copies, counted, percent } from "../words/numbers";
import { type BuildPart, placedCounts } from "./build_parts";
import { isNearlyEmpty } from "./result_notes";
import { openTray } from "./tray_tabs";

const few = 40;

@customElement("sp-trays")
export class TraysOverview extends Piece {
  @property({ attribute: false }) session!: Session;
  @property({ attribute: false }) packing!: Packing;
  @property({ attribute: false }) parts: readonly BuildPart[] = [];
  @state() private all = false;

  protected override stores() {
    return [this.session.run.state, this.session.meshes.state, app];
  }

  override render() {
    const { packing } = this;
    const fullest = Math.max(...packing.trays.map((tray) => tray.density), 1e-9);
    return html`<section class="trays" aria-label="All trays">
      <div class="tgrid">${packing.trays.map((tray) => this.card(tray, fullest))}</div>
      ${this.table()}
    </section>`;
  }

  private card(tray: PackedTray, fullest: number): TemplateResult {
    const apart = this.session.job.verdict?.apart === "checked" && tray.complete;
    const empty = isNearlyEmpty(this.packing, tray.number);
    const [x, y, z] = this.packing.size;
    return html`<article class="card tcard ${z >= Math.max(x, y) ? "tall" : ""}">
      <button
        type="button"
        class="whole"
        aria-label="Open tray ${tray.number}"
        @click=${() => openTray(this.session, tray.number)}
      ></button>
      <div class="view"><img src=${resultUrl(this.session.id, "png", tray.number)} alt="Tray ${tray.number}" loading="lazy" /></div>
      <div class="bd">
        <div class="row between">
          <h2>Tray ${tray.number}</h2>
          ${
            empty
              ? html`<span class="row small b warn-text">${icon("warn")}Nearly empty</span>`
              : apart
                ? html`<span class="ok-text" role="img" aria-label="Comes apart: checked" title="Comes apart: checked"
                    >${icon("check")}</span
                  >`
                : nothing
          }
        </div>
        <div class="row between">
          <span class="dim">${copies(tray.placements.length)}</span><b>${percent(tray.density)}</b>
        </div>
        ${bar(tray.density / fullest)}
      </div>
    </article>`;
  }

  private table(): TemplateResult {
    const { trays } = this.packing;
    const counts = trays.map((tray) => placedCounts([tray]));
    const shown = this.all ? this.parts : this.parts.slice(0, few);
    const share = (number: number, part: BuildPart) =>
      `color-mix(in srgb, var(--accent) ${Math.round(4 + (32 * number) / Math.max(1, part.count))}%, transparent)`;
    return html`<div class="card wide-table">
      <table class="mx">
        <thead>
          <tr>
            <th scope="col">Where each part went</th>
            ${trays.map((tray) => html`<th scope="col">Tray ${tray.number}</th>`)}
            <th scope="col">Left over</th>
            <th scope="col">Total</th>
          </tr>
        </thead>
        <tbody>
          ${shown.map((part) => {
            const own = counts.map((map) => map.get(part.index) ?? 0);
            const left = part.count - own.reduce((sum, number) => sum + number, 0);
            return html`<tr>
              <th scope="row">
                <span class="row">
                  ${picture(
                    part.mesh ? this.session.meshes.picture(part.mesh, partColour(part.index), app.value.theme) : null,
                    "th small-th",
                  )}<span class="cut">${part.name}</span>
                </span>
              </th>
              ${own.map(
                (number) =>
                  html`<td>
                    ${
                      number > 0
                        ? html`<span class="share" ${styles({ background: share(number, part) })}>${number}</span>`
                        : html`<span class="faint">·</span>`
                    }
                  </td>`,
              )}
              <td>${left > 0 ? html`<span class="warn-text">${left}</span>` : html`<span class="faint">·</span>`}</td>
              <td class="b">${part.count}</td>
            </tr>`;
          })}
        </tbody>
      </table>
      ${
        shown.length < this.parts.length
          ? html`<button
              type="button"
              class="link more"
              @click=${() => {
                this.all = true;
              }}
            >
              ${counted(this.parts.length - shown.length, "more part")}
            </button>`
          : nothing
      }
    </div>`;
  }
}
