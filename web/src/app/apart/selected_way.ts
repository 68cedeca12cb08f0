/// The selected copy: when it leaves, what has to leave before it, and a button to see it go.

import { html, nothing, type TemplateResult } from "lit";
import { partColour } from "../../view/palette";
import { iconButton, picture } from "../common/bits";
import { icon, spinner } from "../common/icons";
import type { Candidate } from "../state/apart_blockers";
import { nextStep } from "../state/apart_plan";
import { playerOf } from "../state/apart_player";
import { app } from "../state/app_state";
import type { Placement } from "../state/packing";
import type { Session } from "../state/session";
import { count } from "../words/numbers";
import { type Apart, select } from "./apart";

/// More in a list are counted, not named.
const most = 40;

export function selectedWay(session: Session, apart: Apart, selected: Placement): TemplateResult {
  const { step } = playerOf(session).state.value;
  const out = apart.plan.outAt[selected.index] ?? Number.POSITIVE_INFINITY;
  const part = apart.partOf(selected.index);
  const shot = part?.mesh ? session.meshes.picture(part.mesh, partColour(part.index), app.value.theme) : null;
  const name = apart.nameOf(selected.index);
  return html`<section class="sec" aria-label="Selected copy">
    <div class="row gap">
      ${picture(shot, "th large")}
      <div class="grow cut">
        <h2 class="cut" title=${name}>${name}</h2>
        <div class="small dim">selected · ${whenWords(session, apart, selected)}</div>
      </div>
      ${iconButton("close", "Let go (Esc)", () => select(session, null), "s")}
    </div>
    ${out >= step && Number.isFinite(out) ? toCome(session, apart, selected, out) : nothing}
  </section>`;
}

function whenWords(session: Session, apart: Apart, selected: Placement): TemplateResult | string {
  const { plan } = apart;
  const { step } = playerOf(session).state.value;
  const out = plan.outAt[selected.index] ?? Number.POSITIVE_INFINITY;
  if (selected.fixed && !Number.isFinite(out)) return "fixed: it stays where it is";
  const next = nextStep(plan, selected.index, step);
  if (!next) return Number.isFinite(out) ? html`left at ${stepLink(session, out)}` : "the plan has no way out for it";
  if (next.makes !== null) return html`leaves in a group at ${stepLink(session, next.index)}`;
  const outside = (plan.assemblies[next.from]?.madeBy ?? -1) >= 0;
  return html`${outside ? "parted from its group at" : "leaves at"} ${stepLink(session, next.index)}`;
}

function stepLink(session: Session, index: number): TemplateResult {
  return html`<button type="button" class="link" @click=${() => playerOf(session).seek(index)}>step ${count(index + 1)}</button>`;
}

/// What has to happen before it is out.
function toCome(session: Session, apart: Apart, selected: Placement, out: number): TemplateResult {
  const player = playerOf(session);
  const { step } = player.state.value;
  const play = html`<button type="button" class="btn fill" @click=${() => player.play(out + 1)}>
    Play until it is out
  </button>`;
  if (apart.plan.steps[step]?.placements.includes(selected.index)) return play;
  const { found } = apart.ways.state.value;
  if (!found) return html`<p class="row dim gap">${spinner}Looking for what is in its way …</p>${play}`;
  const still = found.filter((own) => own.step >= step);
  if (still.length === 0) {
    return html`<p class="row dim gap"><span class="ok-text">${icon("check")}</span>Nothing is in its way now.</p>${play}`;
  }
  const text =
    still.length === 1
      ? "One copy stands in its way. It leaves first."
      : `${numberWord(still.length)} copies stand in its way. They leave first.`;
  return html`<div class="note warn gap">${icon("warn")}<p>${text}</p></div>
    ${play}
    <ul class="flush blockers" aria-label="In its way">
      ${still.slice(0, most).map((own) => blocker(session, apart, own))}
      ${still.length > most ? html`<li class="small dim more">And ${count(still.length - most)} more.</li>` : nothing}
    </ul>`;
}

function blocker(session: Session, apart: Apart, own: Candidate): TemplateResult {
  const part = apart.partOf(own.placement);
  const shot = part?.mesh ? session.meshes.picture(part.mesh, partColour(part.index), app.value.theme) : null;
  const name = apart.nameOf(own.placement);
  return html`<li class="li">
    <button
      type="button"
      class="whole"
      aria-label="Select ${name}"
      @click=${() => select(session, apart.tray.placements[own.placement] ?? null)}
    ></button>
    ${picture(shot)}<span class="cut">${name}</span><span class="over">${stepLink(session, own.step)}</span>
  </li>`;
}

const words = ["No", "One", "Two", "Three", "Four", "Five", "Six", "Seven", "Eight", "Nine", "Ten"];
const numberWord = (value: number): string => words[value] ?? count(value);
