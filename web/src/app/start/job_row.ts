/// One job of the list: its picture, what it is and how it stands, and what can be done with it.

import { html, type TemplateResult } from "lit";
import { pictureUrl } from "../../api/client";
import type { Job } from "../../api/types";
import { badge, iconButton, picture } from "../common/bits";
import { deleteLater } from "../state/job_list";
import { copyOf } from "../state/new_job";
import { hashOf } from "../state/route";
import { isRunning } from "../state/runner";
import { figures, place, stateWords } from "../words/jobs";
import { ago } from "../words/times";

export function jobRow(job: Job, now: Date): TemplateResult {
  const state = stateWords(job);
  const step = job.has_packing || isRunning(job) || job.status === "failed" ? "build" : "parts";
  const when = isRunning(job) ? "now" : ago(new Date(job.changed), now);
  return html`<li class="job">
    <a class="whole" href=${hashOf({ page: "job", id: job.id, step })} aria-label=${`Open ${job.name}`}></a>
    <span class="pic">${picture(job.has_picture ? pictureUrl(job.id) : null, "shot")}</span>
    <div class="cut">
      <div class="b cut">${job.name}</div>
      <div class="dim small cut">${place(job)}</div>
      <div class="faint small cut">${figures(job)}</div>
    </div>
    <div class="num">
      ${badge(state.tone, state.text)}
      <div class="faint small when">${when}</div>
      <div class="acts">
        <a class="btn s ghost accent" href=${hashOf({ page: "job", id: job.id, step })} aria-label=${`Open ${job.name}`}>
          Open
        </a>
        ${iconButton("copy", `Copy ${job.name}`, () => copyOf(job.id, job.name), "s")}
        ${iconButton("trash", `Delete ${job.name}`, () => deleteLater(job), "s")}
      </div>
    </div>
  </li>`;
}
