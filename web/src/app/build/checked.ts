/// What the independent check says, on the exact meshes.

import { html, nothing, type TemplateResult } from "lit";
import type { Job } from "../../api/types";
import { type IconName, icon, spinner } from "../common/icons";
import type { Packing } from "../state/packing";
import type { Session } from "../state/session";
import { namedCopies } from "../words/named";
import { counted, mm } from "../words/numbers";
import { sentence } from "../words/sentence";

const most = 8;

export function checkedList(job: Job, packing: Packing): TemplateResult {
  const { verdict } = job;
  if (!verdict) {
    return html`<section class="sec">
      <h3>Checked</h3>
      <p class="dim">Not checked yet.</p>
    </section>`;
  }
  const findings = verdict.findings;
  const outside = findings.some((text) => text.includes("outside"));
  const touch = findings.some((text) => /overlap|gap|nested/.test(text));
  const walls = Number(packing.options["wall-gap"] ?? 0);
  const steps = packing.trays.reduce((sum, tray) => sum + tray.steps, 0);
  const through = packing.trays.reduce((sum, tray) => sum + tray.throughWalls, 0);
  return html`<section class="sec">
    <div class="row between">
      <h3>Checked</h3>
      <span class="small faint">on the exact meshes</span>
    </div>
    <div class="checks">
      ${row(touch ? "bad" : "ok", touch ? "Copies come too near" : "No two copies touch", verdict.min_gap === null ? "" : mm(verdict.min_gap, 2))}
      ${row(outside ? "bad" : "ok", outside ? "A copy sticks out" : "All inside the tray", walls > 0 ? `${mm(walls)} and more` : "")}
      ${
        verdict.apart === "checked"
          ? row("ok", "Comes apart", counted(verdict.steps || steps, "step"))
          : verdict.apart === "no"
            ? row("bad", "Does not come apart", "")
            : row("warn", "Coming apart was not looked at", "")
      }
    </div>
    ${
      verdict.apart === "checked" && through > 0
        ? html`<p class="small dim">${counted(through, "step")} ${through === 1 ? "leads" : "lead"} through the walls: open the tray at a side for ${through === 1 ? "it" : "them"}.</p>`
        : nothing
    }
    ${
      findings.length > 0
        ? html`<ul class="said bad-text">
            ${findings.slice(0, most).map((text) => html`<li>${sentence(namedCopies(text, packing))}</li>`)}
            ${findings.length > most ? html`<li>And ${findings.length - most} more.</li>` : nothing}
          </ul>`
        : nothing
    }
  </section>`;
}

/// While a change by hand is on its way, or is being checked.
export function uncheckedNote(session: Session): TemplateResult {
  const checking = session.run.checking;
  return html`<section class="sec">
    <h3>${checking ? "Checking" : "Not checked"}</h3>
    <div class="checks" role="status">
      <div class=${checking ? "run" : "warn"}>
        ${checking ? spinner : icon("warn")}<span
          >${checking ? "Every gap is measured, and the plan to take it apart is made anew." : "The build was changed. It is checked next."}</span
        ><span></span>
      </div>
    </div>
  </section>`;
}

const icons: Readonly<Record<"ok" | "warn" | "bad", IconName>> = { ok: "check", warn: "warn", bad: "bad" };

function row(tone: "ok" | "warn" | "bad", text: string, value: string): TemplateResult {
  return html`<div class=${tone}>${icon(icons[tone])}<span>${text}</span><span class="faint">${value}</span></div>`;
}
