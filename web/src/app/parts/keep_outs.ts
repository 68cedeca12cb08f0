/// Room that stays empty: boxes by two corners, or meshes.

import { html, nothing, type TemplateResult } from "lit";
import { iconButton } from "../common/bits";
import type { ValueEvent } from "../common/number_field";
import "../common/number_field";
import { holdsAllInOne, type KeepOut, type Sides } from "../state/draft";
import { addKeepOut } from "../state/draft_edit";
import type { Session } from "../state/session";
import { traySize } from "../state/tray_size";

export function keepOuts(session: Session): TemplateResult {
  const { draft } = session;
  const open = holdsAllInOne(draft);
  return html`<div class="field">
      <span class="dim">Keep-out zones</span>
      <button
        type="button"
        class="link"
        ?disabled=${open}
        title=${open ? "Not without a ceiling, nor for the least box" : "Room that stays empty"}
        @click=${() => session.edit((before) => addKeepOut(before, newBox(session)))}
      >
        Add
      </button>
    </div>
    ${draft.keepOut.map((keepOut, index) => zone(session, keepOut, index))}`;
}

/// A post in the corner, to be changed.
function newBox(session: Session): KeepOut {
  const [x, y, z] = traySize(session.draft, session.info, session.parts.meshes) ?? [100, 100, 100];
  return { box: [[0, 0, 0] as const, [Math.round(x / 10), Math.round(y / 10), z] as const] };
}

function zone(session: Session, keepOut: KeepOut, index: number): TemplateResult {
  const remove = () =>
    session.editWithToast("The keep-out zone is removed.", (before) => ({
      ...before,
      keepOut: before.keepOut.filter((_, other) => other !== index),
    }));
  return html`<div class="zone">
    <div class="row between">
      <span class="small dim">${"mesh" in keepOut ? keepOut.mesh : `Zone ${index + 1}: from, to (mm)`}</span>
      ${iconButton("close", `Remove keep-out zone ${index + 1}`, remove, "s")}
    </div>
    ${"box" in keepOut ? html`${corner(session, keepOut.box, index, 0)}${corner(session, keepOut.box, index, 1)}` : nothing}
  </div>`;
}

function corner(session: Session, box: readonly [Sides, Sides], index: number, which: 0 | 1): TemplateResult {
  const change = (axis: number, value: number | null) =>
    session.edit((before) => {
      const sides: [number, number, number] = [...box[which]];
      sides[axis] = value ?? 0;
      const next: readonly [Sides, Sides] = which === 0 ? [sides, box[1]] : [box[0], sides];
      return {
        ...before,
        keepOut: before.keepOut.map((own, other) => (other === index ? { box: next } : own)),
      };
    }, `zone ${index} ${which} ${axis}`);
  return html`<div class="thirds" role="group" aria-label=${which === 0 ? "From" : "To"}>
    ${(["X", "Y", "Z"] as const).map(
      (name, axis) =>
        html`<sp-number
          label=${`${which === 0 ? "From" : "To"} ${name}, mm`}
          classes="s third"
          .value=${box[which][axis] ?? 0}
          @value=${(event: ValueEvent) => change(axis, event.detail)}
        ></sp-number>`,
    )}
  </div>`;
}
