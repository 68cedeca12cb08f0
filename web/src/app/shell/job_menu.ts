/// The job's name, and what can be done with the job as a whole. It is renamed in place.

import { html } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { api } from "../../api/client";
import { icon } from "../common/icons";
import "../common/menu";
import { Piece } from "../common/piece";
import { attempt } from "../state/app_state";
import { shortName } from "../state/file_names";
import { deleteLater } from "../state/job_list";
import { copyOf } from "../state/new_job";
import { go } from "../state/route";
import type { Session } from "../state/session";

@customElement("sp-job-menu")
export class JobMenu extends Piece {
  @property({ attribute: false }) session!: Session;
  @state() private renaming = false;
  @query("input") private readonly input!: HTMLInputElement | null;

  protected override stores() {
    return [this.session.run.state];
  }

  override render() {
    const { job } = this.session;
    if (this.renaming) {
      return html`<span class="in rename">
        <input
          aria-label="Name of the job"
          maxlength="100"
          .value=${job.name}
          @blur=${() => this.rename(true)}
          @keydown=${(event: KeyboardEvent) => {
            if (event.key === "Enter") void this.rename(true);
            if (event.key === "Escape") void this.rename(false);
          }}
        />
      </span>`;
    }
    return html`<sp-menu
      label=${`Job: ${job.name}`}
      buttonClasses="btn ghost name"
      .button=${html`<span class="cut">${job.name}</span>${icon("down")}`}
      .content=${() => html`
        <button type="button" class="mi" role="menuitem" @click=${() => this.begin()}>
          ${icon("drawn")}<span>Rename</span>
        </button>
        <button type="button" class="mi" role="menuitem" @click=${() => copyOf(job.id, job.name)}>
          ${icon("copy")}<span>Copy the job</span>
        </button>
        <button
          type="button"
          class="mi danger"
          role="menuitem"
          @click=${() => {
            deleteLater(job);
            go({ page: "start" });
          }}
        >
          ${icon("trash")}<span>Delete the job</span>
        </button>
        <hr />
        <button type="button" class="mi" role="menuitem" @click=${() => go({ page: "start" })}>
          ${icon("list")}<span>All jobs</span>
        </button>
      `}
    ></sp-menu>`;
  }

  private begin(): void {
    this.renaming = true;
    void this.updateComplete.then(() => this.input?.select());
  }

  private async rename(really: boolean): Promise<void> {
    if (!this.renaming) return;
    const name = shortName(this.input?.value ?? "");
    this.renaming = false;
    if (!really || name === "" || name === this.session.job.name) return;
    const job = await attempt(() => api.rename(this.session.id, name));
    if (job) this.session.run.take(job);
  }
}
