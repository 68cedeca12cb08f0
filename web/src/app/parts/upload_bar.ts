/// Files on their way, and files that are read: how many, and a button to stop.

import { html, nothing, type TemplateResult } from "lit";
import { bar } from "../common/bits";
import type { Session } from "../state/session";
import { bytes, counted } from "../words/numbers";

export function uploadBar(session: Session): TemplateResult | typeof nothing {
  const { active, total, done, sent, bytes: all } = session.uploads.state.value;
  const { reading } = session.parts;
  const { problem } = session.source.state.value;
  if (active) {
    return html`<div class="loading" role="status">
      <div class="row between">
        <span><b>Sending</b> ${done} of ${counted(total, "file")} · ${bytes(sent)} of ${bytes(all)}</span>
        <button type="button" class="btn s" @click=${() => session.uploads.stop()}>Stop</button>
      </div>
      ${bar(all > 0 ? sent / all : 0, "Sent")}
    </div>`;
  }
  if (reading > 0) {
    return html`<div class="loading" role="status"><b>Reading</b> ${counted(reading, "file")} …</div>`;
  }
  return problem ? html`<div class="loading bad-text" role="alert">${problem}</div>` : nothing;
}
