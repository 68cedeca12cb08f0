/// A copy that is moved by hand: its place in numbers, turns, what is near, and whether it may stay there.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, property } from "lit/decorators.js";
import { partColour } from "../../view/palette";
import type { Axis } from "../../view/view";
import { picture } from "../common/bits";
import { icon, spinner } from "../common/icons";
import type { ValueEvent } from "../common/number_field";
import "../common/number_field";
import { Piece } from "../common/piece";
import { app } from "../state/app_state";
import type { Packing } from "../state/packing";
import type { Session } from "../state/session";
import { standsWords } from "../state/turns";
import { judged, movedBy, touched } from "../words/move";
import { mm } from "../words/numbers";
import type { BuildPart } from "./build_parts";

const axes: readonly Axis[] = ["x", "y", "z"];

@customElement("sp-move")
export class MovePanel extends Piece {
  @property({ attribute: false }) session!: Session;
  @property({ attribute: false }) packing!: Packing;
  @property({ attribute: false }) parts: readonly BuildPart[] = [];

  protected override stores() {
    const { session } = this;
    return [session.work.move.state, session.run.state, session.meshes.state, app];
  }

  private get move() {
    return this.session.work.move;
  }

  override render() {
    const { copy } = this.move.state.value;
    if (!copy) return nothing;
    return html`<div class="head">
        <h2 class="grow">${this.move.state.value.from ? "Move" : "Put back"}</h2>
        <span class="count">Esc ${this.move.state.value.from ? "puts it back" : "leaves it out"}</span>
      </div>
      <div class="scroll">
        <section class="sec">${this.heading()}${this.place()}${this.turns()}</section>
        <section class="sec stack">${this.judgement()}${this.near()}${this.back()}</section>
        <section class="sec">${this.end()}</section>
      </div>`;
  }

  private heading(): TemplateResult | typeof nothing {
    const { copy } = this.move.state.value;
    const part = this.parts.find((own) => own.index === copy?.part);
    if (!copy || !part) return nothing;
    const shot = part.mesh ? this.session.meshes.picture(part.mesh, partColour(part.index), app.value.theme) : null;
    return html`<div class="row">
      ${picture(shot, "th large")}
      <div class="grow cut">
        <h3 class="cut large-name">${part.name} ${copy.copy + 1}</h3>
        <div class="small dim cut">copy ${copy.copy + 1} of ${part.count}</div>
      </div>
    </div>`;
  }

  /// The lower corner of its box, and how far it is from where it stood.
  private place(): TemplateResult {
    const { transform, from, seeking } = this.move.state.value;
    const low = this.move.extent(transform)?.low;
    const before = from && this.move.extent(from)?.low;
    const field = (axis: Axis, i: 0 | 1 | 2) => {
      const at = low?.[i] ?? 0;
      const by: [number, number, number] = [0, 0, 0];
      return html`<span class="axis">${axis.toUpperCase()}</span>
        <sp-number
          label=${`Place along ${axis.toUpperCase()}`}
          unit="mm"
          classes="third"
          .value=${Number(at.toFixed(1))}
          .places=${1}
          .digits=${1}
          ?disabled=${seeking}
          @value=${(event: ValueEvent) => {
            by[i] = (event.detail ?? at) - at;
            this.move.shift(by);
          }}
        ></sp-number>
        <span class="dim num">${before ? movedBy(at - (before[i] ?? 0)) : ""}</span>`;
    };
    return html`<div class="places">${axes.map((axis, i) => field(axis, i as 0 | 1 | 2))}</div>`;
  }

  private turns(): TemplateResult {
    const { transform, seeking } = this.move.state.value;
    return html`<div class="row between turns">
        <span class="dim">Turn</span>
        <div class="seg s" role="group" aria-label="Turn">
          ${axes.map(
            (axis) =>
              html`<button
                type="button"
                ?disabled=${seeking}
                title="Turn by 90° about ${axis.toUpperCase()}"
                @click=${() => this.move.turn(axis)}
              >
                ${axis.toUpperCase()} 90°
              </button>`,
          )}
        </div>
      </div>
      <p class="small faint stands">${standsWords(transform)}</p>`;
  }

  private judgement(): TemplateResult {
    const { clearance, touching, outside, wait, seeking } = this.move.state.value;
    const name = (copy: { part: number; copy: number }) => this.move.nameOf(copy);
    if (seeking) return note("info", spinner, "Looking for the nearest free place", "");
    if (clearance) {
      const { tone, bold, text } = judged(clearance, name);
      return note(tone, icon(tone === "ok" ? "check" : "bad"), bold, text);
    }
    if (outside || touching.length > 0) {
      const { bold, text } = touched(touching, name, outside);
      return note("bad", icon("bad"), bold, wait ?? text);
    }
    return wait ? note("warn", icon("warn"), "Not measured.", wait) : note("info", spinner, "Measuring the gaps", "");
  }

  private near(): TemplateResult {
    const { clearance } = this.move.state.value;
    const { nearest, next, wall } = clearance ?? {};
    const value = (own: { distance: number; gap: number } | null | undefined, text: string) => {
      if (!clearance) return html`<dd class="faint">…</dd>`;
      if (!own) return html`<dd>none</dd>`;
      return html`<dd class=${own.distance < own.gap ? "bad-text b" : ""}>${text} · ${near(own.distance)}</dd>`;
    };
    return html`<dl class="kv">
      <dt>Nearest copy</dt>
      ${value(nearest, nearest ? this.move.nameOf(nearest) : "")}
      <dt>Next</dt>
      ${value(next, next ? this.move.nameOf(next) : "")}
      <dt>Nearest wall</dt>
      ${value(wall, wall?.side ?? "")}
    </dl>`;
  }

  private back(): TemplateResult {
    const { clearance, touching, outside, seeking, from } = this.move.state.value;
    const wrong = clearance ? !clearance.clear : touching.length > 0 || outside;
    return html`<button
      type="button"
      class="btn fill"
      ?disabled=${!wrong || seeking}
      @click=${() => void this.move.seek()}
    >
      ${seeking ? spinner : nothing}${from ? "Back to" : "To"} the nearest free place
    </button>`;
  }

  private end(): TemplateResult {
    const { clearance, placing, from } = this.move.state.value;
    const may = clearance?.clear === true && this.move.moved;
    return html`<div class="halves">
        <button
          type="button"
          class="btn ${may ? "primary" : ""}"
          ?disabled=${!may}
          title="Place here (Enter)"
          @click=${() => this.move.place()}
        >
          ${placing ? spinner : nothing}Place here
        </button>
        <button type="button" class="btn" title="Put back (Esc)" @click=${() => this.move.end()}>
          ${from ? "Put back" : "Leave it out"}
        </button>
      </div>
      <p class="small faint after">After a change the build is checked again before it can be exported.</p>`;
  }
}

const near = (distance: number): string => (distance < 0 ? `${mm(-distance, 1)} outside` : mm(distance, 1));

function note(tone: string, sign: TemplateResult, bold: string, text: string): TemplateResult {
  return html`<div class="note ${tone}" role="status">${sign}<p><b>${bold}</b> ${text}</p></div>`;
}
