/// The trays of a build, as tabs: all side by side, or one.

import { html, nothing, type TemplateResult } from "lit";
import { resultUrl } from "../../api/client";
import { icon } from "../common/icons";
import type { Packing } from "../state/packing";
import type { Session } from "../state/session";
import { copies, percent } from "../words/numbers";
import { isNearlyEmpty } from "./result_notes";

/// `all`: with a tab for all of them side by side.
export function trayTabs(
  session: Session,
  packing: Packing,
  tray: number,
  all = true,
): TemplateResult | typeof nothing {
  if (packing.trays.length < 2) return nothing;
  const tab = (number: number, content: TemplateResult) =>
    html`<button
      type="button"
      class="tt ${number === tray ? "on" : ""}"
      role="tab"
      aria-selected=${number === tray}
      tabindex=${number === tray ? 0 : -1}
      @click=${() => openTray(session, number)}
    >
      ${content}
    </button>`;
  return html`<nav class="tstrip" aria-label="Trays"><div class="tabs-row" role="tablist" @keydown=${(event: KeyboardEvent) => key(event)}>
    ${all ? tab(0, html`<span class="alone"><b>All trays</b><small>${copies(packing.placed)}</small></span>`) : nothing}
    ${packing.trays.map((own) =>
      tab(
        own.number,
        html`<img src=${resultUrl(session.id, "png", own.number)} alt="" loading="lazy" />
          <span>
            <b>Tray ${own.number}</b>
            <small
              >${percent(own.density)}${
                isNearlyEmpty(packing, own.number)
                  ? html` <span class="warn-text" title="Nearly empty">${icon("warn")}</span>`
                  : nothing
              }</small
            >
          </span>`,
      ),
    )}
  </div></nav>`;
}

export function openTray(session: Session, tray: number): void {
  session.build.set({ tray, follow: false, selected: [], find: null });
}

function key(event: KeyboardEvent): void {
  const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
  if (by === 0) return;
  const tabs = [...(event.currentTarget as HTMLElement).querySelectorAll<HTMLElement>("[role=tab]")];
  const at = tabs.indexOf(document.activeElement as HTMLElement);
  const next = tabs[(at + by + tabs.length) % tabs.length];
  event.preventDefault();
  event.stopPropagation();
  next?.focus();
  next?.click();
}
