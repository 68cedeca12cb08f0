/// The jobs of this server, newest first.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, query } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { icon } from "../common/icons";
import { Piece } from "../common/piece";
import { findJobs, jobList, showAllJobs } from "../state/job_list";
import { onThere } from "../words/here";
import { bytes, counted } from "../words/numbers";
import { jobRow } from "./job_row";

@customElement("sp-recent")
export class RecentJobs extends Piece {
  @query("input") private readonly input!: HTMLInputElement | null;

  protected override stores() {
    return [jobList];
  }

  override render() {
    const { jobs, total, bytes: size, find, all, going } = jobList.value;
    const shown = (jobs ?? []).filter((job) => !going.has(job.id));
    return html`<section class="recent" aria-labelledby="recent-jobs">
      <div class="row between">
        <h2 id="recent-jobs">Recent jobs</h2>
        ${find === null ? this.findButton(total) : this.findField(find)}
      </div>
      <p class="dim lead">
        ${jobs === null ? "Looking for jobs …" : total === 0 ? "No jobs yet." : this.summary(total, size)}
      </p>
      ${shown.length > 0 ? this.list(shown) : this.none(find, total)}
      <div class="row between foot">
        ${
          find === null && total > shown.length && !all
            ? html`<button type="button" class="link small" @click=${() => showAllJobs(true)}>
                Show all ${counted(total, "job")}
              </button>`
            : find === null && all
              ? html`<button type="button" class="link small" @click=${() => showAllJobs(false)}>Show the newest</button>`
              : html`<span></span>`
        }
        ${total > 0 ? html`<span class="faint small">Jobs go on when this page is closed.</span>` : nothing}
      </div>
    </section>`;
  }

  private summary(total: number, size: number): string {
    return `${counted(total, "job")} ${onThere(location.hostname)}, ${bytes(size)}.`;
  }

  private list(shown: Parameters<typeof jobRow>[0][]): TemplateResult {
    const now = new Date();
    return html`<ul class="card jobs" role="list">
      ${repeat(
        shown,
        (job) => job.id,
        (job) => jobRow(job, now),
      )}
    </ul>`;
  }

  private none(find: string | null, total: number): TemplateResult | typeof nothing {
    if (find !== null && find !== "" && jobList.value.jobs)
      return html`<p class="none dim">No job has “${find}” in its name.</p>`;
    if (total > 0 || jobList.value.jobs === null) return nothing;
    return html`<p class="none dim">What you pack is kept here, with its parts and settings, until you delete it.</p>`;
  }

  private findButton(total: number): TemplateResult | typeof nothing {
    if (total < 2) return nothing;
    return html`<button
      type="button"
      class="btn s ghost"
      @click=${() => {
        findJobs("");
        void this.updateComplete.then(() => this.input?.focus());
      }}
    >
      ${icon("find")}Find
    </button>`;
  }

  private findField(find: string): TemplateResult {
    return html`<span class="in s find">
      ${icon("find")}
      <input
        type="search"
        aria-label="Find a job by its name"
        placeholder="Part of the name"
        .value=${find}
        @input=${(event: Event) => findJobs((event.target as HTMLInputElement).value)}
        @keydown=${(event: KeyboardEvent) => {
          if (event.key === "Escape") findJobs(null);
        }}
        @blur=${() => {
          if (find === "") findJobs(null);
        }}
      />
    </span>`;
  }
}
