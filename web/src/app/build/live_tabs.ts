/// The trays of a run, as tabs: which are done, and which one is filled.

import { html, type TemplateResult } from "lit";
import { icon, spinner } from "../common/icons";
import type { Session } from "../state/session";
import { copies } from "../words/numbers";

export function liveTabs(session: Session, tray: number): TemplateResult {
  const { live } = session.run;
  return html`<nav class="tstrip" aria-label="Trays"><div class="tabs-row" role="tablist">
    ${[...live.trays.values()].map(
      (own) =>
        html`<button
          type="button"
          class="tt plain ${own.number === tray ? "on" : ""}"
          role="tab"
          aria-selected=${own.number === tray}
          @click=${() => session.build.set({ tray: own.number, follow: own.number === live.current })}
        >
          ${own.finished ? html`<span class="ok-text">${icon("check")}</span>` : spinner}
          <span><b>Tray ${own.number}</b><small>${copies(own.copies.size)}</small></span>
        </button>`,
    )}
  </div></nav>`;
}
