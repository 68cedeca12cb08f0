/// A group that leaves as one: its copies, and how they are parted outside.

import { html, nothing, type TemplateResult } from "lit";
import { partColour } from "../../view/palette";
import { picture } from "../common/bits";
import { type PlanStep, partingSteps } from "../state/apart_plan";
import { playerOf } from "../state/apart_player";
import { app } from "../state/app_state";
import type { Session } from "../state/session";
import { count } from "../words/numbers";
import { type Apart, select } from "./apart";
import { moveWords, stepName } from "./sentences";

export function groupMembers(session: Session, apart: Apart, step: PlanStep): TemplateResult {
  const row = (placement: number) => {
    const part = apart.partOf(placement);
    const shot = part?.mesh ? session.meshes.picture(part.mesh, partColour(part.index), app.value.theme) : null;
    const name = apart.nameOf(placement);
    return html`<li class="li">
      <button
        type="button"
        class="whole"
        aria-label="Select ${name}"
        @click=${() => select(session, apart.tray.placements[placement] ?? null)}
      ></button>
      ${picture(shot)}<span class="cut">${name}</span>
    </li>`;
  };
  return html`<h2>Group of ${step.placements.length}</h2>
    <p class="small dim gap">These copies hold one another. They leave as one and are parted outside.</p>
    <ul class="flush gap">
      ${step.placements.map(row)}
    </ul>`;
}

export function groupParting(session: Session, apart: Apart, step: PlanStep): TemplateResult {
  const player = playerOf(session);
  const parting = step.makes === null ? [] : partingSteps(apart.plan, step.makes);
  return html`<section class="sec">
    <h3>Parted outside</h3>
    ${
      parting.length > 0
        ? html`<ol class="parting">
            ${parting.map(
              (own) =>
                html`<li>
                  <button type="button" class="link" @click=${() => player.seek(own.index)}>step ${count(own.index + 1)}</button>
                  ${stepName(apart, own)}${own.length > 0 ? html` ${moveWords(own)}` : nothing}
                </li>`,
            )}
          </ol>`
        : html`<p class="dim">The plan does not say how.</p>`
    }
    <button type="button" class="btn fill" @click=${() => player.playAlone(step.makes)}>Play the group alone</button>
  </section>`;
}
