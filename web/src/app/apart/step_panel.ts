/// The step that runs: what leaves, how it goes, and whether the check says that its way is clear; below it the selected
/// copy, and what the player is to do.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, property } from "lit/decorators.js";
import { partColour } from "../../view/palette";
import { picture, toggle } from "../common/bits";
import { icon } from "../common/icons";
import { Piece } from "../common/piece";
import { leftAfter, type PlanStep } from "../state/apart_plan";
import { playerOf } from "../state/apart_player";
import { app } from "../state/app_state";
import type { Session } from "../state/session";
import { copies, count } from "../words/numbers";
import { type Apart, selectedIn } from "./apart";
import { groupMembers, groupParting } from "./group_panel";
import "./now_at";
import { selectedWay } from "./selected_way";
import { endSentence, moveWords } from "./sentences";
import { incomplete } from "./staying_note";

@customElement("sp-step")
export class StepPanel extends Piece {
  @property({ attribute: false }) session!: Session;
  @property({ attribute: false }) apart!: Apart;

  private get player() {
    return playerOf(this.session);
  }

  protected override stores() {
    const { session } = this;
    return [session.run.state, session.build, session.meshes.state, this.player.state, this.apart.ways.state, app];
  }

  override render() {
    const { session, apart } = this;
    const { step } = this.player.state.value;
    const { plan } = apart;
    const own = plan.steps[step];
    const selected = selectedIn(session, apart.tray);
    const left = leftAfter(plan, own ? own.index : plan.steps.length);
    return html`<div class="head">
        <h2 class="grow nw">${own ? `Step ${count(step + 1)}` : "Done"}</h2>
        <span class="count">${own ? `${copies(left)} after it` : ""}</span>
      </div>
      <div class="scroll">
        ${own ? this.step(own) : this.end()} ${own?.makes != null ? groupParting(session, apart, own) : nothing}
        ${selected ? selectedWay(session, apart, selected) : this.hint()} ${incomplete(apart)}
      </div>
      ${this.options()}`;
  }

  private step(own: PlanStep): TemplateResult {
    return html`<section class="sec">
      ${own.makes === null ? this.one(own) : groupMembers(this.session, this.apart, own)}
      <dl class="kv">
        <dt>Moves</dt>
        <dd>${moveWords(own)}</dd>
        ${
          own.length > 0
            ? html`<dt>Now at</dt>
                <dd><sp-now-at .player=${this.player} .step=${own}></sp-now-at></dd>`
            : nothing
        }
        <dt>Way is clear</dt>
        <dd>${this.clear()}</dd>
      </dl>
      ${
        own.throughWalls
          ? html`<div class="note warn">
              ${icon("warn")}
              <p>This step leads through the walls of the tray. Open the tray at that side for it.</p>
            </div>`
          : nothing
      }
    </section>`;
  }

  private one(own: PlanStep): TemplateResult {
    const { session, apart } = this;
    const placement = own.placements[0] ?? -1;
    const part = apart.partOf(placement);
    const shot = part?.mesh ? session.meshes.picture(part.mesh, partColour(part.index), app.value.theme) : null;
    const group = apart.plan.assemblies[own.from];
    const from = group && group.madeBy >= 0 ? `parted outside from a group of ${group.members.length}` : "";
    return html`<div class="row gap">
      ${picture(shot, "th large")}
      <div class="grow cut">
        <h2 class="cut" title=${apart.nameOf(placement)}>${apart.nameOf(placement)}</h2>
        <div class="small dim">${from || "leaves on its own"}</div>
      </div>
    </div>`;
  }

  /// Only the independent check says so; while it has not, nothing is claimed.
  private clear(): TemplateResult {
    const { verdict } = this.session.job;
    if (verdict?.apart === "checked" && verdict.ok) return html`<span class="ok-text">checked</span>`;
    if (verdict?.apart === "checked")
      return html`<span class="warn-text">checked, but the check found other faults</span>`;
    if (verdict?.apart === "no") return html`<span class="bad-text">no: the check found the plan wrong</span>`;
    return html`<span class="warn-text">not checked yet</span>`;
  }

  private end(): TemplateResult {
    return html`<section class="sec">
      <h2>${endSentence(this.apart)}</h2>
      <p class="dim">
        ${count(this.apart.plan.steps.length)} steps, each one after the other. Play starts again at the first.
      </p>
    </section>`;
  }

  private hint(): TemplateResult | typeof nothing {
    // Of an empty tray there is nothing to click.
    if (this.player.state.value.step >= this.apart.plan.steps.length && this.apart.plan.staying.length === 0)
      return nothing;
    return html`<section class="sec">
      <p class="dim">Click a copy in the tray to see when it leaves, and what is in its way.</p>
    </section>`;
  }

  private options(): TemplateResult {
    const { player } = this;
    const { follow, faint } = player.state.value;
    const row = (text: string, on: boolean, change: (on: boolean) => void) =>
      html`<div class="field"><span class="dim">${text}</span>${toggle(text, on, change)}</div>`;
    return html`<section class="sec bottom">
      ${row("Follow with the camera", follow, (on) => player.setFollow(on))}
      ${row("Keep copies that left, faint", faint, (on) => player.setFaint(on))}
    </section>`;
  }
}
