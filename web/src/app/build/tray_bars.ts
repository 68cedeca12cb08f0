/// What floats over the tray: the newest copy, the colouring and its legend, where to look from, hide and show, section.

import { html, nothing, type TemplateResult } from "lit";
import { partColour } from "../../view/palette";
import type { Axis, Section, Side, TrayView } from "../../view/view";
import { iconButton, picture, segments } from "../common/bits";
import { icon } from "../common/icons";
import "../common/menu";
import type { ValueEvent } from "../common/number_field";
import "../common/number_field";
import { styles } from "../common/styles";
import { app } from "../state/app_state";
import { anyHidden, colourings, hideSelected, isolateSelected, showAll } from "../state/build_view";
import type { Session } from "../state/session";
import { thin } from "../words/numbers";
import type { BuildPart } from "./build_parts";
import { newSection, sectionEnd } from "./sections";

export type Legend = ReturnType<TrayView["legend"]>;

export function justPlaced(session: Session, parts: readonly BuildPart[]): TemplateResult | typeof nothing {
  const newest = session.run.live.newest;
  const part = parts.find((own) => own.index === newest?.copy.part);
  if (!newest || !part) return nothing;
  const shot = part.mesh ? session.meshes.picture(part.mesh, partColour(part.index), app.value.theme) : null;
  return html`<div class="glass placed">
    ${picture(shot)}
    <span><span class="small dim">Just placed</span><b class="cut">${part.name} ${newest.copy.copy + 1}</b></span>
  </div>`;
}

export function colourBar(session: Session, legend: Legend): TemplateResult {
  const { build } = session;
  const { colouring } = build.value;
  return html`<div class="stack">
    <div class="glass">
      <span class="lab hide-s">Colour by</span>
      ${segments("Colour by", colourings, colouring, (value) => build.set({ colouring: value }), "s flat")}
    </div>
    ${legend && colouring !== "part" ? legendBar(legend, colouring === "height" ? `${thin}mm` : "") : nothing}
  </div>`;
}

function legendBar(legend: NonNullable<Legend>, unit: string): TemplateResult {
  return html`<div class="glass legend" role="img" aria-label="Legend: ${legend.values.map(Math.round).join(", ")}${unit}">
    <i ${styles({ background: `linear-gradient(90deg, ${legend.colours.join(", ")})` })}></i>
    <span class="row between">${legend.values.map((value) => html`<span>${Math.round(value)}${unit}</span>`)}</span>
  </div>`;
}

const sides: readonly { readonly side: Side; readonly text: string }[] = [
  { side: "home", text: "All of it, from the corner" },
  { side: "front", text: "From the front" },
  { side: "back", text: "From the back" },
  { side: "left", text: "From the left" },
  { side: "right", text: "From the right" },
  { side: "top", text: "From above" },
];

export function lookMenu(look: (side: Side) => void): TemplateResult {
  return html`<sp-menu
    label="Look from"
    hint="Look from"
    buttonClasses="btn ghost icon float"
    .button=${icon("box")}
    .content=${() =>
      html`${sides.map(
        ({ side, text }) =>
          html`<button type="button" class="mi plain" role="menuitem" @click=${() => look(side)}>
            <span>${text}</span>
          </button>`,
      )}`}
  ></sp-menu>`;
}

export function hideMenu(session: Session): TemplateResult {
  const { build } = session;
  const { selected, isolated } = build.value;
  const some = selected.length > 0;
  const hidden = anyHidden(build.value);
  const item = (text: string, key: string, off: boolean, run: () => void) =>
    html`<button type="button" class="mi plain" role="menuitem" ?disabled=${off} @click=${run}>
      <span>${text}</span><kbd>${key}</kbd>
    </button>`;
  const isolate = isolated ? "Show the others again" : "Show only what is selected";
  return html`<sp-menu
    label="Hide and show"
    hint="Hide and show"
    buttonClasses="btn ghost icon float ${hidden ? "on" : ""}"
    .button=${icon(hidden ? "eyeOff" : "eye")}
    .content=${() => html`
      ${item("Hide what is selected", "H", !some, () => build.set(hideSelected(build.value)))}
      ${item(isolate, "I", !some && !isolated, () => build.set(isolateSelected(build.value)))}
      ${item("Show all", "Shift H", !hidden, () => build.set(showAll))}
    `}
  ></sp-menu>`;
}

export function sectionBar(session: Session): TemplateResult {
  const { build } = session;
  const { section } = build.value;
  const pick = (axis: Axis | null) => build.set({ section: axis === null ? null : newSection(session, axis, section) });
  return html`<div class="glass">
    <span class="lab hide-s">Section</span>
    ${segments<Axis | null>(
      "Section",
      [
        { value: null, text: "Off" },
        { value: "x", text: "X" },
        { value: "y", text: "Y" },
        { value: "z", text: "Z" },
      ],
      section?.axis ?? null,
      pick,
      "s flat",
    )}
    ${section ? sectionFields(session, section) : nothing}
  </div>`;
}

function sectionFields(session: Session, section: Section): TemplateResult {
  const change = (next: Partial<Section>) => session.build.set({ section: { ...section, ...next } });
  return html`<sp-number
      label=${`Section at ${section.axis.toUpperCase()}`}
      unit="mm"
      classes="s at"
      .value=${section.at}
      .least=${0}
      .most=${sectionEnd(session, section.axis)}
      .places=${1}
      .digits=${1}
      @value=${(event: ValueEvent) => change({ at: event.detail ?? 0 })}
    ></sp-number>
    ${iconButton("flip", "Other side (B)", () => change({ flipped: !section.flipped }), "s hide-s")}`;
}
