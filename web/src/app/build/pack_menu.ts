/// Pack again: all of it, the rest round what is locked, or only what is missing.

import { html, type TemplateResult } from "lit";
import { type IconName, icon } from "../common/icons";
import { totalCopies } from "../state/draft";
import type { Session } from "../state/session";
import { copies } from "../words/numbers";

/// Copies that the parts list asks for and that stand nowhere.
export function missingCopies(session: Session): number {
  const { packing } = session.run.state.value;
  return packing ? Math.max(0, totalCopies(session.draft) - packing.placed) : 0;
}

export function packEntries(session: Session): TemplateResult {
  const locked = session.work.state.value.locks.size;
  const missing = missingCopies(session);
  return html`${item(
    "any",
    "Pack all again",
    locked > 0 ? "locks are given up" : "as the parts list has it",
    false,
    () => session.pack("none"),
  )}
    ${item(
      "lock",
      locked > 0 ? `Keep locked copies (${locked}) and pack the rest` : "Keep locked copies and pack the rest",
      locked > 0 ? "they stay where they are" : "lock some first: select them and press L",
      locked === 0,
      () => session.pack("locked"),
    )}
    ${item(
      "add",
      "Keep all, add what is missing",
      missing > 0 ? `${copies(missing)} more, in the room that is left` : "nothing is missing",
      missing === 0,
      () => session.pack("all"),
    )}`;
}

function item(name: IconName, text: string, what: string, off: boolean, run: () => Promise<void>): TemplateResult {
  return html`<button type="button" class="mi" role="menuitem" ?disabled=${off} @click=${() => void run()}>
    ${icon(name)}<span>${text}<span>${what}</span></span>
  </button>`;
}

export function packAgainMenu(session: Session): TemplateResult {
  const checking = session.work.unchecked;
  return html`<sp-menu
    class="pack-again"
    buttonClasses="btn s"
    menuClasses="wide"
    hint=${checking ? "The change is checked first" : "Pack again (Ctrl+Enter)"}
    ?disabled=${checking}
    .button=${html`Pack again${icon("down")}`}
    .content=${() => packEntries(session)}
  ></sp-menu>`;
}
