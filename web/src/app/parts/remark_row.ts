/// What there is to say about a part, below it, with what to do about it.

import { html, type TemplateResult } from "lit";
import { chooseFiles } from "../common/files_button";
import { icon } from "../common/icons";
import { changeParts, removeParts } from "../state/draft_edit";
import type { Remark, RemarkAction } from "../state/remarks";
import type { Session } from "../state/session";
import { nameOf, type Row } from "./rows";

const icons = { info: "info", warn: "warn", bad: "bad" } as const;

export function remarkRow(session: Session, row: Row, remark: Remark): TemplateResult {
  return html`<div class="remark ${remark.tone}" role="gridcell">
    ${icon(icons[remark.tone])}
    <span class="cut" title=${remark.text}>${remark.text}</span>
    ${remark.actions.map(
      (action) =>
        html`<button type="button" class="link" @click=${() => act(session, row, action)}>${action.text}</button>`,
    )}
  </div>`;
}

function act(session: Session, { part, mesh }: Row, action: RemarkAction): void {
  const only = new Set([part.key]);
  switch (action.do) {
    case "unit":
      session.edit((draft) => changeParts(draft, only, { unit: action.unit }));
      break;
    case "scale":
      session.edit((draft) => changeParts(draft, only, { scale: action.scale }));
      break;
    case "leave_out":
      session.editWithToast(`${nameOf(part, mesh)} is left out.`, (draft) => removeParts(draft, only));
      break;
    case "replace":
      chooseFiles(([picked]) => picked && session.replaceFile(part.file, picked.file), { several: false });
      break;
    case "repairs":
      session.view.set({ current: part.key });
      break;
  }
}
