/// A row of the list of steps.

import { html, nothing, type TemplateResult } from "lit";
import { partColour } from "../../view/palette";
import { picture } from "../common/bits";
import { type IconName, icon } from "../common/icons";
import type { PlanStep } from "../state/apart_plan";
import { playerOf } from "../state/apart_player";
import type { Row } from "../state/apart_rows";
import { app } from "../state/app_state";
import type { Session } from "../state/session";
import { type Way, wayOf } from "../words/moves";
import { copies, count } from "../words/numbers";
import { type Apart, select } from "./apart";
import { moveWords, stepName } from "./sentences";

export interface RowShown {
  readonly session: Session;
  readonly apart: Apart;
  readonly row: Row;
  /// The step that runs, from 0 on.
  readonly step: number;
  readonly selected: number | null;
}

const wayIcons: Readonly<Record<Way, IconName>> = {
  up: "goUp",
  down: "goDown",
  left: "goLeft",
  right: "goRight",
  back: "goBack",
  front: "goFront",
  slant: "goBack",
  bend: "goBend",
  none: "check",
};

export function stepRow(shown: RowShown): TemplateResult {
  const { row } = shown;
  switch (row.kind) {
    case "step":
      return oneStep(shown, row.step, row.depth, row.last);
    case "group":
      return groupHead(shown, row.step, row.depth);
    case "member":
      return copyRow(shown, row.placement, `${inner(row.depth)}${row.last ? " last" : ""}`);
    case "stays":
      return copyRow(shown, row.placement, "");
    default:
      return html`<div class="stp caption" role="listitem"><span>${copies(row.count)} without a way out</span></div>`;
  }
}

function oneStep(shown: RowShown, index: number, depth: number, last: boolean): TemplateResult {
  const { apart } = shown;
  const own = apart.plan.steps[index];
  const placement = own?.placements[0];
  if (!own || placement === undefined) return html``;
  const name = apart.nameOf(placement);
  return html`<div
    class="stp ${state(shown, index)} ${inner(depth)} ${last ? "last" : ""} ${placement === shown.selected ? "chosen" : ""}"
    role="listitem"
    aria-current=${index === shown.step ? "step" : nothing}
  >
    ${whole(shown, own)}<span class="n">${count(index + 1)}</span>${shot(shown, placement)}
    <span class="cut" title=${name}>${name}</span>${move(own)}
  </div>`;
}

function groupHead(shown: RowShown, index: number, depth: number): TemplateResult {
  const own = shown.apart.plan.steps[index];
  if (!own) return html``;
  return html`<div
    class="stp grp ${state(shown, index)} ${inner(depth)}"
    role="listitem"
    aria-current=${index === shown.step ? "step" : nothing}
  >
    ${whole(shown, own)}<span class="n">${count(index + 1)}</span>
    <span class="cut">Group of ${own.placements.length}</span>${move(own)}
  </div>`;
}

/// A copy without a step here: it is selected with a click.
function copyRow(shown: RowShown, placement: number, classes: string): TemplateResult {
  const { apart, session } = shown;
  const own = apart.tray.placements[placement];
  const out = apart.plan.outAt[placement] ?? Number.POSITIVE_INFINITY;
  const name = apart.nameOf(placement);
  const text = Number.isFinite(out) ? `step ${count(out + 1)}` : own?.fixed ? "fixed" : "stays";
  return html`<div class="stp ${classes} ${placement === shown.selected ? "chosen" : ""}" role="listitem">
    <button type="button" class="whole" aria-label="Select ${name}" @click=${() => select(session, own ?? null)}></button>
    <span class="n"></span>${shot(shown, placement)}<span class="cut" title=${name}>${name}</span>
    <span class="mv">${text}</span>
  </div>`;
}

const inner = (depth: number): string => (depth > 1 ? "inner deep" : depth > 0 ? "inner" : "");

const state = ({ step }: RowShown, index: number): string => (index < step ? "past" : index === step ? "now" : "");

function whole({ apart, session }: RowShown, own: PlanStep): TemplateResult {
  const walls = own.throughWalls ? ", through the walls" : "";
  return html`<button
    type="button"
    class="whole"
    aria-label="Step ${own.index + 1}: ${stepName(apart, own)}, ${moveWords(own)}${walls}"
    title=${own.throughWalls ? "Leads through the walls" : nothing}
    @click=${() => playerOf(session).seek(own.index)}
  ></button>`;
}

function move(own: PlanStep): TemplateResult {
  const way = wayOf(own.path);
  return html`<span class="mv ${own.throughWalls ? "walls" : ""}" title=${moveWords(own)}>
    ${icon(own.throughWalls ? "warn" : wayIcons[way])}${way === "none" ? "" : count(own.length)}
  </span>`;
}

function shot({ apart, session }: RowShown, placement: number): TemplateResult {
  const part = apart.partOf(placement);
  return picture(part?.mesh ? session.meshes.picture(part.mesh, partColour(part.index), app.value.theme) : null);
}
