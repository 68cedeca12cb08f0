/// What can be done to the copies that are selected: lock, move, remove.

import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../common/icons";
import type { Session } from "../state/session";
import { copies } from "../words/numbers";
import { beginMove, selectedCopies } from "./change_keys";

export function copyButtons(session: Session): TemplateResult | typeof nothing {
  const { work } = session;
  const own = selectedCopies(session);
  if (own.length === 0) return nothing;
  const locked = own.filter((copy) => work.isLocked(copy)).length;
  const all = locked === own.length;
  const held = all ? "Locked: unlock it first (L)" : "";
  const free = own.length - locked;
  return html`<div class="acts">
      <button
        type="button"
        class="btn"
        aria-pressed=${all}
        title=${all ? "Unlock (L)" : "Lock: it stays where it is when the rest is packed again (L)"}
        @click=${() => work.toggleLock(own)}
      >
        ${icon(all ? "lock" : "unlock")}${all ? "Locked" : html`Lock<kbd class="hide-s">L</kbd>`}
      </button>
      ${
        own.length === 1
          ? html`<button
              type="button"
              class="btn"
              ?disabled=${all}
              title=${held || "Move (M)"}
              @click=${() => beginMove(session)}
            >
              ${icon("move")}Move
            </button>`
          : nothing
      }
      <button
        type="button"
        class="btn danger"
        ?disabled=${all}
        title=${held || "Remove: take it out of the build (Del)"}
        @click=${() => work.remove(own)}
      >
        ${icon("trash")}${own.length > 1 && free > 0 ? `Remove ${free}` : "Remove"}
      </button>
    </div>
    ${
      locked > 0
        ? html`<p class="small faint lock-words">
            ${
              own.length === 1
                ? "It stays where it is when the rest is packed again."
                : all
                  ? "They stay where they are when the rest is packed again."
                  : `${copies(locked)} of them ${locked === 1 ? "is" : "are"} locked.`
            }
          </p>`
        : nothing
    }`;
}
