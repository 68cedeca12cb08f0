/// Where one begins: bring parts on the left, go on with earlier jobs on the right.

import { html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { Piece } from "../common/piece";
import { app } from "../state/app_state";
import { interrupted, jobList, watchJobs } from "../state/job_list";
import { filesStay } from "../words/here";
import "./drop_zone";
import { interruptedCard } from "./interrupted_card";
import "./recent_jobs";

@customElement("sp-start")
export class StartPage extends Piece {
  private stop: (() => void) | null = null;

  protected override stores() {
    return [app, jobList];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.stop = watchJobs();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stop?.();
  }

  override render() {
    const broken = interrupted(jobList.value)[0];
    return html`<main class="start">
      <section class="begin" aria-labelledby="new-build">
        <h1 id="new-build">New build</h1>
        <p class="dim lead">Bring the parts, choose the printer, press Pack. ${filesStay(location.hostname)}</p>
        ${broken ? interruptedCard(broken) : nothing}
        <sp-drop ?second=${broken !== undefined}></sp-drop>
      </section>
      <sp-recent></sp-recent>
    </main>`;
  }
}
