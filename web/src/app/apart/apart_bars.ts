/// What floats over the tray as it comes apart: what is shown, where to look from, and what the colours mean.

import { html, nothing, type TemplateResult } from "lit";
import { partColour } from "../../view/palette";
import type { Side } from "../../view/view";
import { hideMenu, lookMenu } from "../build/tray_bars";
import { iconButton, segments } from "../common/bits";
import { styles } from "../common/styles";
import { type Player, type PlayerState, shownStep } from "../state/apart_player";
import { app } from "../state/app_state";
import type { Placement } from "../state/packing";
import type { Session } from "../state/session";
import type { Apart } from "./apart";

export function showBar(player: Player): TemplateResult {
  return html`<div class="glass">
    <span class="lab hide-s">Show</span>
    ${segments<PlayerState["show"]>(
      "Show",
      [
        { value: "left", text: "What is left" },
        { value: "apart", text: "All, drawn apart" },
      ],
      player.state.value.show,
      (show) => player.setShow(show),
      "s flat words",
    )}
  </div>`;
}

export function lookBar(session: Session, look: (side: Side) => void, frame: () => void): TemplateResult {
  const { build } = session;
  const { find } = build.value;
  return html`<div class="glass">
    ${iconButton("frame", "Frame all (Shift+F)", frame, "float")} ${lookMenu(look)} ${hideMenu(session)}
    ${iconButton("find", "Find a copy or part (/)", () => build.set({ find: find === null ? "" : null }), "float")}
  </div>`;
}

/// Only what is in the picture is explained.
export function legend(
  apart: Apart,
  player: PlayerState,
  selected: Placement | null,
  blocked: boolean,
): TemplateResult | typeof nothing {
  const { tray } = apart;
  const step = shownStep(player);
  const first = step ? tray.placements[step.placements[0] ?? -1] : undefined;
  const all = player.show === "apart";
  const entries = [
    step && first
      ? entry(partColour(first.part, app.value.theme), step.makes === null ? "leaves now" : "leave together", true)
      : nothing,
    selected && !step?.placements.includes(selected.index) ? entry("var(--select)", "selected", true) : nothing,
    blocked ? entry("var(--warn-mark)", "in its way") : nothing,
    all || !step || player.alone !== null ? nothing : entry("var(--stay)", "stays"),
    (player.faint || all) && player.step > 0 ? entry("var(--stay)", "has left", false, "faint-mark") : nothing,
  ].filter((one) => one !== nothing);
  return entries.length > 0 ? html`<div class="glass keys-bar">${entries}</div>` : nothing;
}

function entry(colour: string, text: string, outlined = false, classes = ""): TemplateResult {
  return html`<span><i class="${outlined ? "outlined" : ""} ${classes}" ${styles({ background: colour })}></i>${text}</span>`;
}

/// While only a group is shown.
export function aloneBar(apart: Apart, player: Player, alone: number): TemplateResult {
  const members = apart.plan.assemblies[alone]?.members.length ?? 0;
  return html`<div class="hud bc">
    <div class="glass alone-bar">
      <span class="lab">Only the group of ${members}</span>
      <button type="button" class="btn s" @click=${() => player.playAlone(null)}>Show all again</button>
    </div>
  </div>`;
}
