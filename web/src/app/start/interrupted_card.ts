/// A job that was cut off, and how to go on with it.

import { html, nothing, type TemplateResult } from "lit";
import { api, pictureUrl } from "../../api/client";
import type { Job } from "../../api/types";
import { badge, picture } from "../common/bits";
import { attempt } from "../state/app_state";
import { dismiss } from "../state/job_list";
import { go } from "../state/route";
import { figures, interruptedText, verdictWords } from "../words/jobs";

export function interruptedCard(job: Job): TemplateResult {
  const verdict = verdictWords(job);
  const saved = job.has_packing
    ? "Nothing is lost: the best packing so far is saved."
    : "Nothing was placed by then. It goes on from where it was.";
  return html`<article class="card interrupted" aria-label="Interrupted job">
    <span class="pic">${picture(job.has_picture ? pictureUrl(job.id) : null, "shot")}</span>
    <div>
      <div class="row between">
        <h2 class="cut">“${job.name}” was interrupted</h2>
        ${badge("warn", interruptedText(job))}
      </div>
      <p class="dim">The computer or the program stopped while it was packing. ${saved}</p>
      ${
        job.has_packing
          ? html`<p>
              ${figures(job)}${
                verdict?.tone === "ok" ? html` · <span class="ok-text">comes apart: checked</span>` : nothing
              }
            </p>`
          : nothing
      }
      <div class="row">
        <button type="button" class="btn primary" @click=${() => goOn(job)}>Continue packing</button>
        ${
          job.has_packing
            ? html`<a class="btn" href=${`#/job/${job.id}/build`}>Open what is there</a>`
            : html`<a class="btn" href=${`#/job/${job.id}/parts`}>Open the parts</a>`
        }
        <button type="button" class="btn ghost" @click=${() => dismiss(job)}>Dismiss</button>
      </div>
    </div>
  </article>`;
}

async function goOn(job: Job): Promise<void> {
  const started = await attempt(() => api.start(job.id));
  if (started) go({ page: "job", id: job.id, step: "build" });
}
