/// In place of a build that is not there: it is loaded, or nothing came of the run.

import { html, nothing, type TemplateResult } from "lit";
import { spinner } from "../common/icons";
import { go } from "../state/route";
import type { Session } from "../state/session";
import { sentence } from "../words/sentence";

export function nothingThere(session: Session): TemplateResult {
  const { job, loading, problem } = session.run.state.value;
  if (loading || (job.has_packing && !problem)) {
    return html`<main class="empty" aria-busy="true"><p class="dim row">${spinner}Opening the build …</p></main>`;
  }
  const texts: Readonly<Record<string, readonly [string, string]>> = {
    failed: ["The run failed", job.error ? sentence(job.error) : "Nothing is said of why."],
    cancelled: ["Stopped", "Nothing was placed by then."],
    interrupted: ["Interrupted", "The computer or the program stopped before anything was placed."],
  };
  const [title, text] = texts[job.status] ?? ["No build yet", problem ?? "Press Pack on the Parts step."];
  return html`<main class="empty">
    <h2>${title}</h2>
    <p class="dim">${text}</p>
    <div class="row">
      ${
        job.status === "interrupted" || job.status === "cancelled"
          ? html`<button type="button" class="btn primary" @click=${() => session.goOn()}>Continue packing</button>`
          : nothing
      }
      <button
        type="button"
        class="btn ${job.status === "failed" ? "primary" : ""}"
        @click=${() => go({ page: "job", id: session.id, step: "parts" })}
      >
        To the parts
      </button>
      ${
        job.status === "failed"
          ? html`<button type="button" class="btn" @click=${() => session.pack()}>Pack again</button>`
          : nothing
      }
    </div>
  </main>`;
}
