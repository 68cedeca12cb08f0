/// Parts that are there and are not packed: left out by hand, or not named by the set file. They can be put back.

import { html, nothing, type TemplateResult } from "lit";
import type { Mesh } from "../../api/types";
import { picture } from "../common/bits";
import { app } from "../state/app_state";
import { addParts } from "../state/draft_edit";
import type { Session } from "../state/session";
import { leftOut, partOf } from "../state/take_in";
import { counted, size } from "../words/numbers";

const most = 50;
/// They have no colour of their own until they are packed.
const grey = "#9aa3af";

export function leftOutRows(session: Session): TemplateResult | typeof nothing {
  const meshes = session.parts.reading > 0 ? [] : leftOut(session.draft, session.parts.meshes);
  if (meshes.length === 0) return nothing;
  return html`<section class="left-out" aria-label="Left out">
    <div class="row between">
      <h3>Left out <span class="count">${counted(meshes.length, "part")}</span></h3>
      ${
        meshes.length > 1
          ? html`<button type="button" class="link small" @click=${() => putBack(session, meshes)}>Put all back</button>`
          : nothing
      }
    </div>
    ${meshes.slice(0, most).map(
      (mesh) =>
        html`<div class="li">
          ${picture(session.meshes.picture(mesh, grey, app.value.theme))}
          <div class="cut">${mesh.name} <span class="count">${size(mesh.size)}</span></div>
          <button type="button" class="link small" @click=${() => putBack(session, [mesh])}>Put back</button>
        </div>`,
    )}
    ${meshes.length > most ? html`<p class="small faint">${counted(meshes.length - most, "more part")}.</p>` : nothing}
  </section>`;
}

function putBack(session: Session, meshes: readonly Mesh[]): void {
  session.edit((draft) => {
    const taken = new Set(draft.parts.map((part) => part.key));
    return addParts(
      draft,
      meshes.map((mesh) => partOf(mesh, taken)),
    );
  });
}
