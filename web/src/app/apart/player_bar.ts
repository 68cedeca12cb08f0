/// The player: play and pause, step by step, the timeline, and the speed.

import { html, type TemplateResult } from "lit";
import { customElement, property } from "lit/decorators.js";
import { iconButton, select } from "../common/bits";
import { icon } from "../common/icons";
import { Piece } from "../common/piece";
import { playerOf, speeds } from "../state/apart_player";
import type { Session } from "../state/session";
import { count } from "../words/numbers";
import type { Apart } from "./apart";
import "./timeline";

@customElement("sp-player")
export class PlayerBar extends Piece {
  @property({ attribute: false }) session!: Session;
  @property({ attribute: false }) apart!: Apart;

  private get player() {
    return playerOf(this.session);
  }

  protected override stores() {
    return [this.player.state];
  }

  override render(): TemplateResult {
    const { player, apart } = this;
    const { step, playing, speed } = player.state.value;
    const { length } = apart.plan.steps;
    const play = playing ? "Pause (Space)" : "Play (Space)";
    return html`<footer class="dock player" aria-label="Player">
      <div class="row controls">
        ${iconButton("first", "To the start (Home)", () => player.seek(0))}
        ${iconButton("stepBack", "Step back (←)", () => player.move(-1))}
        <button type="button" class="play" aria-label=${play} title=${play} @click=${() => player.toggle()}>
          ${icon(playing ? "pause" : "play")}
        </button>
        ${iconButton("stepOn", "Step on (→)", () => player.move(1))}
        ${iconButton("last", "To the end (End)", () => player.seek(length))}
      </div>
      <sp-timeline .player=${player} .apart=${apart}></sp-timeline>
      <div class="row count-speed">
        <div class="num">
          <b>${count(Math.min(step + 1, length))}</b> <span class="dim">of ${count(length)}</span>
          <div class="small faint hide-s">bar height: distance</div>
        </div>
        ${select(
          "Speed",
          speeds.map((own) => ({ value: String(own), text: `${own}×` })),
          String(speed),
          (value) => player.setSpeed(Number(value)),
          "s",
        )}
      </div>
    </footer>`;
  }
}
