/// How far what moves has gone: the one figure of the panel that changes with every frame.

import { html } from "lit";
import { customElement, property } from "lit/decorators.js";
import { Piece } from "../common/piece";
import type { PlanStep } from "../state/apart_plan";
import type { Player } from "../state/apart_player";
import { distanceAt } from "../state/apart_time";
import { lengthWords } from "../words/moves";

@customElement("sp-now-at")
export class NowAt extends Piece {
  @property({ attribute: false }) player!: Player;
  @property({ attribute: false }) step!: PlanStep;

  protected override stores() {
    return [this.player.clock];
  }

  override render() {
    const share = this.player.time - this.step.index;
    const gone = share >= 1 ? this.step.length : distanceAt(this.step, share);
    return html`${lengthWords(gone)}`;
  }
}
