/// Undo and redo, of the parts or of the build.

import { html, type TemplateResult } from "lit";
import { type IconName, icon } from "../common/icons";
import type { Step } from "../state/route";
import type { Session } from "../state/session";

export function undoButtons(session: Session, step: Step): TemplateResult {
  const { work } = session;
  const build = step === "build";
  const open = !session.locked;
  const canUndo = build ? work.canUndo : session.state.value.canUndo && open;
  const canRedo = build ? work.canRedo : session.state.value.canRedo && open;
  return html`${button("undo", "Undo (Ctrl+Z)", canUndo, () => (build ? void work.undo() : session.undo()))}
    ${button("redo", "Redo (Ctrl+Shift+Z)", canRedo, () => (build ? void work.redo() : session.redo()))}
    <span class="rule"></span>`;
}

function button(name: IconName, text: string, can: boolean, run: () => void): TemplateResult {
  return html`<button type="button" class="btn ghost icon" aria-label=${text} title=${text} ?disabled=${!can} @click=${run}>
    ${icon(name)}
  </button>`;
}
