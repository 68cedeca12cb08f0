/// Locks in the list of parts: how many copies of a part are locked, and menus to lock all of a part or of a tray.

import { html, nothing, type TemplateResult } from "lit";
import { trayCopyId } from "../change/change";
import { copiesOf } from "../change/locks";
import { type IconName, icon } from "../common/icons";
import "../common/menu";
import type { Session } from "../state/session";
import { copies } from "../words/numbers";
import type { BuildPart } from "./build_parts";

function lockedOf(session: Session, tray: number, part: number | null): number {
  const { packing } = session.run.state.value;
  const { locks } = session.work.state.value;
  if (!packing || locks.size === 0) return 0;
  return copiesOf(packing, tray, part).filter((copy) => locks.has(trayCopyId(copy))).length;
}

export function lockMark(
  session: Session,
  tray: number,
  part: number,
  placed: number,
): TemplateResult | typeof nothing {
  const locked = lockedOf(session, tray, part);
  if (locked === 0) return nothing;
  const text = locked === placed ? "all locked" : `${locked} locked`;
  return html`<span class="locked small" title=${text}
    >${icon("lock")}${locked === placed ? nothing : locked}<span class="out">${text}</span></span
  >`;
}

function item(name: IconName, text: string, off: boolean, run: () => void): TemplateResult {
  return html`<button type="button" class="mi" role="menuitem" ?disabled=${off} @click=${run}>
    ${icon(name)}<span>${text}</span>
  </button>`;
}

/// The menu of a part's row.
export function partMenu(session: Session, tray: number, part: BuildPart, placed: number): TemplateResult {
  return html`<sp-menu
    class="row-menu"
    label="More of ${part.name}"
    hint="More"
    buttonClasses="btn s ghost icon eye"
    .button=${icon("more")}
    .content=${() => {
      const { packing } = session.run.state.value;
      const own = packing ? copiesOf(packing, tray, part.index) : [];
      const locked = lockedOf(session, tray, part.index);
      return html`${item("lock", `Lock all ${copies(placed)}`, locked === placed, () => session.work.lock(own, true))}
        ${item("unlock", "Unlock all of them", locked === 0, () => session.work.lock(own, false))}
        <hr />
        ${item("trash", `Remove all ${copies(placed)}`, locked === placed, () => session.work.remove(own))}`;
    }}
  ></sp-menu>`;
}

/// The menu of the list: the tray that is shown, or all of them.
export function trayLockMenu(session: Session, tray: number): TemplateResult {
  return html`<sp-menu
    label="Lock the tray"
    hint="Lock the tray"
    buttonClasses="btn s ghost icon"
    .button=${icon("lock")}
    .content=${() => {
      const { packing } = session.run.state.value;
      const own = packing ? copiesOf(packing, tray) : [];
      const locked = lockedOf(session, tray, null);
      const what = (packing?.trays.length ?? 1) > 1 && tray > 0 ? `all of tray ${tray}` : "all copies";
      return html`<p class="menu-head small dim">
          ${locked > 0 ? `${copies(locked)} locked. ` : ""}Locked copies stay where they are when the rest is packed again.
        </p>
        ${item("lock", `Lock ${what}`, locked === own.length, () => session.work.lock(own, true))}
        ${item("unlock", `Unlock ${what}`, locked === 0, () => session.work.lock(own, false))}`;
    }}
  ></sp-menu>`;
}
