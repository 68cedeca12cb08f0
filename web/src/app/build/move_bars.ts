/// What floats over the tray while a copy is moved by hand: what the colours mean, and how it is moved.

import { html, type TemplateResult } from "lit";
import type { CopyKey } from "../../view/view";
import type { MoveState } from "../change/mover";

export function moveLegend(): TemplateResult {
  return html`<div class="glass move-legend">
    <span><i class="you"></i>you move</span><span><i class="close"></i>too close</span
    ><span><i class="stays"></i>stays</span>
  </div>`;
}

export function moveHint(): TemplateResult {
  return html`<div class="glass move-hint">
    <span>Drag an axis<span class="hide-touch">, or</span></span>
    <span class="hide-touch"
      ><kbd>←</kbd> <kbd>→</kbd> <kbd>↑</kbd> <kbd>↓</kbd> <kbd>Page ↑</kbd> <kbd>Page ↓</kbd> by 1&#8239;mm</span
    >
    <span class="hide-touch"><kbd>Shift</kbd> by 10</span>
  </div>`;
}

/// The copies that are lit up: those that are too near, as the server says; before it has answered, those that touch.
export function closeCopies({ clearance, touching }: MoveState): readonly CopyKey[] {
  if (!clearance) return touching;
  const near = [clearance.nearest, clearance.next].filter((own) => own && own.distance < own.gap);
  const said = near.flatMap((own) => (own ? [{ part: own.part, copy: own.copy }] : []));
  // It names two; more may touch.
  return clearance.clear ? [] : [...said, ...touching];
}
