/// The bar at the top: job and state, the steps, undo and redo, theme, help, verdict and export.

import { html, nothing, type TemplateResult } from "lit";
import { customElement } from "lit/decorators.js";
import { shownVerdict } from "../change/verdict";
import { badge, iconButton } from "../common/bits";
import { mark } from "../common/icons";
import { Piece } from "../common/piece";
import { app } from "../state/app_state";
import { open } from "../state/open_job";
import { hashOf, type Step } from "../state/route";
import { isRunning } from "../state/runner";
import type { Session } from "../state/session";
import { stateWords } from "../words/jobs";
import "./export_menu";
import "./job_menu";
import { themeMenu } from "./theme_menu";
import { undoButtons } from "./undo_buttons";

@customElement("sp-top-bar")
export class TopBar extends Piece {
  private get session(): Session | null {
    const { route } = app.value;
    const session = open.value.session;
    return route.page === "job" && session?.id === route.id ? session : null;
  }

  protected override stores() {
    const session = this.session;
    if (!session) return [app, open];
    return [app, open, session.state, session.run.state, session.work.state, session.work.move.state];
  }

  override render() {
    const session = this.session;
    const { route } = app.value;
    const step = route.page === "job" ? route.step : null;
    return html`<header class="top">
      <div class="row first">
        <a class="brand" href="#/" aria-label="spectralpack: all jobs">${mark}<span class="hide-s">spectralpack</span></a>
        ${
          session
            ? html`<span class="rule"></span><sp-job-menu .session=${session}></sp-job-menu>${this.state(session)}`
            : nothing
        }
      </div>
      ${session && step ? this.steps(session, step) : html`<span></span>`}
      <div class="row last">
        ${session && (step === "parts" || step === "build") ? undoButtons(session, step) : nothing} ${themeMenu()}
        ${iconButton("help", "Help and keys (?)", () => app.set({ dialog: "help" }))}
        ${session && step && step !== "parts" ? this.result(session) : nothing}
      </div>
    </header>`;
  }

  private state(session: Session): TemplateResult | typeof nothing {
    const shown = app.value.route.page === "job" && app.value.route.step !== "parts" && session.run.checking;
    if (!isRunning(session.job) || shown) return nothing;
    const improves = session.job.status === "running" && session.run.doing === "improve";
    return badge("run", improves ? "Improving" : stateWords(session.job).text);
  }

  private steps(session: Session, step: Step): TemplateResult {
    const packed = session.job.status !== "new" || session.job.has_packing;
    const apart = session.run.state.value.packing?.trays.some((tray) => tray.steps > 0) ?? false;
    const missing = packed && !isRunning(session.job) ? "This build has no plan to take it apart" : "Press Pack first";
    const tab = (own: Step, text: string, there: boolean, why = "Press Pack first") =>
      there
        ? html`<a
            class="tab"
            href=${hashOf({ page: "job", id: session.id, step: own })}
            aria-current=${step === own ? "step" : nothing}
            >${text}</a
          >`
        : html`<span class="tab" aria-disabled="true" title=${why}>${text}</span>`;
    return html`<nav class="tabs" aria-label="Steps">
      ${tab("parts", "Parts", true)}${tab("build", "Build", packed)}${tab("apart", "Take apart", apart, missing)}
    </nav>`;
  }

  private result(session: Session): TemplateResult | typeof nothing {
    if (session.run.packs || !session.run.state.value.packing) return nothing;
    const verdict = shownVerdict(session);
    // In full, and where there is less room.
    const long = verdict?.tone === "ok" ? "Comes apart: checked" : verdict?.text;
    const short = verdict?.tone === "ok" ? "Checked" : verdict?.text.replace("Changed: not", "Not");
    return html`<span class="rule hide-s"></span>
      ${
        verdict
          ? badge(verdict.tone, html`<span class="hide-s">${long}</span><span class="show-s">${short}</span>`)
          : nothing
      }
      <sp-export .session=${session}></sp-export>`;
  }
}
